"""Chi squared of the simulated stretching curves against each set of experiments, axial and transverse
diameter separately, and the Skalak denominator that fits best (parabola in its logarithm; empty if it is at
the end of the examined range). The sets are never mixed; points without an error bar are left out."""

from study.analysis.arguments import required_arguments
from study.analysis.measured import read_measured
from study.analysis.tables import read_table, write_table
from study.numerics.fits import chi_squared, parabola_minimum

DIAMETERS = {
    "axial": ("axial_um", "DA_um", "DA_err_um"),
    "transverse": ("transverse_um", "DT_um", "DT_err_um"),
}
MAX_FORCES_PN = [100.0, 200.0]
COLUMNS = [
    "set",
    "diameter",
    "max_force_pN",
    "points",
    "skalak_denominator",
    "chi2",
    "chi2_per_point",
    "within_error_bars",
    "best_denominator",
]


def rows_of(curves, experiment, set_name, diameter, max_force):
    """Rows for one set of experiments and one diameter, one for each denominator."""
    simulated, value, error = DIAMETERS[diameter]
    chosen = experiment[(experiment.set == set_name) & (experiment.F_pN > 0) & (experiment.F_pN <= max_force)]
    points = chosen[["F_pN", value, error]].dropna().to_numpy()
    rows = []
    for denominator, curve in curves.groupby("skalak_denominator"):
        force, length = curve.force_pN.to_numpy(), curve[simulated].to_numpy()
        single = [chi_squared(force, length, [point]) for point in points if point[0] <= force.max()]
        if not single:
            continue
        row = {"set": set_name, "diameter": diameter, "max_force_pN": max_force, "points": len(single)}
        row |= {"skalak_denominator": denominator, "chi2": sum(single)}
        row |= {"chi2_per_point": sum(single) / len(single), "within_error_bars": sum(c <= 1 for c in single)}
        rows.append(row)
    if rows:
        best = parabola_minimum([row["skalak_denominator"] for row in rows], [row["chi2"] for row in rows])
        rows = [row | {"best_denominator": best} for row in rows]
    return rows


def main():
    arguments = required_arguments(__doc__, "table", "experiment", "output")
    table = read_table(arguments.table)
    curves = table[(table.method == "static") & (table.status == "converged")]
    experiment = read_measured(arguments.experiment)
    rows = []
    for set_name in sorted(experiment.set.unique()):
        for diameter in DIAMETERS:
            for max_force in MAX_FORCES_PN:
                rows += rows_of(curves, experiment, set_name, diameter, max_force)
    styles = {"chi2": ".3f", "chi2_per_point": ".3f", "best_denominator": ".2f"}
    keys = ["set", "diameter", "max_force_pN", "skalak_denominator"]
    write_table(rows, COLUMNS, arguments.output, keys, styles)


main()
