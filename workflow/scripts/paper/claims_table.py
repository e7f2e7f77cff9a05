"""The verdict on every claim: its grade in the default reading of what the paper leaves open, with the
measured value, and its grade in every other reading.

A claim that does not come out is a result, and so is one that cannot be decided. A claim for which a run is
missing says so: its tier examines less than the whole, or the run failed.
"""

import argparse
from pathlib import Path

from study.analysis.measured import read_measured
from study.analysis.tables import read_table, write_table
from study.paper import (  # noqa: F401 (register checks)
    claims_boundary,
    claims_classes,
    claims_extent,
    claims_flow,
)
from study.paper.claims import CHECKS, Undecidable
from study.paper.claims_page import page
from study.paper.grades import NOT_DECIDED, NOT_RUN, OTHERWISE, graded, limit_of
from study.paper.readings import view
from study.planning.documents import read_json, validated

TABLES = ["streamline_separation", "fits", "stokes_checks", "units", "stretching", "passages"]
TABLES += ["phase_boundary", "critical_row_shift", "a_priori"]
COLUMNS = ["id", "verdict", "grounds", "claim", "where", "paper_value", "unit", "measured", "uncertainty"]
COLUMNS += [
    "tolerance",
    "reason",
    "limit",
    "limit_reason",
    "note",
    "explanation",
    "figure",
    "tables",
    "check",
]


def as_text(value):
    """Compact text of a printed value or tolerance: a number, a list or named parts."""
    if isinstance(value, dict):
        return ", ".join(f"{name}: {as_text(part)}" for name, part in value.items())
    if isinstance(value, list):
        return f"[{', '.join(map(as_text, value))}]"
    return "" if value is None else f"{value:g}"


class Noted(dict):
    """Tables that note which of them were read."""

    def __init__(self, tables):
        super().__init__(tables)
        self.read = {}

    def __getitem__(self, name):
        self.read[name] = True
        return super().__getitem__(name)


def origin(claim, tables):
    """Where a verdict comes from: the tables that its check read, the check and the figure that shows it."""
    check = CHECKS[claim["id"]]
    place = f"{check.__module__}.{check.__qualname__.split('.')[0]}"
    read = [name for name in TABLES if name in tables.read]
    return {"figure": claim.get("figure"), "tables": " ".join(read), "check": place}


def judged(claim, tables, experiment):
    """(grade, on what it rests, finding or why there is none) of a claim by the view of a reading."""
    try:
        finding = CHECKS[claim["id"]](tables, claim, experiment)
    except Undecidable as why:
        return NOT_DECIDED, "", str(why)
    return (NOT_RUN, "", None) if finding is None else (*graded(claim, finding), finding)


def row_of(claim, views, experiment, tier):
    """Table row of one claim; `views` are the tables by reading, those of the default first."""
    row = {name: claim.get(name) for name in ("id", "claim", "where", "unit", "reason")}
    row |= {"paper_value": as_text(claim["value"]), "tolerance": as_text(claim["tolerance"]), "runs": ""}
    row |= {"limit": limit_of(claim), "limit_reason": claim.get("holds", {}).get("reason")}
    default, *others = views
    for name in others:
        row[f"verdict_{name}"] = judged(claim, views[name], experiment)[0]
    read = Noted(views[default])
    row["verdict"], row["grounds"], finding = judged(claim, read, experiment)
    row |= origin(claim, read)
    if row["verdict"] == NOT_RUN:
        return row | {"note": f"the {tier} tier has no runs for it"}
    if row["verdict"] == NOT_DECIDED:
        return row | {"note": finding}
    row["explanation"] = claim["otherwise"] if row["verdict"] in OTHERWISE else None
    found = {name: getattr(finding, name) for name in ("measured", "uncertainty", "note")}
    return row | found | {"runs": " ".join(finding.runs)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--claims", required=True)
    parser.add_argument("--tables", required=True, help="folder of the tables")
    parser.add_argument("--plan", required=True)
    parser.add_argument("--experiment", required=True)
    parser.add_argument("--csv", required=True)
    parser.add_argument("--markdown", required=True)
    arguments = parser.parse_args()
    tables = {name: read_table(Path(arguments.tables) / f"{name}.csv") for name in TABLES}
    experiment = read_measured(arguments.experiment)
    declared = validated(arguments.claims, "claims")
    readings = declared["readings"]
    views = {reading["id"]: view(tables, reading) for reading in readings}
    plan = read_json(arguments.plan)
    rows = [row_of(claim, views, experiment, plan["tier"]) for claim in declared["claims"]]
    columns = [*COLUMNS, *(f"verdict_{reading['id']}" for reading in readings[1:]), "runs"]
    write_table(rows, columns, arguments.csv)
    Path(arguments.markdown).write_text(page(rows, readings, plan["tier"], plan["note"]), encoding="utf-8")


main()
