"""Measured times of every stage from Snakemake's benchmark files, in seconds of one core: for the README.
Unlike all other tables this one differs from machine to machine."""

import statistics

from study.analysis.arguments import table_arguments
from study.analysis.runs import bracket_runs, load_runs
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["stage", "part", "dx_um", "runs", "total_s", "median_s", "longest_s"]
STYLES = {"dx_um": ".4f", "total_s": ".1f", "median_s": ".1f", "longest_s": ".1f"}
PART = {"streamlines": "variant", "stretching": "series", "passages": "sweep", "sensitivity": "choice"}


def part_of(run):
    """Sweep, series, variant or choice of a run, whatever its stage calls it."""
    return run.labels.get(PART.get(run.group, "sweep"), "").removeprefix("boundary/")


def main():
    arguments = table_arguments(__doc__, "brackets")
    groups = dict.fromkeys(run["group"] for run in read_json(arguments.plan)["runs"])
    runs = [run for group in groups for run in load_runs(arguments.plan, arguments.runs, group)]
    runs += bracket_runs(arguments.plan, arguments.brackets, arguments.runs)
    stages, counted = {}, set()
    for run in runs:  # a run that several stages share counts in the first of them
        seconds = run.core_s()
        if run.id not in counted and seconds is not None:
            counted.add(run.id)
            stages.setdefault((run.group, part_of(run), run.dx_um), []).append(seconds)
    rows = [
        {
            "stage": stage,
            "part": part,
            "dx_um": dx,
            "runs": len(seconds),
            "total_s": sum(seconds),
            "median_s": statistics.median(seconds),
            "longest_s": max(seconds),
        }
        for (stage, part, dx), seconds in stages.items()
    ]
    write_table(rows, COLUMNS, arguments.output, ["stage", "part", "dx_um"], STYLES)


main()
