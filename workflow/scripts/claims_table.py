"""The verdict on every claim: REPRODUCED, NOT REPRODUCED with the measured value, or NOT RUN in this tier."""

import argparse
import json
from collections import Counter
from pathlib import Path

import pandas as pd
from study.claims import CHECKS
from study.plan import validated
from study.tables import read_table, write_table

TABLES = ["streamline_separation", "fits", "stokes_checks", "units", "stretching", "passages"]
COLUMNS = [
    "id",
    "verdict",
    "claim",
    "where",
    "paper_value",
    "unit",
    "measured",
    "tolerance",
    "reason",
    "note",
]


def as_text(value):
    """Compact text of a printed value or tolerance."""
    return "" if value is None else json.dumps(value).replace('"', "").strip("{}")


def row_of(claim, tables, experiment, tier):
    """Table row of one claim."""
    finding = CHECKS[claim["id"]](tables, claim, experiment) if claim["id"] in CHECKS else None
    row = {name: claim.get(name) for name in ("id", "claim", "where", "unit", "reason")}
    row |= {"paper_value": as_text(claim["value"]), "tolerance": as_text(claim["tolerance"])}
    if finding is None:
        missing = f"needs {claim['later']}" if "later" in claim else f"the {tier} tier has no runs for it"
        return row | {"verdict": "NOT RUN", "note": missing}
    verdict = "REPRODUCED" if finding.reproduced else "NOT REPRODUCED"
    return row | {"verdict": verdict, "measured": finding.measured, "note": finding.note}


def markdown(rows, tier):
    """The verdicts as a Markdown page."""
    count = Counter(row["verdict"] for row in rows)
    lines = [f"# Verdicts on the paper's claims ({tier} tier)", ""]
    lines += [
        ", ".join(f"{count[name]} {name}" for name in ("REPRODUCED", "NOT REPRODUCED", "NOT RUN")) + ".",
        "",
    ]
    lines += [
        "| id | claim | paper | measured | tolerance | verdict | note |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        paper = " ".join(filter(None, (row["paper_value"], row["unit"])))
        cells = (
            row["id"],
            row["claim"],
            paper,
            row.get("measured"),
            row["tolerance"],
            row["verdict"],
            row["note"],
        )
        lines.append("| " + " | ".join((cell or "").replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--claims", required=True)
    parser.add_argument("--tables", required=True, help="folder of the tables")
    parser.add_argument("--tier", required=True)
    parser.add_argument("--experiment", required=True)
    parser.add_argument("--csv", required=True)
    parser.add_argument("--markdown", required=True)
    arguments = parser.parse_args()
    tables = {name: read_table(Path(arguments.tables) / f"{name}.csv") for name in TABLES}
    experiment = pd.read_csv(arguments.experiment, comment="#")
    claims = validated(arguments.claims, "claims")["claims"]
    rows = [row_of(claim, tables, experiment, arguments.tier) for claim in claims]
    write_table(rows, COLUMNS, arguments.csv)
    Path(arguments.markdown).write_text(markdown(rows, arguments.tier), encoding="utf-8")


main()
