"""Figure 9: lateral extent D_perp against the row shift with the printed law Eq. (4), its printed
multiple and the multiple that separates displaced from zigzag best. The table of factors beside it has
the same for the law fitted here, and how many cells each leaves on the wrong side."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import GREY, draw_classes, law_of, note_missing, of_sweep
from study.numerics.fits import power_law
from study.paper.claims import load_claims
from study.planning.classes import DECIDED
from study.planning.documents import read_json

PITCH = 32.0  # um
POINTS = ["row_shift_um", "epsilon", "capillary_number", "class", "d_perp_um", "run"]
FACTORS = ["law", "A_um", "B", "factor", "which", "factor_low", "factor_high", "misclassified", "cells"]


def misclassified(ratio, displaced, factor):
    """Cells on the wrong side of D_perp = factor * law; `ratio` is D_perp / law of every cell."""
    return int(np.sum((ratio > factor) != displaced))


def best_factor(ratio, displaced):
    """(factor, low, high): the widest interval of factors with the fewest cells on the wrong side.

    The number changes at the ratios alone, so the intervals between sorted ratios are all there is to try.
    """
    ends = np.unique(ratio)
    edges = np.concatenate([[ends[0] / 1.05], ends, [ends[-1] * 1.05]])
    middles = np.sqrt(edges[:-1] * edges[1:])
    wrong = np.array([misclassified(ratio, displaced, middle) for middle in middles])
    width = np.where(wrong == wrong.min(), np.log(edges[1:] / edges[:-1]), -1)
    k = int(np.argmax(width))
    return middles[k], edges[k], edges[k + 1]


def factor_rows(rows, laws, printed_factor):
    """Cells on the wrong side for every law with the factors 1, the printed one and the best one."""
    decided = rows[rows["class"].isin(DECIDED) & rows.d_perp_um.notna()]
    displaced = (decided["class"] == "displaced").to_numpy()
    for name, (a, b) in laws.items():
        row = {"law": name, "A_um": a, "B": b, "cells": len(decided)}
        ratio = (decided.d_perp_um / power_law(decided.epsilon, a, b)).to_numpy()
        for which, factor in (("one", 1.0), ("printed", printed_factor)):
            wrong = misclassified(ratio, displaced, factor)
            yield row | {"which": which, "factor": factor, "misclassified": wrong}
        if 0 < displaced.sum() < len(displaced):  # one class alone is separated by anything
            best, low, high = best_factor(ratio, displaced)
            row |= {"which": "best", "factor": best, "factor_low": low, "factor_high": high}
            yield row | {"misclassified": misclassified(ratio, displaced, best)}


def draw(axes, rows, printed, factor, factors):
    """Cells, the printed law and its printed multiple, and the multiple that separates best."""
    draw_classes(axes, rows, "row_shift_um", "d_perp_um")
    shifts = np.linspace(1.6, 9.2, 100)
    law = power_law(shifts / PITCH, *printed)
    axes.plot(shifts, law, color=style.BLACK, lw=1.4, label="paper, Eq. (4)")
    label = rf"paper, {factor:g} $\times$ Eq. (4)"
    axes.plot(shifts, factor * law, color=style.BLACK, lw=1.4, ls=(0, (5, 2)), label=label)
    best = [row for row in factors if row["law"] == "printed" and row["which"] == "best"]
    for row in best:
        label = rf"best here, {row['factor']:.3g} $\times$ Eq. (4)"
        axes.plot(shifts, row["factor"] * law, color=GREY, lw=0.8, ls=(0, (1, 1)), label=label)
    axes.set(xlabel=r"row shift $d$ / μm", ylabel=r"lateral extent $D_\perp$ / μm", xlim=(1.6, 9.2))
    axes.set_ylim(0, 8)
    note_missing(axes, rows, "d_perp_um")


def main():
    arguments = figure_arguments(__doc__, "table", "fits", "claims", "factors")
    plan, claims = read_json(arguments.plan), load_claims(arguments.claims)
    rows = of_sweep(read_table(arguments.table), plan)
    printed = claims["separation-law"]["value"]
    laws = {"fitted": law_of(read_table(arguments.fits), "separation-law/refined")}
    laws = {name: law for name, law in laws.items() if law} | {"printed": (printed["A_um"], printed["B"])}
    printed_factor = claims["sharp-separation"]["value"]["factor"]
    factors = list(factor_rows(rows, laws, printed_factor))
    styles = {"row_shift_um": ".1f", "epsilon": ".4f", "capillary_number": ".4g", "d_perp_um": ".3f"}
    write_table(rows.to_dict("records"), POINTS, arguments.csv, POINTS[:3], styles)
    write_table(factors, FACTORS, arguments.factors, styles=dict.fromkeys(FACTORS[1:7], ".4f"))
    figure = style.new_figure(style.COLUMN, 3.3)
    axes = figure.add_subplot()
    draw(axes, rows, laws["printed"], printed_factor, factors)
    style.legend_below(figure, 2, fontsize=7)
    style.save(figure, arguments.output, plan["note"])


main()
