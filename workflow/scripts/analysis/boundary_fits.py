"""Fits d = a + b exp(-c Ca) to the boundary of every series and of the paper's own statements, and
joins them to the fits of the separation law."""

import numpy as np
import pandas as pd
from study.analysis.arguments import required_arguments
from study.analysis.boundary import PARAMETERS, brackets_of, fit_boundary
from study.analysis.tables import read_table, write_table
from study.paper.claims import load_claims

COLUMNS = ["name", "parameter", "value", "std_error", "low", "high", "paper_value"]


def fit_rows(name, shifts, low, high, paper):
    """Rows of one fit; none with too few brackets."""
    found = fit_boundary(shifts, low, high)
    if found is None:
        return
    *columns, scatter = found
    for parameter, value, lowest, highest in zip(PARAMETERS, *columns, strict=True):
        row = {"name": name, "parameter": parameter, "value": value}
        yield row | {"low": lowest, "high": highest, "paper_value": paper[parameter]}
    yield {"name": name, "parameter": "scatter_um", "value": scatter}


def statements(claim):
    """The paper's statements on the class as brackets: arrays of row shift, displaced up to, zigzag from."""
    rows = [[s["row_shift_um"], s["displaced_to"], s["zigzag_from"]] for s in claim["statements"]]
    return np.array(rows, dtype=float).T


def main():
    arguments = required_arguments(__doc__, "table", "separation", "claims", "output")
    claim = load_claims(arguments.claims)["phase-boundary"]
    rows = read_table(arguments.separation).to_dict("records")
    boundary = read_table(arguments.table)
    for series in sorted(set(boundary.series)):
        rows += fit_rows(f"boundary/{series}", *brackets_of(boundary, series), claim["value"])
    rows += fit_rows("boundary/paper-text", *statements(claim), claim["value"])
    styles = dict.fromkeys(COLUMNS[2:6], ".4f")
    table = pd.DataFrame(rows, columns=COLUMNS)
    write_table(table.to_dict("records"), COLUMNS, arguments.output, ["name", "parameter"], styles)


main()
