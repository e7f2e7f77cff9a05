"""The cells of Fig. 6 on half the lattice spacing, beside the same cells of the grid and the classes that the
paper states: does a class or an extent hang on the lattice?"""

from study.analysis.arguments import table_arguments
from study.analysis.boundary import SAME, printed_class
from study.analysis.runs import load_runs
from study.analysis.tables import read_table, write_table
from study.paper.claims import SWEEP, load_claims

KEYS = ["sweep", "row_shift_um", "capillary_number"]
COLUMNS = [
    *KEYS,
    "dx_um",
    "printed_class",
    "class",
    "as_printed",
    "class_of_grid",
    "d_perp_um",
    "d_perp_of_grid_um",
]
COLUMNS += ["change_percent", "min_face_ratio", "run"]
STYLES = {"row_shift_um": ".1f", "capillary_number": ".4g", "dx_um": ".4f", "min_face_ratio": ".3f"}
STYLES |= {"d_perp_um": ".3f", "d_perp_of_grid_um": ".3f", "change_percent": ".1f"}


def of_grid(passages, row_shift_um, capillary):
    """(class, D_perp in um) of the cell of the grid; (None, None) without one."""
    found = passages[
        (passages.sweep == SWEEP)
        & ((passages.row_shift_um - row_shift_um).abs() < SAME)
        & ((passages.capillary_number - capillary).abs() < SAME)
    ]
    return (found["class"].iloc[0], found.d_perp_um.iloc[0]) if len(found) else (None, None)


def row_of(run, passages, statements):
    """Table row of one cell."""
    shift, capillary, summary = run.row_shift_um, run.case["cell"]["capillary_number"], run.summary
    other, extent = of_grid(passages, shift, capillary)
    own, printed = summary.get("d_perp_um"), printed_class(statements, shift, capillary)
    return {
        "sweep": run.labels["sweep"],
        "row_shift_um": shift,
        "capillary_number": capillary,
        "dx_um": run.dx_um,
        "printed_class": printed,
        "class": summary["status"],
        "as_printed": None if printed is None else int(summary["status"] == printed),
        "class_of_grid": other,
        "d_perp_um": own,
        "d_perp_of_grid_um": extent,
        "change_percent": None if None in (own, extent) else 100 * (own / extent - 1),
        "min_face_ratio": summary.get("min_face_ratio"),
        "run": run.id,
    }


def main():
    arguments = table_arguments(__doc__, "passages", "claims")
    passages = read_table(arguments.passages)
    statements = load_claims(arguments.claims)["phase-boundary"]["statements"]
    runs = load_runs(arguments.plan, arguments.runs, "uncertainty-cells")
    rows = [row_of(run, passages, statements) for run in runs]
    write_table(rows, COLUMNS, arguments.output, KEYS, STYLES)


main()
