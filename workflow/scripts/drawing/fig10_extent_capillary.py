"""Figure 10: lateral extent D_perp against the capillary number, filled where the paper finds one curve
for all row shifts, with the four extents that it prints (Fig. 8) and the transverse diameter of the
optical tweezer at Ca_tw = (2 F / A) r / kS = Ca."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.analysis.tweezer import TweezerCurve
from study.drawing import style
from study.drawing.extent import GREY, capillary_axis, draw_classes, note_missing, of_sweep
from study.paper.claims import load_claims
from study.planning.documents import read_json

COLUMNS = ["row_shift_um", "capillary_number", "class", "in_window", "d_perp_um"]
LINES = [(0, (1, 1)), (0, (5, 2)), (0, (3, 1, 1, 1))]


def draw_tweezer(axes, curve, denominators, cell):
    """Diameter of the tweezer for every denominator, that of the cells strongest."""
    numbers = np.geomspace(0.05, 3, 200)
    lines = iter(LINES * 3)
    for denominator in sorted(denominators, reverse=True):
        diameters = np.array([curve.diameter(number, denominator) for number in numbers])
        look = (
            {"color": style.BLACK, "lw": 1.4}
            if denominator == cell
            else {"color": GREY, "lw": 0.8, "ls": next(lines)}
        )
        if np.isfinite(diameters).any():
            axes.plot(numbers, diameters, label=rf"tweezer, $k$ = {denominator:g}", **look)


def main():
    arguments = figure_arguments(__doc__, "table", "stretching", "claims")
    plan, curve = read_json(arguments.plan), TweezerCurve(read_table(arguments.stretching))
    rows = of_sweep(read_table(arguments.table), plan)
    claims = load_claims(arguments.claims)
    low, high = claims["collapse"]["value"]
    rows = rows.assign(in_window=rows.row_shift_um.between(low - 1e-6, high + 1e-6))
    denominators = plan["figures"]["tweezer_denominators"]
    cell = rows.skalak_denominator.iloc[0] if len(rows) else max(denominators)
    names = [f"tweezer_{denominator:g}_um" for denominator in denominators]
    for name, denominator in zip(names, denominators, strict=True):
        rows[name] = [curve.diameter(number, denominator) for number in rows.capillary_number]
    styles = dict.fromkeys(["d_perp_um", *names], ".3f") | {"row_shift_um": ".1f", "capillary_number": ".4g"}
    write_table(rows.to_dict("records"), COLUMNS + names, arguments.csv, COLUMNS[:2], styles)
    figure = style.new_figure(style.COLUMN, 3.5)
    axes = figure.add_subplot()
    draw_classes(axes, rows, "capillary_number", "d_perp_um", rows.in_window)
    axes.plot([], [], "o", color=GREY, mfc="none", label=rf"open: not {low:g} ... {high:g} μm")
    draw_tweezer(axes, curve, denominators, cell)
    printed = {float(number): extent for number, extent in claims["d-perp-6.8"]["value"].items()}
    look = {"color": style.BLACK, "ms": 7, "mew": 1.4, "ls": "", "zorder": 5}
    axes.plot(printed.keys(), printed.values(), "x", label="paper, Fig. 8", **look)
    capillary_axis(axes, rows.capillary_number)
    axes.set_ylabel(r"lateral extent $D_\perp$ / μm")
    axes.set_ylim(3, 8)
    style.legend_below(figure, 2, fontsize=7)
    note_missing(axes, rows, "d_perp_um")
    style.save(figure, arguments.output, plan["note"])


main()
