"""Error and cost of every method and setting, at every point and over all of them, with the Pareto frontiers.

Error: largest deviation from the reference, the limit of another scheme. Work units: node updates, membrane
updates at their weight, and for the models without a lattice their operations over those of a node update.
Seconds: by the pipeline's benchmark of each run, other runs at its side."""

import numpy as np
from study.analysis import accuracy
from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import read_table, write_table
from study.planning.documents import read_json


def cheap_rows(path, settings):
    """Rows of the models without a lattice, in the form of `accuracy.row_of`."""
    for line in read_table(path).to_dict("records"):
        found = {"separation distance, relative": line["s_um"]}
        found["flow resistance, relative"] = line["resistance_Pa_s_per_m2"]
        yield {
            "study": "flow",
            "method": line["method"],
            "setting": line["setting"] if isinstance(line["setting"], str) else "",
            "point": line["point"],
            "work_units": line["operations"] / settings["operations_per_node_update"],
            "seconds": line["seconds"],
            "status": "converged",
            "observed": {kind: np.array([value]) for kind, value in found.items() if value == value},
        }


def rows_of_study(name, definition, rows, cheap=()):
    """Judged rows of a study: each method by its reference."""
    limits = accuracy.references(definition["references"], rows)
    classes = accuracy.expected_classes(definition["references"], rows)
    for row in rows:
        reference = definition["methods"][row["method"]]["reference"]
        yield from accuracy.judged(name, row, reference, limits, classes)
    for row in cheap:
        judged = accuracy.judged(name, row, definition["cheap_reference"], limits, {})
        # A formula says nothing about what it was not made for.
        yield from (found for found in judged if found["error_kind"] in row["observed"])


def main():
    arguments = table_arguments(__doc__, "cheap")
    settings = read_json(arguments.plan)["accuracy"]
    rows = []
    for name, definition in settings["studies"].items():
        runs = load_runs(arguments.plan, arguments.runs, f"accuracy-{name}")
        own = [accuracy.row_of(run, settings["membrane_update_weight"]) for run in runs]
        cheap = list(cheap_rows(arguments.cheap, settings)) if name == "flow" else []
        rows += rows_of_study(name, definition, own, cheap)
    rows = accuracy.mark_frontiers(rows + list(accuracy.over_points(rows)))
    keys = ["study", "error_kind", "point", "work_units", "method", "setting"]
    write_table(rows, accuracy.COLUMNS, arguments.output, keys, accuracy.STYLES)


main()
