"""Drawing of the words: (a) the array with its lengths, a displaced and a zigzag path; (b) a cell in
the gap with the lengths that decide its class. Paths and outline are sketches, not results."""

import numpy as np
from matplotlib.patches import Ellipse
from study.analysis.arguments import figure_arguments
from study.analysis.tables import write_table
from study.drawing import style
from study.drawing.style import plt
from study.planning.documents import read_json

RADIUS, PITCH, SHIFT = 10.0, 32.0, 8.0  # um; the row shift is that of eps = 1/4
GAP = PITCH - 2 * RADIUS
ROWS, LANES = 5, 2
SEPARATION, EXTENT, FILM = 3.3, 5.6, 1.0  # um; s, D_perp and the film as drawn, the film too thick to be seen
MIDDLE = {"ha": "center", "va": "center"}


def dimension(axes, start, end, text, place, colour=style.BLACK, **options):
    """A line with arrow heads at both ends and the word for its length."""
    look = {"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0, "lw": 0.8, "color": colour, "mutation_scale": 7}
    axes.annotate("", end, start, arrowprops=look)
    axes.text(*place, text, color=colour, **(MIDDLE | options))


def around(rows, lane, heights):
    """A smooth path: at row n the given height above the pillar's top in lane `lane` (counted at row 0)."""
    x = np.array([row * PITCH for row in rows], float)
    y = np.array([lane[k] * PITCH + row * SHIFT + RADIUS + heights[k] for k, row in enumerate(rows)])
    fine = np.linspace(x[0], x[-1], 200)
    share = (fine[:, None] - x[None, :]) / PITCH
    weights = np.where(np.abs(share) < 1, 0.5 * (1 + np.cos(np.pi * np.clip(share, -1, 1))), 0)
    return fine, weights @ y


def draw_paths(axes):
    """A displaced and a zigzag path with their names."""
    rows = range(ROWS)
    paths = {"displaced": around(rows, [1] * ROWS, [3.0] * ROWS)}
    paths["zigzag"] = around(rows, [0, 0, 0, -1, -1], [5.5, 4.2, 3.0, 9.0, 5.0])
    for name, (x, y) in paths.items():
        colour = style.CLASSES[name][0]
        axes.plot(x, y, color=colour, lw=1.6)
        head = {"arrowstyle": "-|>", "color": colour, "lw": 1.6}
        axes.annotate("", (x[-1] + 6, y[-1]), (x[-1] - 1, y[-1]), arrowprops=head)
        axes.text(-14, y[0], name, color=colour, ha="right", va="center", weight="bold")
    head = {"arrowstyle": "->", "color": colour, "lw": 0.8}
    place = (2.55 * PITCH, 0.55 * PITCH), (3.4 * PITCH, -0.8 * PITCH)
    axes.annotate("falls back (a zig)", *place, color=colour, arrowprops=head, **MIDDLE)


def draw_array(axes):
    """Panel (a)."""
    last = (ROWS - 1) * PITCH
    for row in range(ROWS):
        for lane in range(-1, LANES + 1):
            centre = (row * PITCH, lane * PITCH + row * SHIFT)
            axes.add_patch(plt.Circle(centre, RADIUS, fc=style.PILLAR, ec="none"))
    ends = np.array([-0.4 * PITCH, last + 0.4 * PITCH])
    low = PITCH + SHIFT * ends / PITCH
    axes.fill_between(ends, low, low + PITCH, color=style.YELLOW, alpha=0.25, lw=0, zorder=0)
    axes.text(3.5 * PITCH, PITCH * 1.5 + 3.5 * SHIFT + 4, "a lane", rotation=14, **MIDDLE)
    draw_paths(axes)
    right, heights = last + RADIUS + 5, [PITCH + row * SHIFT for row in (ROWS - 2, ROWS - 1)]
    for start, height, dashes in ((last - PITCH, heights[0], ":"), (last, heights[1], "-")):
        axes.plot([start, right + 3], [height] * 2, color=style.BLACK, lw=0.6, ls=dashes)
    place = (right + 3, sum(heights) / 2)
    dimension(axes, (right, heights[0]), (right, heights[1]), "row shift $d$", place, ha="left")
    top = LANES * PITCH + RADIUS + SHIFT + 4
    dimension(axes, (0, top), (PITCH, top), r"pitch $\lambda$", (PITCH / 2, top + 4))
    for row in range(2):
        axes.plot([row * PITCH] * 2, [LANES * PITCH + row * SHIFT, top + 2], color=style.BLACK, lw=0.5)
    gap = SHIFT - RADIUS
    dimension(axes, (PITCH, gap - GAP), (PITCH, gap), "gap $G$", (PITCH + 2, gap - GAP / 2), ha="left")
    axes.text(last, LANES * PITCH + (ROWS - 1) * SHIFT + 15, "one row", **MIDDLE)
    axes.annotate("", (-16, -14), (-32, -14), arrowprops={"arrowstyle": "-|>", "lw": 1.6})
    axes.text(-24, -9.5, "flow", **MIDDLE)
    axes.set(xlim=(-36, right + 28), ylim=(-30, top + 42), aspect="equal")
    axes.set_axis_off()


def draw_gap(axes):
    """Panel (b): one gap, the cell touches the lower pillar."""
    for y in (-RADIUS, GAP + RADIUS):
        axes.add_patch(plt.Circle((0, y), RADIUS, fc=style.PILLAR, ec="none"))
    axes.plot([0, 0], [0, GAP], color="#777777", ls=(0, (3, 2)), lw=0.8)
    axes.text(0.4, GAP - 0.9, "gap line", color="#777777", ha="left", va="center")
    x = np.linspace(-11, 11, 121)
    axes.plot(x, SEPARATION + 0.017 * x**2 - 0.0012 * x**3 * (x > 0), color=style.GREEN, lw=1.4, ls="--")
    axes.text(-11, SEPARATION + 2.6, "separation\nstreamline", color=style.GREEN, ha="left", va="bottom")
    colour = style.CLASSES["displaced"][0]
    centre = FILM + EXTENT / 2
    axes.add_patch(Ellipse((0, centre), 9.5, EXTENT, fc=colour, alpha=0.25, ec="none"))
    axes.add_patch(Ellipse((0, centre), 9.5, EXTENT, fc="none", ec=colour, lw=1.4))
    axes.plot(0, centre, ".", color=colour, ms=5)
    axes.plot([0, 7.6], [FILM + EXTENT] * 2, [0, 7.6], [FILM] * 2, color=colour, lw=0.5)
    dimension(axes, (6.8, FILM), (6.8, FILM + EXTENT), r"$D_\perp$", (8.3, centre + 0.6), colour)
    dimension(axes, (-1.3, 0), (-1.3, SEPARATION), "$s$", (-2.3, SEPARATION / 2), style.GREEN)
    axes.annotate(
        "film", (0.6, FILM / 2), (6.5, -2.0), va="center", arrowprops={"arrowstyle": "-", "lw": 0.6}
    )
    axes.text(0, -RADIUS * 0.6, "pillar", **MIDDLE)
    axes.text(0, GAP + RADIUS * 0.5, "pillar", **MIDDLE)
    axes.set(xlim=(-12, 12), ylim=(-8, GAP + 8), aspect="equal")
    axes.set_axis_off()


def main():
    arguments = figure_arguments(__doc__)
    values = {"R": RADIUS, "lambda": PITCH, "G": GAP, "d (as drawn)": SHIFT, "s (as drawn)": SEPARATION}
    values |= {"D_perp (as drawn)": EXTENT, "film (as drawn)": FILM}
    rows = [{"quantity": name, "value": value, "unit": "um"} for name, value in values.items()]
    write_table(rows, ["quantity", "value", "unit"], arguments.csv)
    figure = style.new_figure(style.PAGE, 3.0)
    left, right = figure.subplots(1, 2, width_ratios=[1.9, 1])
    draw_array(left)
    draw_gap(right)
    left.set_title("(a) the array, from above", loc="left")
    right.set_title("(b) a cell in the gap", loc="left")
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
