"""One passage of the committed study made again in a folder of its own; writes how alike it came out.

Each binary has a folder of its own: what is checked is the one at hand.
"""

import hashlib
import json
from pathlib import Path

import pandas as pd
from study.arguments import required_arguments
from study.passages import row_of
from study.plan import read_json
from study.runs import Run
from study.solve import solved
from study.spot_check import case_of, compared, texts

arguments = required_arguments(__doc__, "plan", "table", "run", "runs", "dld", "runner", "output")
plan = read_json(arguments.plan)
table = pd.read_csv(arguments.table, dtype=str, keep_default_na=False)
committed = table[table.run == arguments.run].iloc[0].to_dict()
case = case_of(committed, plan)
runs = Path(arguments.runs) / hashlib.sha256(Path(arguments.dld).read_bytes()).hexdigest()[:12]
solved(case, plan["solver_model"], runs, arguments.runner, arguments.dld)
run = Run(arguments.run, "", {"sweep": committed["sweep"]}, case, runs / arguments.run)
remade = texts(row_of(run))
verdict, columns = compared(committed, remade)
result = {"verdict": verdict, "columns": columns, "row": committed, "remade": remade}
Path(arguments.output).write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
