"""Fits the separation law 2 s = A epsilon^B to every variant of the flow and to the paper's printed table."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table, write_table
from study.numerics.fits import bootstrap_power_law, fit_power_law
from study.paper.claims import load_claims

PARAMETERS = ["A_um", "B"]
PITCH_UM = 32.0  # of the printed table


def fitted(name, epsilon, separation_um, paper):
    """Rows of one fit, or none if it has fewer than three points."""
    if len(epsilon) < 3:
        return []
    values, errors = fit_power_law(epsilon, 2 * separation_um)
    intervals = bootstrap_power_law(epsilon, 2 * separation_um)
    return [
        {
            "name": name,
            "parameter": parameter,
            "value": value,
            "std_error": error,
            "low": low,
            "high": high,
            "paper_value": paper[parameter],
        }
        for parameter, value, error, (low, high) in zip(PARAMETERS, values, errors, intervals, strict=True)
    ]


def main():
    arguments = required_arguments(__doc__, "table", "claims", "output")
    claims = load_claims(arguments.claims)
    law, printed = claims["separation-law"]["value"], claims["table-1"]["value"]
    table = read_table(arguments.table)
    table = table[(table.status == "converged") & (table.s_um > 0)]
    rows = []
    for variant, group in table.groupby("variant"):
        rows += fitted(f"separation-law/{variant}", group.epsilon.to_numpy(), group.s_um.to_numpy(), law)
    shifts, separations = np.array(sorted((float(d), s) for d, s in printed.items())).T
    rows += fitted("separation-law/printed-table", shifts / PITCH_UM, separations, law)
    write_table(
        rows,
        ["name", "parameter", "value", "std_error", "low", "high", "paper_value"],
        arguments.output,
        ["name", "parameter"],
        dict.fromkeys(["value", "std_error", "low", "high"], ".4f"),
    )


main()
