"""The soft end of the boundary is the lattice's: brackets and law on the paper's lattice (grey) and on one
of half the spacing with the plain (green) and the corrected (blue) kernel, over the paper's Eq. (5) and the
ranges in which its text has the class change. Arrows are open ends: the boundary lies beyond.
Marks are single cells on the finer lattice."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import PARAMETERS, UNDISPUTED, brackets_in, law
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.paper import phase_space
from study.paper.claims import load_claims
from study.planning.documents import read_json

COLUMNS = ["kind", "series", "row_shift_um", *UNDISPUTED, "capillary_number", "d_um"]
COLUMNS += ["class", "printed_class"]
PAPER_KINDS = {"Eq. (5)": "law", "text": "bracket"}  # the paper has a law and brackets as a series has
ARROW = {"arrowstyle": "->,head_width=0.25", "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
#: Colour, width and height over its row shift (um) of each series, and its name.
LOOKS = {
    "default": (style.PILLAR, 5.0, 0.0, "0.4 μm, plain kernel: the study"),
    "refined": (style.GREEN, 2.0, 0.07, "0.2 μm, plain kernel"),
    "reference": (style.BLUE, 2.0, -0.07, "0.2 μm, corrected kernel"),
}


def rows_of(boundary, uncertainty, laws, claim):
    """All rows of the figure but the cells: brackets, laws where there is one, and the paper."""
    for series in LOOKS:
        shifts, *ends = brackets_in([boundary, uncertainty], series)
        for shift, low, high in zip(shifts, *ends, strict=True):
            row = {"kind": "bracket", "series": series, "row_shift_um": shift}
            yield row | dict(zip(UNDISPUTED, (low, high), strict=True))
        fit = laws[laws.series == series][list(PARAMETERS)].to_numpy(float)
        if len(fit) and np.isfinite(fit).all():
            curve = phase_space.reached(ends)
            for capillary, d in zip(curve, law(fit[0], curve), strict=True):
                yield {"kind": "law", "series": series, "capillary_number": capillary, "d_um": d}
    for row in phase_space.paper_rows(claim):
        yield row | {"kind": PAPER_KINDS[row["series"]], "series": "paper"}


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
        elif np.isfinite(low) and low < phase_space.LARGEST:
            draw_arrow(axes, low, low * 1.2, place, colour)
    axes.plot([], [], color=colour, lw=width, label=name)


def main():
    arguments = figure_arguments(__doc__, "boundary", "uncertainty", "laws", "cells", "claims")
    plan, claim = read_json(arguments.plan), load_claims(arguments.claims)["phase-boundary"]
    tables = [read_table(path) for path in (arguments.boundary, arguments.uncertainty, arguments.laws)]
    styles = dict.fromkeys(["row_shift_um", "d_um"], ".3f")
    styles |= dict.fromkeys([*UNDISPUTED, "capillary_number"], ".4g")
    cells = read_table(arguments.cells)
    cells = cells[cells.capillary_number <= phase_space.LARGEST].assign(kind="cell", series="refined")
    rows = [*rows_of(*tables, claim), *cells[[name for name in COLUMNS if name in cells]].to_dict("records")]
    write_table(rows, COLUMNS, arguments.csv, styles=styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 4.2)
    axes = figure.add_subplot()
    cells = table[table.kind == "cell"]
    for name, mark in phase_space.MARKS.items():
        own = cells[cells["class"] == name]
        phase_space.draw_cells(axes, own, name, mark, f"{name}, 0.2 μm", zorder=3)
    phase_space.draw_contradictions(axes, cells)
    for series, look in LOOKS.items():
        draw_series(axes, table[(table.series == series) & (table.kind != "cell")], look)
    paper = table[table.series == "paper"]
    curve, ranges = (paper[paper.kind == kind] for kind in PAPER_KINDS.values())
    phase_space.draw_paper(axes, curve, ranges, below_um=0.18, layer=4)
    phase_space.draw_frame(axes)
    style.legend_below(figure, 3)
    style.save(figure, arguments.output, plan["note"])


main()
