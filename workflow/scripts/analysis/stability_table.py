"""One row for every point of the stability maps: works, inaccurate or fails, and the predicted limit.

`predicted_share` is what the solver itself states before the run: the used share of its tightest margin.
`predicted_limit` is the y at which that share is 1 for the row's x.
"""

from itertools import groupby

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.stability import crossing, judge

COLUMNS = [
    "map",
    "x_name",
    "x",
    "y_name",
    "y",
    "status",
    "failing_quantity",
    "step",
    "predicted_limit",
    "predicted_share",
    "predicted_quantity",
    "place",
    "run",
]
STYLES = {"x": ".6g", "y": ".6g", "predicted_limit": ".3g", "predicted_share": ".3g"}


def row_of(run):
    """Table row of one point, without its predicted limit."""
    summary = run.summary
    status, quantity = judge(summary)
    return run.labels | {
        "status": status,
        "failing_quantity": quantity,
        "step": summary.get("failing_step", summary.get("steps")),
        "predicted_share": summary.get("used_share_of_margin"),
        "predicted_quantity": summary.get("tightest_margin"),
        "place": summary.get("failing_place"),
        "run": run.id,
    }


def main():
    arguments = table_arguments(__doc__)
    rows = [row_of(run) for run in load_runs(arguments.plan, arguments.runs, "stability")]
    for _, column in groupby(rows, key=lambda row: (row["map"], row["x"])):
        column = list(column)
        limit = crossing([row["y"] for row in column], [row["predicted_share"] for row in column])
        for row in column:
            row["predicted_limit"] = limit
    write_table(rows, COLUMNS, arguments.output, (), STYLES)


main()
