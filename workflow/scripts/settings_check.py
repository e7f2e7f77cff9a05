"""Do the fast settings of the study change a result? Class and D_perp of the same passages with them and with
conservative ones (smaller force, a membrane update in every step, a farther start, a stricter stop)."""

import argparse

from study.plan import read_json
from study.runs import load_runs
from study.tables import write_table

MEASURED = ["class", "d_perp_um", "centre_um", "steps", "run"]
COLUMNS = ["row_shift_um", "capillary_number", *MEASURED, *(f"conservative_{name}" for name in MEASURED)]
COLUMNS += ["same_class", "d_perp_relative_change", "steps_ratio"]
STYLES = {"row_shift_um": ".1f", "capillary_number": ".4g", "steps_ratio": ".2f"}
STYLES |= {f"{side}{name}": ".4f" for side in ("", "conservative_") for name in ("d_perp_um", "centre_um")}
STYLES["d_perp_relative_change"] = ".5f"


def measured(run):
    summary = run.summary
    found = {name: summary.get(name) for name in ("d_perp_um", "centre_um", "steps")}
    return found | {"class": summary["status"], "run": run.id}


def compared(fast, conservative):
    """One row: both runs of a point, and what the fast settings change."""
    row = fast | {f"conservative_{name}": value for name, value in conservative.items()}
    row["same_class"] = fast["class"] == conservative["class"]
    if None not in (fast["d_perp_um"], conservative["d_perp_um"]):
        row["d_perp_relative_change"] = fast["d_perp_um"] / conservative["d_perp_um"] - 1
    return row | {"steps_ratio": conservative["steps"] / fast["steps"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--plan", "--runs", "--output"):
        parser.add_argument(name, required=True)
    arguments = parser.parse_args()
    runs = load_runs(arguments.plan, arguments.runs, "settings-check")
    pairs = {(*(run.labels[name] for name in COLUMNS[:2]), run.labels["settings"]): run for run in runs}
    rows = []
    for point in read_json(arguments.plan)["accuracy"]["settings_check"]["points"]:
        fast, slow = (pairs[*point.values(), settings] for settings in ("study", "conservative"))
        rows.append(point | compared(measured(fast), measured(slow)))
    write_table(rows, COLUMNS, arguments.output, COLUMNS[:2], STYLES)


main()
