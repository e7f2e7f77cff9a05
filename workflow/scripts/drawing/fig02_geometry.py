"""Figure 2: the geometry. Four shifted unit cells with R, lambda, d, G, alpha and the gap line."""

import math

import matplotlib.pyplot as plt
import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import write_table
from study.drawing import style
from study.planning.documents import read_json

RADIUS, PITCH, SHIFT, DEPTH = 10.0, 32.0, 8.0, 4.8  # um; the row shift is that of eps = 20/80


def arrow(axes, start, end, text, place, **options):
    """A dimension line with arrow heads at both ends and its symbol."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0, "lw": 0.8})
    axes.text(*place, text, **options)


def draw(axes):
    """Pillars, cells and dimensions."""
    middle = {"ha": "center", "va": "center"}
    for column in range(2):
        for row in range(2):
            centre = np.array([column * PITCH, row * PITCH + column * SHIFT])
            corner = centre - PITCH / 2
            axes.add_patch(plt.Rectangle(corner, PITCH, PITCH, fill=False, ec=style.SKY, lw=0.8))
            axes.add_patch(plt.Circle(centre, RADIUS, fc=style.PILLAR, ec="none"))
        gap = [column * PITCH] * 2, [column * SHIFT + RADIUS, column * SHIFT + PITCH - RADIUS]
        axes.plot(*gap, color=style.VERMILION, ls=(0, (4, 2)), lw=1.2)
    arrow(axes, (0, 0), (-RADIUS * 0.8, RADIUS * 0.6), "$R$", (-1.5, 5), **middle)
    arrow(axes, (2, RADIUS), (2, PITCH - RADIUS), "$G$", (5, PITCH / 2), **middle)
    arrow(axes, (-12.5, 0), (-12.5, PITCH), r"$\lambda$", (-14.3, PITCH / 2 - 5), **middle)
    axes.plot([-13.5, 0], [0, 0], [-13.5, 0], [PITCH, PITCH], color=style.BLACK, lw=0.4)
    top = PITCH + SHIFT + 19  # above the unit cells
    arrow(axes, (0, top), (PITCH, top), r"$\lambda$", (PITCH / 2, top + 2.5), **middle)
    axes.plot([0, 0], [PITCH, top + 1], [PITCH] * 2, [PITCH + SHIFT, top + 1], color=style.BLACK, lw=0.4)
    right = 1.5 * PITCH + 3  # beside the unit cells
    axes.plot([0, right + 1], [0, 0], [0, PITCH], [0, SHIFT], color=style.BLACK, lw=0.6)
    axes.plot([PITCH, right + 1], [SHIFT, SHIFT], color=style.BLACK, lw=0.4)
    arrow(axes, (right, 0), (right, SHIFT), "$d$", (right + 2.5, SHIFT / 2), **middle)
    angle = np.linspace(0, math.atan(SHIFT / PITCH), 20)
    axes.plot(21 * np.cos(angle), 21 * np.sin(angle), color=style.BLACK, lw=0.6)
    axes.text(18, 1.9, r"$\alpha$", **middle)
    axes.annotate("", (-18, 8), (-27, 8), arrowprops={"arrowstyle": "-|>", "lw": 1.2, "color": style.BLUE})
    axes.text(-22.5, 10.5, "flow", color=style.BLUE, **middle)
    axes.text(PITCH + 1.5, SHIFT + PITCH - RADIUS - 2.5, "gap line", color=style.VERMILION, va="center")
    axes.set(xlim=(-28, right + 5), ylim=(-17, top + 5), aspect="equal")
    axes.set_axis_off()


def main():
    arguments = figure_arguments(__doc__)
    values = {
        "R": (RADIUS, "um"),
        "lambda": (PITCH, "um"),
        "G = lambda - 2 R": (PITCH - 2 * RADIUS, "um"),
        "H": (DEPTH, "um"),
        "d (as drawn)": (SHIFT, "um"),
        "epsilon = d / lambda (as drawn)": (SHIFT / PITCH, "1"),
        "alpha = atan(epsilon) (as drawn)": (math.degrees(math.atan(SHIFT / PITCH)), "degree"),
    }
    rows = [{"quantity": name, "value": value, "unit": unit} for name, (value, unit) in values.items()]
    write_table(rows, ["quantity", "value", "unit"], arguments.csv)
    figure = style.new_figure(style.COLUMN, 3.0)
    draw(figure.add_subplot())
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
