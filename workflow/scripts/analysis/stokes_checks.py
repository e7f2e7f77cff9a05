"""Is the flow a Stokes flow? For every row shift: the change of u_mean / p' with the force density
and the difference between the flow and its reversal.

The reversal of a Stokes flow is the same flow, so the velocity at (-x, -y) about the pillar's centre has to
be that at (x, y); inertia breaks this symmetry. Differences are in units of the largest speed.
"""

from collections import defaultdict

import numpy as np
from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.failures import WITHOUT_NUMBERS

COLUMNS = [
    "row_shift_um",
    "epsilon",
    "dx_um",
    "force_density_low",
    "force_density_high",
    "reynolds_low",
    "reynolds_high",
    "mobility_low",
    "mobility_high",
    "relative_change",
    "reversal_max_low",
    "reversal_max_high",
    "reversal_rms_high",
    "s_um_high",
    "s_upper_um_high",
    "runs",
]


def reflected(coordinates):
    """Pairs of index arrays (i, j) with coordinates[i] = -coordinates[j]."""
    spacing = coordinates[1] - coordinates[0]
    places = np.rint((-coordinates - coordinates[0]) / spacing).astype(int)
    inside = (places >= 0) & (places < len(coordinates))
    return np.nonzero(inside)[0], places[inside]


def reversal(run):
    """Largest and root-mean-square difference between a flow and its point reflection."""
    x, y, velocity = (run.data(f"flow/{name}") for name in ("x_um", "y_um", "velocity"))
    (ix, jx), (iy, jy) = reflected(x), reflected(y)
    difference = velocity[np.ix_(ix, iy)] - velocity[np.ix_(jx, jy)]
    size, scale = np.linalg.norm(difference, axis=-1), np.linalg.norm(velocity, axis=-1).max()
    return size.max() / scale, np.sqrt(np.mean(size**2)) / scale


def row_of(runs):
    """Table row from the runs of one row shift."""
    low, high = sorted(runs, key=lambda run: run.labels["force_density"])
    forces = [run.labels["force_density"] for run in (low, high)]
    summaries = [low.summary, high.summary]
    row = {
        "row_shift_um": low.row_shift_um,
        "epsilon": low.epsilon,
        "dx_um": low.dx_um,
        "force_density_low": forces[0],
        "force_density_high": forces[1],
        "runs": f"{low.id} {high.id}",
    }
    if any(one["status"] in WITHOUT_NUMBERS for one in summaries):
        return row  # a labelled gap: there is no flow to compare
    mobilities = [s["mean_velocity"] / force for s, force in zip(summaries, forces, strict=True)]
    (low_max, _), (high_max, high_rms) = reversal(low), reversal(high)
    return row | {
        "reynolds_low": summaries[0]["reynolds_number"],
        "reynolds_high": summaries[1]["reynolds_number"],
        "mobility_low": mobilities[0],
        "mobility_high": mobilities[1],
        "relative_change": mobilities[1] / mobilities[0] - 1,
        "reversal_max_low": low_max,
        "reversal_max_high": high_max,
        "reversal_rms_high": high_rms,
        "s_um_high": summaries[1]["separation_um"],
        "s_upper_um_high": summaries[1]["separation_upper_um"],
    }


def main():
    arguments = table_arguments(__doc__)
    pairs = defaultdict(list)
    for run in load_runs(arguments.plan, arguments.runs, "stokes"):
        pairs[run.row_shift_um].append(run)
    styles = {"relative_change": ".3e", "mobility_low": ".8g", "mobility_high": ".8g"}
    styles |= {name: ".2e" for name in COLUMNS if name.startswith("reversal")}
    write_table(
        [row_of(runs) for runs in pairs.values()], COLUMNS, arguments.output, ["row_shift_um"], styles
    )


main()
