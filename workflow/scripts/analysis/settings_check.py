"""Do fast settings change a result? Class and D_perp of the same passages with them and with conservative
ones (smaller force, a membrane update in every step, a farther start, a stricter stop)."""

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.failures import WITHOUT_NUMBERS

POINT = ["settings", "row_shift_um", "capillary_number"]
MEASURED = ["class", "d_perp_um", "centre_um", "steps", "run"]
COLUMNS = [*POINT, *MEASURED, *(f"conservative_{name}" for name in MEASURED)]
COLUMNS += ["same_class", "d_perp_relative_change", "steps_ratio"]
STYLES = {"row_shift_um": ".1f", "capillary_number": ".4g", "steps_ratio": ".2f"}
STYLES |= {f"{side}{name}": ".4f" for side in ("", "conservative_") for name in ("d_perp_um", "centre_um")}
STYLES["d_perp_relative_change"] = ".5f"


def measured(run):
    """What is compared of a run; lengths only of one that did not fail."""
    summary = run.summary
    names = ["d_perp_um", "centre_um"] if summary["status"] not in WITHOUT_NUMBERS else []
    lengths = {name: summary.get(name) for name in names}
    return lengths | {"class": summary["status"], "steps": summary.get("steps"), "run": run.id}


def compared(fast, conservative):
    """One row: both runs of a point, and what the fast settings change."""
    row = fast | {f"conservative_{name}": value for name, value in conservative.items()}
    row["same_class"] = fast["class"] == conservative["class"]
    if None not in (fast.get("d_perp_um"), conservative.get("d_perp_um")):
        row["d_perp_relative_change"] = fast["d_perp_um"] / conservative["d_perp_um"] - 1
    return row | {"steps_ratio": conservative["steps"] / fast["steps"]}


def main():
    arguments = table_arguments(__doc__)
    points = {}
    for run in load_runs(arguments.plan, arguments.runs, "settings-check"):
        point = tuple(run.labels[name] for name in POINT)
        points.setdefault(point, {})[run.labels["side"]] = measured(run)
    rows = [
        dict(zip(POINT, point, strict=True)) | compared(found["fast"], found["conservative"])
        for point, found in points.items()
    ]
    write_table(rows, COLUMNS, arguments.output, POINT, STYLES)


main()
