"""One run of the committed study made again in a folder of its own; writes how alike it came out.

Each binary has a folder of its own: what is checked is the one at hand.
"""

import hashlib
import json
from pathlib import Path

import pandas as pd
from study.analysis.arguments import required_arguments
from study.analysis.passages import row_of
from study.analysis.runs import Run
from study.analysis.solve import solved
from study.analysis.spot_check import compared, texts
from study.paper.claim_runs import NUMBERS, case_of_run, judged, numbers_in, numbers_of
from study.planning.documents import read_json


def passage(committed, run):
    """A passage beside its row."""
    remade = texts(row_of(run))
    verdict, columns = compared(committed, remade)
    return {"verdict": verdict, "columns": columns, "row": committed, "remade": remade}


def another(run, folder, own):
    """Another run beside its rows in the table of its scene, or beside the study's own run."""
    scene = run.case["scene"]
    name = NUMBERS[scene][0]
    rows = pd.read_csv(Path(folder) / f"{name}.csv", dtype=str, keep_default_na=False)
    before = numbers_in(rows, run.id, scene)
    if not before and (Path(own) / run.id / "summary.json").exists():
        before = numbers_of(read_json(Path(own) / run.id / "summary.json"), scene)
    after = numbers_of(run.summary, scene)
    verdict, names = judged(before, after) if before else ("nothing to compare with", [])
    kept = {"sweep": scene, "run": run.id, "dx_um": run.dx_um, "row_shift_um": run.row_shift_um}
    row = dict.fromkeys(["capillary_number", "class", "d_perp_um"], "") | kept | before
    after |= {"class": run.summary["status"], "d_perp_um": ""}
    return {"verdict": verdict, "columns": names, "row": row, "remade": after}


arguments = required_arguments(__doc__, "plan", "tables", "run", "runs", "own", "dld", "runner", "output")
plan = read_json(arguments.plan)
passages = pd.read_csv(Path(arguments.tables) / "passages.csv", dtype=str, keep_default_na=False)
case = case_of_run(arguments.run, passages, plan)
runs = Path(arguments.runs) / hashlib.sha256(Path(arguments.dld).read_bytes()).hexdigest()[:12]
solved(case, plan["solver_model"], runs, arguments.runner, arguments.dld)
committed = passages[passages.run == arguments.run]
labels = committed.iloc[0][["sweep", "device", "cell"]].to_dict() if len(committed) else {}
run = Run(arguments.run, "", labels, case, runs / arguments.run)
result = (
    passage(committed.iloc[0].to_dict(), run)
    if len(committed)
    else another(run, arguments.tables, arguments.own)
)
Path(arguments.output).write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
