"""What the phase space of capillary number and row shift shows in every figure that is laid beside the
paper's Fig. 7: its range, the cells with their classes, Eq. (5) and the ranges that its text states."""

import numpy as np

from study.analysis.boundary import PARAMETERS, UNDISPUTED, law
from study.drawing import style

LARGEST = 1.6  # capillary number at the right edge
CURVE = np.linspace(0, LARGEST, 81)  # capillary numbers of the curves
REACH = 1.2  # a fitted curve ends at its outermost brackets times this
MARKS = {"displaced": "o", "zigzag": "s"}


def reached(ends):
    """Capillary numbers of a curve as far as its brackets reach; NaN: an open end."""
    return CURVE[(np.nanmin(ends) / REACH < CURVE) & (np.nanmax(ends) * REACH > CURVE)]


def paper_rows(claim):
    """The paper's Eq. (5), and the ranges in which its text has the class change."""
    for capillary, d in zip(CURVE, law([claim["value"][name] for name in PARAMETERS], CURVE), strict=True):
        yield {"kind": "paper", "series": "Eq. (5)", "capillary_number": capillary, "d_um": d}
    for said in claim["statements"]:
        ends = [said["displaced_to"], said["zigzag_from"]]
        if None not in ends:
            row = {"kind": "paper", "series": "text", "row_shift_um": said["row_shift_um"]}
            yield row | dict(zip(UNDISPUTED, ends, strict=True))


def draw_cells(axes, cells, name, mark, label, **look):
    """Cells of one kind with the look of a class: displaced ones filled, others open."""
    if len(cells):
        colour = style.CLASSES[name][0]
        own = {"ms": 3.2, "mew": 0.7, "color": colour, "mfc": colour if name == "displaced" else "none"}
        axes.plot(cells.capillary_number, cells.row_shift_um, mark, ls="", label=label, **own | look)


def draw_contradictions(axes, cells):
    """A cross on every cell to which the paper's text gives another class."""
    other = cells[cells.printed_class.notna() & (cells["class"] != cells.printed_class)]
    if len(other):
        look = {"color": style.BLACK, "ms": 6, "mew": 1.0, "ls": "", "zorder": 6}
        axes.plot(
            other.capillary_number, other.row_shift_um, "x", label="another class in the paper's text", **look
        )


def draw_paper(axes, curve, ranges, below_um, layer):
    """The rows of Eq. (5), and those of the ranges of the text so far below their row shift (um)."""
    dashes = {"color": style.BLACK, "ls": (0, (5, 2)), "lw": 1.6, "zorder": layer}
    axes.plot(curve.capillary_number, curve.d_um, label="paper, Eq. (5)", **dashes)
    look = {"color": style.BLACK, "lw": 0.7, "ms": 5, "mew": 0.7}
    for row in ranges.to_dict("records"):
        ends = [row[name] for name in UNDISPUTED]
        axes.plot(ends, [row["row_shift_um"] - below_um] * 2, "|-", zorder=layer - 1, **look)
    axes.plot([], [], "|-", label="paper, text: class changes within", **look)


def draw_frame(axes):
    """Names of both regions, axes and their range."""
    place = {"transform": axes.transAxes, "fontsize": 9, "zorder": 6}
    axes.text(0.08, 0.1, "displaced", color=style.BLUE, ha="left", **place)
    axes.text(0.97, 0.88, "zigzag", color=style.VERMILION, ha="right", **place)
    axes.set(xlim=(0, LARGEST), ylim=(1.6, 9.2), xlabel="capillary number Ca", ylabel="row shift $d$ / μm")
