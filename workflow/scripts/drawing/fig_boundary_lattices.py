"""The soft end of the boundary is the lattice's: brackets and law on the paper's lattice (grey) and on one
of half the spacing with the plain (green) and the corrected (blue) kernel, over the paper's Eq. (5) and the
ranges in which its text has the class change. Arrows are open ends: the boundary lies beyond.
Marks are single cells on the finer lattice."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import PARAMETERS, UNDISPUTED, law
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.paper.claims import load_claims
from study.planning.documents import read_json

COLUMNS = ["kind", "series", "row_shift_um", *UNDISPUTED, "capillary_number", "d_um"]
COLUMNS += ["class", "printed_class"]
LARGEST = 1.6  # capillary number at the right edge, as in Fig. 7
CURVE = np.linspace(0, LARGEST, 81)
REACH = 1.2  # a fitted curve ends at its outermost brackets times this
ARROW = {"arrowstyle": "->,head_width=0.25", "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
#: Colour, width and height over its row shift (um) of each series, and its name.
LOOKS = {
    "default": (style.PILLAR, 5.0, 0.0, "0.4 μm, plain kernel: the study"),
    "refined": (style.GREEN, 2.0, 0.07, "0.2 μm, plain kernel"),
    "reference": (style.BLUE, 2.0, -0.07, "0.2 μm, corrected kernel"),
}


def rows_of(boundary, uncertainty, laws, claim):
    """All rows of the figure: brackets, laws where there is one, and the paper."""
    for series in LOOKS:
        table = boundary if (boundary.series == series).any() else uncertainty
        own = table[table.series == series].drop_duplicates("row_shift_um")
        ends = own[UNDISPUTED].to_numpy(float)
        for shift, (low, high) in zip(own.row_shift_um, ends, strict=True):
            yield {"kind": "bracket", "series": series, "row_shift_um": shift} | dict(
                zip(UNDISPUTED, (low, high), strict=True)
            )
        fit = laws[laws.series == series][list(PARAMETERS)].to_numpy(float)
        if len(fit) and np.isfinite(fit).all():
            curve = CURVE[(np.nanmin(ends) / REACH < CURVE) & (np.nanmax(ends) * REACH > CURVE)]
            for capillary, d in zip(curve, law(fit[0], curve), strict=True):
                yield {"kind": "law", "series": series, "capillary_number": capillary, "d_um": d}
    for capillary, d in zip(CURVE, law([claim["value"][name] for name in PARAMETERS], CURVE), strict=True):
        yield {"kind": "law", "series": "paper", "capillary_number": capillary, "d_um": d}
    for said in claim["statements"]:
        ends = [said["displaced_to"], said["zigzag_from"]]
        if None not in ends:
            row = {"kind": "bracket", "series": "paper", "row_shift_um": said["row_shift_um"]}
            yield row | dict(zip(UNDISPUTED, ends, strict=True))


def draw_arrow(axes, end, beyond, place, colour):
    """An open end of a bracket."""
    axes.annotate("", (beyond, place), (end, place), arrowprops=ARROW | {"color": colour}, zorder=4)


def draw_series(axes, rows, look):
    """Law and brackets of one series."""
    colour, width, above, name = look
    curve = rows[rows.kind == "law"]
    axes.plot(curve.capillary_number, curve.d_um, color=colour, lw=width / 2, zorder=2)
    for row in rows[rows.kind == "bracket"].to_dict("records"):
        low, high = (row[end] for end in UNDISPUTED)
        place = row["row_shift_um"] + above
        if np.isfinite(low + high):
            bar = {"color": colour, "lw": width, "ms": 6, "mew": 1.2, "solid_capstyle": "butt"}
            axes.plot([low, high], [place] * 2, "|-", zorder=4, **bar)
        elif np.isfinite(high):
            draw_arrow(axes, high, high / 1.5, place, colour)
        elif np.isfinite(low) and low < LARGEST:
            draw_arrow(axes, low, low * 1.2, place, colour)
    axes.plot([], [], color=colour, lw=width, label=name)


def draw_cells(axes, cells):
    """Single cells on the finer lattice: displaced filled, zigzag open; a cross where the paper has another
    class."""
    for name, marker in (("displaced", "o"), ("zigzag", "s")):
        rows, colour = cells[cells["class"] == name], style.CLASSES[name][0]
        look = {"ms": 3.2, "mew": 0.7, "color": colour, "mfc": colour if name == "displaced" else "none"}
        if len(rows):
            label = f"{name}, 0.2 μm"
            axes.plot(rows.capillary_number, rows.row_shift_um, marker, ls="", label=label, zorder=3, **look)
    other = cells[cells.printed_class.notna() & (cells["class"] != cells.printed_class)]
    if len(other):
        look = {"color": style.BLACK, "ms": 6, "mew": 1.0, "ls": "", "zorder": 6}
        axes.plot(
            other.capillary_number, other.row_shift_um, "x", label="another class in the paper's text", **look
        )


def draw_paper(axes, rows):
    """Eq. (5) and the ranges of the text."""
    curve = rows[rows.kind == "law"]
    dashes = {"color": style.BLACK, "ls": (0, (5, 2)), "lw": 1.6, "zorder": 3}
    axes.plot(curve.capillary_number, curve.d_um, label="paper, Eq. (5)", **dashes)
    for row in rows[rows.kind == "bracket"].to_dict("records"):
        ends = [row[end] for end in UNDISPUTED]
        look = {"color": style.BLACK, "lw": 0.7, "ms": 5, "mew": 0.7}
        axes.plot(ends, [row["row_shift_um"] - 0.18] * 2, "|-", zorder=3, **look)
    axes.plot([], [], "|-", label="paper, text: class changes within", **look)


def main():
    arguments = figure_arguments(__doc__, "boundary", "uncertainty", "laws", "cells", "claims")
    plan, claim = read_json(arguments.plan), load_claims(arguments.claims)["phase-boundary"]
    tables = [read_table(path) for path in (arguments.boundary, arguments.uncertainty, arguments.laws)]
    styles = dict.fromkeys(["row_shift_um", "d_um"], ".3f")
    styles |= dict.fromkeys([*UNDISPUTED, "capillary_number"], ".4g")
    cells = read_table(arguments.cells)
    cells = cells[cells.capillary_number <= LARGEST].assign(kind="cell", series="refined")
    rows = [*rows_of(*tables, claim), *cells[[name for name in COLUMNS if name in cells]].to_dict("records")]
    write_table(rows, COLUMNS, arguments.csv, styles=styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 4.2)
    axes = figure.add_subplot()
    draw_cells(axes, table[table.kind == "cell"])
    for series, look in LOOKS.items():
        draw_series(axes, table[(table.series == series) & (table.kind != "cell")], look)
    draw_paper(axes, table[table.series == "paper"])
    place = {"transform": axes.transAxes, "fontsize": 9}
    axes.text(0.08, 0.1, "displaced", color=style.BLUE, **place)
    axes.text(0.97, 0.88, "zigzag", color=style.VERMILION, ha="right", **place)
    axes.set(xlim=(0, LARGEST), ylim=(1.6, 9.2), xlabel="capillary number Ca", ylabel="row shift $d$ / μm")
    style.legend_below(figure, 3)
    style.save(figure, arguments.output, plan["note"])


main()
