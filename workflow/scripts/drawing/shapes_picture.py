"""Every pillar shape in its unit cell with the gap to the next pillar, from the solver's own outlines."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style

PITCH = 32.0  # um, of the solver's default device, which the examples fit
COLUMNS, HEIGHT = 4, 2.3  # panels in a row, inches of a row
MARGIN = 3.0  # um around what is drawn


def draw(axes, outline, gap):
    """One pillar in its unit cell, its neighbour across the lane and the gap between them."""
    half = PITCH / 2
    corners = np.array([(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half)])
    axes.plot(*corners.T, color=style.BLUE, ls="--", lw=0.8)
    axes.fill(*(outline + np.array((0, PITCH))).T, color="#E3E3E3", lw=0)
    axes.fill(*outline.T, color=style.PILLAR, lw=0)
    (x, lower), (_, upper) = gap
    arrow = {"arrowstyle": "<->", "lw": 0.8, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (x, lower), (x, upper), arrowprops=arrow)
    axes.set_xlim(-half - MARGIN, half + MARGIN)
    axes.set_ylim(-half - MARGIN, PITCH + half)
    axes.set_xticks([-10, 0, 10])
    axes.set_yticks(range(-10, 41, 10))
    axes.set_aspect("equal")


def main():
    arguments = required_arguments(__doc__, "outlines", "output")
    table = read_table(arguments.outlines)
    shapes = list(dict.fromkeys(table["shape"]))
    rows = -(-len(shapes) // COLUMNS)
    figure = style.new_figure(style.PAGE, HEIGHT * rows + 0.3)
    panels = figure.subplots(rows, COLUMNS, sharex=True, sharey=True, squeeze=False)
    for axes, shape in zip(panels.flat, shapes, strict=False):
        own = table[table["shape"] == shape]
        points = own.groupby("kind")[["x_um", "y_um"]]
        draw(axes, *(points.get_group(kind).to_numpy(float) for kind in ("outline", "gap")))
        axes.set_title(f"{shape}\nG = {own.gap_um.iloc[0]:.3g} µm")
    for axes in panels.flat[len(shapes) :]:
        axes.set_axis_off()
    for number, axes in enumerate(panels.flat[: len(shapes)]):
        if number + COLUMNS >= len(shapes):
            axes.tick_params(labelbottom=True)
            axes.set_xlabel("x (µm)")
    for axes in panels[:, 0]:
        axes.set_ylabel("y (µm)")
    style.save(figure, arguments.output)


main()
