"""Every crossing of a pillar line of every passage, and the return maps that they make: the gap position at
one line against that at the next, and whether the cell kept its lane (bump 1) or fell back by one (0)."""

from itertools import pairwise

from study.analysis.arguments import table_arguments
from study.analysis.runs import passage_runs
from study.analysis.tables import write_table

LABELS = ["sweep", "device", "cell", "dx_um", "lateral_flow", "row_shift_um", "capillary_number", "class"]
MEASURED = ["row", "step", "y_um", "gap_position_um", "lane", "bump", "d_perp_um", "d_perp_at_centre_um"]
MEASURED += ["film_um", "min_face_ratio", "height_um", "speed_um_per_step"]
MAP = ["row", "gap_position_um", "next_gap_position_um", "bump"]
STYLES = dict.fromkeys(["y_um", "d_perp_um", "d_perp_at_centre_um", "film_um", "height_um"], ".3f")
STYLES |= dict.fromkeys(["gap_position_um", "next_gap_position_um"], ".4f")
STYLES |= {"dx_um": ".4f", "row_shift_um": ".1f", "capillary_number": ".4g", "speed_um_per_step": ".4e"}
STYLES |= {"min_face_ratio": ".3f"} | dict.fromkeys(["row", "step", "lane", "bump"], ".0f")


def labels_of(run):
    """What all rows of a run have in common."""
    return {
        **{name: run.labels[name] for name in ("sweep", "device", "cell")},
        "dx_um": run.dx_um,
        "lateral_flow": run.case["fluid"]["lateral_flow"],
        "row_shift_um": run.row_shift_um,
        "capillary_number": run.case["cell"]["capillary_number"],
        "class": run.summary["status"],
        "run": run.id,
    }


def crossings_of(run):
    """Rows of one run; none if it diverged before the first line."""
    with run.open() as file:
        if "crossings" not in file:
            return []
        columns = {name: file["crossings"][name][:] for name in MEASURED if name in file["crossings"]}
    labels = labels_of(run)
    count = len(next(iter(columns.values())))
    return [labels | {name: float(column[k]) for name, column in columns.items()} for k in range(count)]


def map_rows(crossings):
    """Pairs of neighbouring crossings of one run; `bump` is that of the way to the next line."""
    for now, after in pairwise(crossings):
        yield now | {"next_gap_position_um": after["gap_position_um"], "bump": after["bump"]}


def main():
    arguments = table_arguments(__doc__, "brackets", "maps")
    runs = passage_runs(arguments.plan, arguments.brackets, arguments.runs)
    crossings = [crossings_of(run) for run in runs]
    keys = [*LABELS, "row"]
    rows = [row for group in crossings for row in group]
    write_table(rows, [*LABELS, *MEASURED, "run"], arguments.output, keys, STYLES)
    rows = [row for group in crossings for row in map_rows(group)]
    write_table(rows, [*LABELS, *MAP, "run"], arguments.maps, keys, STYLES)


main()
