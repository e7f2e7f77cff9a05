"""Solver runs that failed: kept as results with a label, so that the tables of the others are made, named at
the end, and tried again by the next call."""

import json
from pathlib import Path

FAILED = "failed"
#: Statuses of runs without the numbers that they were made for.
WITHOUT_NUMBERS = ("diverged", FAILED)


def stated_status(summary):
    """Status that a summary states; None where it cannot be read."""
    try:
        return json.loads(Path(summary).read_text(encoding="utf-8"))["status"]
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return None


def status_of(summary):
    """The same, but FAILED where the file is there and cannot be read."""
    return stated_status(summary) or (FAILED if Path(summary).exists() else None)


def failed_runs(runs, folder):
    """{identity: why} of those of some runs that failed."""
    found = {}
    for run in runs:
        summary = Path(folder) / run / "summary.json"
        if status_of(summary) == FAILED:
            try:
                found[run] = json.loads(summary.read_text(encoding="utf-8"))["reason"]
            except (ValueError, KeyError, TypeError):
                found[run] = "its summary is damaged"
    return found


def forget(runs, folder, brackets):
    """Takes away what failed runs left, so that they are made again: their summaries, and the points of
    brackets that they are."""
    for run in failed_runs(runs, folder):
        (Path(folder) / run / "summary.json").unlink()
    for point in Path(brackets).glob("**/*-*.json"):
        try:
            found = json.loads(point.read_text(encoding="utf-8"))
        except ValueError:
            found = {"class": FAILED}
        if isinstance(found, dict) and found.get("class") == FAILED:
            point.unlink()
