"""What the report needs of the runs: thinned trajectories of all passages, and how the runs were made."""

import argparse
from collections import Counter

from study.analysis.runs import load_runs, passage_runs
from study.analysis.tables import write_table
from study.planning.documents import read_json

SPACING_UM = 4.0  # smallest distance along x between two points of a thumbnail
TRAJECTORIES = ["run", "x_um", "y_um"]
PROVENANCE = ["runs", "version", "git_commit", "compiler", "flags", "build_type", "libraries", "threads"]


def thumbnail(run, rows_shown):
    """Rows (run, x, y) of one trajectory, at least SPACING_UM apart, up to the last row shown."""
    x, y = run.data("trajectory/x_um"), run.data("trajectory/y_um")
    if x is None:  # diverged before the first sample
        return
    previous, last_x = float("-inf"), (rows_shown - 0.5) * run.case["geometry"]["pitch_um"]
    for at_x, at_y in zip(x, y, strict=True):
        if at_x > last_x:
            return
        if at_x - previous >= SPACING_UM:
            previous = at_x
            yield {"run": run.id, "x_um": float(at_x), "y_um": float(at_y)}


def made_by(run):
    """How a run was made, as the columns of PROVENANCE without the count."""
    found = run.provenance()
    libraries = ", ".join(f"{name} {version}" for name, version in sorted(found.get("libraries", {}).items()))
    return tuple(libraries if name == "libraries" else str(found.get(name, "")) for name in PROVENANCE[1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--plan", "--runs", "--trajectories", "--provenance"):
        parser.add_argument(name, required=True)
    parser.add_argument(
        "--groups", nargs="+", required=True, help="groups of runs whose provenance is told, besides passages"
    )
    parser.add_argument("--brackets", help="folder of the brackets, if their trajectories are wanted too")
    arguments = parser.parse_args()
    plan = read_json(arguments.plan)
    if arguments.brackets:
        found = passage_runs(arguments.plan, arguments.brackets, arguments.runs)
    else:
        found = load_runs(arguments.plan, arguments.runs, "passages")
    passages = {run.id: run for run in found}
    rows = [row for run in passages.values() for row in thumbnail(run, plan["figures"]["trajectory_rows"])]
    styles = {"x_um": ".1f", "y_um": ".1f"}
    write_table(rows, TRAJECTORIES, arguments.trajectories, ["run", "x_um"], styles)
    groups = [load_runs(arguments.plan, arguments.runs, group) for group in arguments.groups]
    every = passages | {run.id: run for runs in groups for run in runs}
    counts = Counter(made_by(run) for run in every.values())
    made = [dict(zip(PROVENANCE, (count, *key), strict=True)) for key, count in counts.items()]
    write_table(made, PROVENANCE, arguments.provenance, PROVENANCE[1:])


main()
