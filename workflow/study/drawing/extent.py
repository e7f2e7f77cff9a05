"""What the figures of the lateral extent share: rows of a sweep, colours, notes."""

import matplotlib.pyplot as plt
import numpy as np

from study.drawing import style

MARKERS = {
    "displaced": "o",
    "zigzag": "^",
    "undecided": "s",
    "diverged": "x",
    "failed": "x",
    "interrupted": "+",
}
GREY = "#777777"


def of_sweep(table, plan):
    """The rows of the sweep over capillary number and row shift at the plan's own lattice."""
    return table[table.sweep == plan["figures"]["trajectory_sweep"]]


def law_of(fits, name):
    """(A_um, B) of a separation law of the table of fits; None if it was not fitted."""
    values = fits[fits.name == name].set_index("parameter").value
    return (values["A_um"], values["B"]) if {"A_um", "B"} <= set(values.index) else None


def shade(number, count):
    """Colour of a series in an ordered family, dark to light."""
    return plt.get_cmap("viridis")(0.92 * number / max(count - 1, 1))


def counted(rows, column):
    """Which classes have no value of this column, in words; empty if none."""
    counts = rows[rows[column].isna()]["class"].value_counts().sort_index()
    return ", ".join(f"{count} {name}" for name, count in counts.items())


def panel_note(axes, text):
    """A remark in the middle of a panel that has nothing else to show."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY)


def note_missing(axes, rows, column):
    """Says above the axes how many cells the panel cannot show."""
    text = counted(rows, column)
    if rows.empty:
        panel_note(axes, "no data")
    elif text:
        axes.set_title(f"not shown: {text}", loc="right", fontsize=7, color=GREY)


def draw_classes(axes, rows, x, y, filled=None):
    """Points in the colours and markers of their classes; `filled`: mask of the filled ones, others open."""
    filled = np.ones(len(rows), bool) if filled is None else np.asarray(filled, bool)
    for name, (colour, label) in style.CLASSES.items():
        for full in (True, False):
            chosen = rows[(rows["class"] == name) & (filled == full) & rows[y].notna()]
            if len(chosen):
                face = colour if full else "none"
                mark = {"ms": 4, "mew": 0.8, "color": colour, "mfc": face, "zorder": 3}
                axes.plot(chosen[x], chosen[y], MARKERS[name], ls="", label=label if full else "", **mark)


def capillary_axis(axes, values):
    """Logarithmic axis of capillary numbers with plain ticks."""
    axes.set_xscale("log")
    values = np.asarray(values, float)
    low, high = (values.min(), values.max()) if len(values) else (0.1, 1.0)
    ticks = [tick for tick in (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2.4) if low / 1.01 <= tick <= high * 1.01]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set(xlim=(low / 1.15, high * 1.15), xlabel="capillary number Ca")
