"""Separation distance, flow resistance and cost of the models that need no lattice Boltzmann run, at the
points of the flow study. Seconds are the smallest of three evaluations on one core."""

import time

from study.analysis import cheap_models as models
from study.analysis.arguments import required_arguments
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = [
    "method",
    "setting",
    "point",
    "row_shift_um",
    "s_um",
    "resistance_Pa_s_per_m2",
    "operations",
    "seconds",
]
STYLES = {"s_um": ".5f", "resistance_Pa_s_per_m2": ".6e", "operations": ".4e", "seconds": ".2e"}
#: Operations of a closed formula, to the order of magnitude: its cost is nothing beside that of any run.
FORMULA_OPERATIONS = 100.0
FORMULAS = {
    "plug flow": (models.plug, models.slit_resistance),
    "parabola": (models.parabola, models.hele_shaw_resistance),
    "Davis' fit": (models.davis, None),
}
REPEATS = 3


def formula(array, separation, resistance):
    """s, resistance (or None) and operations of closed formulas."""
    return separation(array), resistance(array) if resistance else None, FORMULA_OPERATIONS


def timed(function, *arguments):
    """Result of a function and the least seconds that it took."""
    seconds = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        result = function(*arguments)
        seconds.append(time.perf_counter() - begin)
    return result, min(seconds)


def array_of(case):
    """The array of a resolved case."""
    geometry = case["geometry"]
    return models.Array(
        *(geometry[f"{name}_um"] for name in ("pillar_radius", "pitch", "depth", "row_shift"))
    )


def rows_of(point, array, cell_counts):
    """Table rows of one point."""
    choices = [(name, "", formula, (array, *parts)) for name, parts in FORMULAS.items()]
    choices += [("depth-averaged flow", f"{n} cells", models.depth_averaged, (array, n)) for n in cell_counts]
    for method, setting, function, arguments in choices:
        (s, resistance, operations), seconds = timed(function, *arguments)
        yield {
            "method": method,
            "setting": setting,
            "point": point,
            "row_shift_um": array.row_shift,
            "s_um": s,
            "resistance_Pa_s_per_m2": resistance,
            "operations": operations,
            "seconds": seconds,
        }


def main():
    arguments = required_arguments(__doc__, "plan", "output")
    plan = read_json(arguments.plan)
    cases = {run["labels"]["point"]: run["case"] for run in plan["runs"] if run["group"] == "accuracy-flow"}
    counts = plan["accuracy"]["depth_averaged_cells"]
    rows = [row for point, case in cases.items() for row in rows_of(point, array_of(case), counts)]
    write_table(rows, COLUMNS, arguments.output, styles=STYLES)


main()
