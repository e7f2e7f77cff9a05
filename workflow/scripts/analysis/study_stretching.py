"""Diameters of the stretched cells of a study against the force, for every series and its cell."""

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.stretching import rows_of
from study.analysis.tables import write_table

COLUMNS = ["series", "cell", "method", "skalak_denominator", "force_pN", "axial_um", "transverse_um"]
COLUMNS += ["mesh_frequency", "status", "run"]
STYLES = {"axial_um": ".4f", "transverse_um": ".4f", "force_pN": ".1f"}


def main():
    arguments = table_arguments(__doc__)
    runs = load_runs(arguments.plan, arguments.runs, "stretching")
    rows = [
        {"series": run.labels["series"], "cell": run.labels.get("cell")} | row
        for run in runs
        for row in rows_of(run)
    ]
    keys = ["series", "skalak_denominator", "force_pN"]
    write_table(rows, COLUMNS, arguments.output, keys, STYLES)


main()
