"""The verdict on every claim: REPRODUCED, NOT REPRODUCED with the measured value, NOT DECIDED where its runs
do not tell, or NOT RUN.

A claim that does not come out is a result, and so is one that cannot be decided. A claim for which a run is
missing is one only in a tier that examines less than the whole; in the others the program says which and
fails.
"""

import argparse
import sys
from pathlib import Path

import pandas as pd
from study import claims_classes, claims_extent, claims_flow  # noqa: F401 (they register their checks)
from study.claims import CHECKS, Undecidable, counted
from study.plan import validated
from study.tables import markdown_table, read_table, write_table

TABLES = ["streamline_separation", "fits", "stokes_checks", "units", "stretching", "passages"]
TABLES += ["phase_boundary", "critical_row_shift", "a_priori"]
COLUMNS = ["id", "verdict", "claim", "where", "paper_value", "unit", "measured", "uncertainty"]
COLUMNS += ["tolerance", "reason", "note", "explanation", "runs"]
RUNS_SHOWN = 4  # in the Markdown page; the CSV file has all


def as_text(value):
    """Compact text of a printed value or tolerance: a number, a list or named parts."""
    if isinstance(value, dict):
        return ", ".join(f"{name}: {as_text(part)}" for name, part in value.items())
    if isinstance(value, list):
        return f"[{', '.join(map(as_text, value))}]"
    return "" if value is None else f"{value:g}"


def row_of(claim, tables, experiment, tier):
    """Table row of one claim."""
    row = {name: claim.get(name) for name in ("id", "claim", "where", "unit", "reason")}
    row |= {"paper_value": as_text(claim["value"]), "tolerance": as_text(claim["tolerance"])}
    try:
        finding = CHECKS[claim["id"]](tables, claim, experiment)
    except Undecidable as why:
        return row | {"verdict": "NOT DECIDED", "note": str(why), "runs": ""}
    if finding is None:
        return row | {"verdict": "NOT RUN", "note": f"the {tier} tier has no runs for it", "runs": ""}
    verdict = "REPRODUCED" if finding.reproduced else "NOT REPRODUCED"
    row["explanation"] = None if finding.reproduced else claim.get("otherwise")
    found = {name: getattr(finding, name) for name in ("measured", "uncertainty", "note")}
    return row | found | {"verdict": verdict, "runs": " ".join(finding.runs)}


def runs_in_words(runs):
    """The runs behind a verdict: all if they are few."""
    names = runs.split()
    if len(names) <= RUNS_SHOWN:
        return " ".join(names)
    return f"{' '.join(names[:RUNS_SHOWN])} and {len(names) - RUNS_SHOWN} more"


def markdown(rows, tier):
    """The verdicts as a Markdown page."""
    lines = [f"# Verdicts on the paper's claims ({tier} tier)", ""]
    lines += [counted(row["verdict"] for row in rows) + ".", ""]
    titles = ["id", "claim", "place", "paper", "measured", "uncertainty", "tolerance", "verdict"]
    titles += ["explanation", "note", "runs"]
    cells = []
    for row in rows:
        shown = row | {
            "place": row["where"],
            "paper": " ".join(filter(None, (row["paper_value"], row["unit"]))),
            "runs": runs_in_words(row["runs"]),
        }
        cells.append([shown.get(title) or "" for title in titles])
    return "\n".join([*lines, *markdown_table(titles, cells)]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--claims", required=True)
    parser.add_argument("--tables", required=True, help="folder of the tables")
    parser.add_argument("--tier", required=True)
    parser.add_argument("--whole", action="store_true", help="a claim without its runs is an error")
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
    missing = [row["id"] for row in rows if row["verdict"] == "NOT RUN"]
    if arguments.whole and missing:
        sys.exit(f"runs are missing for the claims {', '.join(missing)} (tier {arguments.tier})")


main()
