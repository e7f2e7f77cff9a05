"""Extracts the mid-plane velocity and the separatrices that Figure 4 shows."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.documents import read_json


def field_rows(run):
    """One row for each node of the mid plane; positions relative to the pillar's centre."""
    x, y, velocity, solid = (run.data(f"flow/{name}") for name in ("x_um", "y_um", "velocity", "solid"))
    for i, j in np.ndindex(len(x), len(y)):
        yield {
            "row_shift_um": run.row_shift_um,
            "x_um": x[i],
            "y_um": y[j],
            "velocity_x_lu": float(velocity[i, j, 0]),
            "velocity_y_lu": float(velocity[i, j, 1]),
            "solid": int(solid[i, j]),
        }


def separatrix_rows(run):
    """Points of both separatrices."""
    for side in ("downstream", "upstream"):
        line = run.data(f"separatrix/{side}")
        for x, y in line if line is not None else ():
            yield {"row_shift_um": run.row_shift_um, "side": side, "x_um": float(x), "y_um": float(y)}


def main():
    arguments = required_arguments(__doc__, "plan", "runs", "fields", "separatrices")
    figures = read_json(arguments.plan)["figures"]
    runs = [
        run
        for run in load_runs(arguments.plan, arguments.runs, "streamlines")
        if run.labels["variant"] == figures["streamline_variant"]
        and run.row_shift_um in figures["streamline_row_shifts_um"]
    ]
    styles = {
        "x_um": ".3f",
        "y_um": ".3f",
        "velocity_x_lu": ".4g",
        "velocity_y_lu": ".4g",
        "row_shift_um": ".1f",
    }
    columns = ["row_shift_um", "x_um", "y_um", "velocity_x_lu", "velocity_y_lu", "solid"]
    rows = [row for run in runs for row in field_rows(run)]
    write_table(rows, columns, arguments.fields, styles=styles)
    rows = [row for run in runs for row in separatrix_rows(run)]
    write_table(rows, ["row_shift_um", "side", "x_um", "y_um"], arguments.separatrices, styles=styles)


main()
