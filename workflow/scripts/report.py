"""The report of a tier: one HTML file with verdicts, phase space, figures, tables and origin of the
runs."""

import tomllib
from collections import Counter
from pathlib import Path

import pandas as pd
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from study import report
from study.arguments import required_arguments
from study.claims import load_claims
from study.grades import GRADES
from study.plan import read_json
from study.tables import read_table

#: Tables shown under the figures where the tier has them: title and most rows shown.
TABLES = {
    "phase_boundary": ("Brackets of the critical capillary number", 60),
    "fits": ("Fits", 80),
    "sensitivity": ("Sensitivity to single choices", 80),
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


def context(arguments):
    """What the template fills in."""
    tables, results = Path(arguments.tables), Path(arguments.figures)
    verdicts = pd.read_csv(arguments.verdicts, dtype=str).fillna("")
    sets, points, axes = report.phase_space(read_table(tables / "passages.csv"))
    printed = load_claims(arguments.claims)["phase-boundary"]["value"]
    curves = report.boundaries(read_table(tables / "fits.csv"), printed, axes) if axes else []
    plan = read_json(arguments.plan)
    case = next((run["case"] for run in plan["runs"] if run["group"] == "passages"), {"geometry": {}})
    data = {"points": points, "trajectories": report.trajectories(read_table(arguments.trajectories))}
    data["geometry"] = {"rows": plan["figures"]["trajectory_rows"]} | {
        name: case["geometry"].get(f"{name}_um") for name in ("pillar_radius", "pitch")
    }
    captions = tomllib.loads(Path(arguments.captions).read_text(encoding="utf-8"))["captions"]
    provenance = report.as_rows(pd.read_csv(arguments.provenance, dtype=str).fillna(""))
    return {
        "tier": plan["tier"],
        "note": plan["note"],
        "verdicts": verdicts.to_dict("records"),
        "grades": list(GRADES),
        "counts": Counter(verdicts.verdict),
        "sets": sets,
        "points": points,
        "axes": axes,
        "curves": curves,
        "classes": report.CLASSES,
        "data": report.as_script(data),
        "figures": report.figures(results, captions),
        "tables": list(shown_tables(tables)),
        "provenance": provenance,
    }


def main():
    names = "plan tables figures verdicts claims trajectories provenance captions template output"
    arguments = required_arguments(__doc__, *names.split())
    template = Path(arguments.template)
    environment = Environment(
        loader=FileSystemLoader(template.parent),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    page = environment.get_template(template.name).render(context(arguments))
    Path(arguments.output).write_text(page, encoding="utf-8")


main()
