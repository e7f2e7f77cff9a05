"""The verdicts as a Markdown page: how many of each grade in every reading, the claims with what was measured
beside the print, their grades in the other readings, and on what they rest."""

from collections import Counter

from study.analysis.tables import markdown_table
from study.paper.grades import CONTRADICTS, GRADES, HOLDS, NOT_DECIDED, NOT_REPRODUCED, NOT_RUN, REPRODUCED

RUNS_SHOWN = 4  # the CSV file has all
#: Grades in the narrow table of all readings.
SHORT = {REPRODUCED: "reproduced", HOLDS: "holds", CONTRADICTS: "contradicts", NOT_REPRODUCED: "not"}
SHORT |= {NOT_DECIDED: "undecided", NOT_RUN: ""}


def column_of(reading, readings):
    """Name of the column with the grades of a reading; those of the first one are the verdicts."""
    return "verdict" if reading == readings[0] else f"verdict_{reading['id']}"


def counts(rows, readings):
    """How many claims got each grade: readings down, grades across."""
    lines = []
    for reading in readings:
        count = Counter(row[column_of(reading, readings)] for row in rows)
        lines.append([f"`{reading['id']}`", *(count[grade] for grade in GRADES), reading["description"]])
    return markdown_table(["reading", *map(str.lower, GRADES), "what it is"], lines)


def in_order(rows):
    """The claims as they are declared, the measured value and the verdict beside the print."""
    cells = []
    for row in rows:
        printed = " ".join(filter(None, (row["paper_value"], row["unit"])))
        verdict = f"**{row['verdict']}**" + (f", {row['grounds']}" if row["grounds"] else "")
        remark = row.get("explanation") or (row.get("note") if not row.get("measured") else "")
        cells.append([f"{row['claim']} (`{row['id']}`)", printed, row.get("measured"), verdict, remark])
    titles = ["claim", "paper", "measured", "verdict", "why"]
    return markdown_table(titles, [[cell or "" for cell in line] for line in cells])


def by_reading(rows, readings):
    """The grade of every claim in every reading, in short; empty where it was not run."""
    lines = [[row["id"], *(SHORT[row[column_of(one, readings)]] for one in readings)] for row in rows]
    return markdown_table(["claim", *(reading["id"] for reading in readings)], lines)


def runs_in_words(runs):
    """The runs behind a verdict: all if they are few."""
    names = runs.split()
    if len(names) <= RUNS_SHOWN:
        return " ".join(names)
    return f"{' '.join(names[:RUNS_SHOWN])} and {len(names) - RUNS_SHOWN} more"


def details(rows):
    """Place, criteria with their reasons, uncertainty, note and runs of every claim."""
    cells = []
    for row in rows:
        tolerance = ": ".join(filter(None, (row["tolerance"], row["reason"])))
        limit = ": ".join(filter(None, (row["limit"], row["limit_reason"])))
        shown = [row["id"], row["where"], tolerance, limit, row.get("uncertainty"), row.get("note")]
        cells.append([cell or "" for cell in shown] + [runs_in_words(row["runs"])])
    titles = ["claim", "place", "reproduced within", "holds within", "uncertainty", "note", "runs"]
    return markdown_table(titles, cells)


def page(rows, readings, tier, note=""):
    """The whole page; a tier's `note` stands on top."""
    grades = [f"- {grade}: {meaning}." for grade, meaning in GRADES.items()]
    parts = [
        [f"# Verdicts on the paper's claims ({tier} tier)", *(["", f"**{note}**"] if note else [])],
        counts(rows, readings),
        [f"The verdicts are the grades in the reading `{readings[0]['id']}`, by what matters most:"],
        in_order(rows),
        ["## In every reading"],
        by_reading(rows, readings),
        ["## What the grades mean"],
        grades,
        ["## Criteria, fixed in params/claims.json"],
        details(rows),
    ]
    return "\n\n".join("\n".join(part) for part in parts) + "\n"
