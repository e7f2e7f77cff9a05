"""Extracts the trajectories of Figure 6: centre of the cell, thinned out, up to the last row shown."""

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["row_shift_um", "capillary_number", "class", "step", "x_um", "y_um"]
SPACING_UM = 0.5  # smallest distance along x between two points


def thinned(steps, x, y, last_x):
    """Points at least SPACING_UM apart along x, up to last_x."""
    previous = float("-inf")
    for step, at_x, at_y in zip(steps, x, y, strict=True):
        if at_x > last_x:
            return
        if at_x - previous >= SPACING_UM:
            previous = at_x
            yield int(step), float(at_x), float(at_y)


def shown(run, figures):
    """Is this one of the cells of the figure?"""
    return (
        run.labels["sweep"] == figures["trajectory_sweep"]
        and run.row_shift_um in figures["trajectory_row_shifts_um"]
        and run.case["cell"]["capillary_number"] in figures["trajectory_capillary_numbers"]
    )


def rows_of(run, rows_shown):
    """Table rows of one run."""
    steps, x, y = (run.data(f"trajectory/{name}") for name in ("step", "x_um", "y_um"))
    if steps is None:  # diverged before the first sample
        return
    last_x = (rows_shown - 0.5) * run.case["geometry"]["pitch_um"]
    label = {
        "row_shift_um": run.row_shift_um,
        "capillary_number": run.case["cell"]["capillary_number"],
        "class": run.summary["status"],
    }
    for step, at_x, at_y in thinned(steps, x, y, last_x):
        yield label | {"step": step, "x_um": at_x, "y_um": at_y}


def main():
    arguments = table_arguments(__doc__)
    figures = read_json(arguments.plan)["figures"]
    runs = load_runs(arguments.plan, arguments.runs, "passages")
    chosen = [run for run in runs if shown(run, figures)]
    rows = [row for run in chosen for row in rows_of(run, figures["trajectory_rows"])]
    styles = {"x_um": ".2f", "y_um": ".3f", "row_shift_um": ".1f"}
    keys = ["row_shift_um", "capillary_number", "step"]
    write_table(rows, COLUMNS, arguments.output, keys, styles)


main()
