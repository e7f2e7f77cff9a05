"""Diameters of the stretched cell against the force, for every series and Skalak denominator."""

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.stretching import rows_of
from study.analysis.tables import write_table

COLUMNS = [
    "method",
    "skalak_denominator",
    "force_pN",
    "axial_um",
    "transverse_um",
    "mesh_frequency",
    "area_over_radius_squared",
    "status",
    "run",
]


def main():
    arguments = table_arguments(__doc__)
    runs = load_runs(arguments.plan, arguments.runs, "stretching")
    rows = [row for run in runs for row in rows_of(run)]
    styles = {"axial_um": ".4f", "transverse_um": ".4f", "area_over_radius_squared": ".4f", "force_pN": ".1f"}
    write_table(rows, COLUMNS, arguments.output, ["method", "skalak_denominator", "force_pN"], styles)


main()
