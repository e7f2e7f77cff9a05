"""The boundary on the paper's lattice and on one of half the spacing, with the plain and the corrected
kernel: the law d = a + b exp(-c Ca) through the brackets of each, and how far it lies from the paper's
Eq. (5)."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.boundary import PARAMETERS, brackets_in, fit_boundary, law
from study.analysis.tables import read_table, write_table
from study.paper.claims import load_claims

#: Series of the study and of the target `uncertainty`, with their lattice spacing (um) and kernel.
SERIES = {
    "default": (0.4, "plain"),
    "corrected": (0.4, "corrected"),
    "refined": (0.2, "plain"),
    "reference": (0.2, "corrected"),
}
RANGE = np.linspace(0.1, 0.7, 61)  # capillary numbers over which two laws are compared
BOUNDS = [f"{name}_{end}" for name in PARAMETERS for end in ("low", "high")]
CAPILLARY = ["from_ca", "to_ca", "at_ca"]
COLUMNS = ["series", "lattice_um", "kernel", "brackets", *PARAMETERS, *BOUNDS, "scatter_um"]
COLUMNS += ["from_ca", "to_ca", "largest_distance_um", "at_ca"]


def row_of(series, found, count, printed):
    """One row: the law of a series, with its 95 % interval, and its largest distance from the printed law."""
    spacing, kernel = SERIES[series]
    row = {"series": series, "lattice_um": spacing, "kernel": kernel, "brackets": count}
    if found is None:
        return row
    values, low, high, scatter = found
    row |= dict(zip(PARAMETERS, values, strict=True)) | {"scatter_um": scatter}
    row |= dict(zip(BOUNDS, np.column_stack([low, high]).ravel(), strict=True))
    distance = law(values, RANGE) - law(printed, RANGE)
    largest = int(np.argmax(np.abs(distance)))
    row |= {"from_ca": RANGE[0], "to_ca": RANGE[-1]}
    return row | {"largest_distance_um": abs(distance[largest]), "at_ca": RANGE[largest]}


def main():
    arguments = required_arguments(__doc__, "boundary", "uncertainty", "claims", "output")
    claim = load_claims(arguments.claims)["phase-boundary"]["value"]
    printed = [claim[name] for name in PARAMETERS]
    tables = [read_table(arguments.boundary), read_table(arguments.uncertainty)]
    rows = []
    for series in SERIES:
        shifts, low, high = brackets_in(tables, series)
        count = int((~np.isnan(low + high)).sum())
        rows.append(row_of(series, fit_boundary(shifts, low, high), count, printed))
    styles = dict.fromkeys([*PARAMETERS, *BOUNDS, "scatter_um", "largest_distance_um"], ".3f")
    write_table(rows, COLUMNS, arguments.output, styles=styles | dict.fromkeys(CAPILLARY, ".2f"))


main()
