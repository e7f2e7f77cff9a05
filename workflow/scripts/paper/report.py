"""The report of a tier: one HTML file with verdicts, phase space, figures, tables and origin of the
runs."""

import tomllib
from collections import Counter
from pathlib import Path

import pandas as pd
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.paper import report, report_evidence
from study.paper.claims import load_claims
from study.paper.claims_page import column_of
from study.paper.grades import GRADES
from study.paper.templates import filled
from study.planning.documents import read_json

#: Tables shown under the figures where the tier has them: title and most rows shown.
TABLES = {
    "passages": ("Every passage", 1000),
    "phase_boundary": ("Brackets of the critical capillary number", 60),
    "fits": ("Fits", 80),
    "sensitivity": ("Sensitivity to single choices", 80),
    "streamline_separation": ("Flow without a cell", 80),
    "stokes_checks": ("Slow flow: linear in the force, the same backwards", 40),
    "units": ("Pressure gradient and velocity of a healthy cell", 40),
    "stretching": ("Cell stretched by an optical tweezer", 120),
    "stretching_comparison": ("Stretched cell against experiments", 40),
    "a_priori": ("Class by a rule, cell by cell", 300),
    "a_priori_summary": ("Predictions without a passage", 20),
    "accuracy_cost": ("Accuracy against cost", 80),
    "performance": ("Speed of the solver", 60),
    "stage_times": ("Time of the stages", 40),
}


def shown_tables(folder):
    """Tables of the page that the tier has, as title, file, header and rows."""
    for name, (title, limit) in TABLES.items():
        path = folder / f"{name}.csv"
        if path.exists():
            head, rows = report.as_rows(read_table(path), limit)
            yield {"name": name, "title": title, "head": head, "rows": rows}


def known(path):
    """A table that not every tier has; None without it."""
    return read_table(path) if path.exists() else None


def context(arguments):
    """What the template fills in."""
    tables, results = Path(arguments.tables), Path(arguments.figures)
    verdicts = pd.read_csv(arguments.verdicts, dtype=str).fillna("")
    document = read_json(arguments.claims)
    readings = [one for one in document["readings"] if column_of(one, document["readings"]) in verdicts]
    sets, points, axes = report.phase_space(read_table(tables / "passages.csv"), document["readings"])
    printed = load_claims(arguments.claims)["phase-boundary"]
    others = (known(tables / f"{name}.csv") for name in ("streamline_separation", "units"))
    points = report_evidence.beside_print(points, printed["statements"], *others)
    curves = report.boundaries(read_table(tables / "fits.csv"), printed["value"], axes) if axes else []
    plan = read_json(arguments.plan)
    case = next((run["case"] for run in plan["runs"] if run["group"] == "passages"), {"geometry": {}})
    data = {"points": points, "trajectories": report.trajectories(read_table(arguments.trajectories))}
    data["geometry"] = {"rows": plan["figures"]["trajectory_rows"]} | {
        name: case["geometry"].get(f"{name}_um") for name in ("pillar_radius", "pitch")
    }
    captions = tomllib.loads(Path(arguments.captions).read_text(encoding="utf-8"))["captions"]
    figures, shown = list(report.figures(results, captions)), list(shown_tables(tables))
    places = {"figures": {one["name"] for one in figures}, "tables": {one["name"] for one in shown}}
    rows = verdicts.to_dict("records")
    provenance = report.as_rows(pd.read_csv(arguments.provenance, dtype=str).fillna(""))
    return {
        "tier": plan["tier"],
        "note": plan["note"],
        "verdicts": list(report_evidence.linked(rows, **places, runs={point["run"] for point in points})),
        "readings": [
            {"id": one["id"], "description": one["description"]}
            | {"counts": Counter(verdicts[column_of(one, document["readings"])])}
            for one in readings
        ],
        "grades": list(GRADES),
        "counts": Counter(verdicts.verdict),
        "sets": sets,
        "points": points,
        "axes": axes,
        "curves": curves,
        "classes": report.CLASSES,
        "data": report.as_script(data),
        "figures": figures,
        "tables": shown,
        "provenance": provenance,
    }


def main():
    names = "plan tables figures verdicts claims trajectories provenance captions template output"
    arguments = required_arguments(__doc__, *names.split())
    page = filled(arguments.template, context(arguments), autoescape=True)
    Path(arguments.output).write_text(page, encoding="utf-8")


main()
