"""Figure 8: (a) the lateral extent D_perp at the gap line, (b) ... cells of growing Ca there, in three
dimensions and cut by the mid plane, with D_perp and the critical diameter 2s of the flow."""

import argparse

import matplotlib.pyplot as plt
import numpy as np
from study import style
from study.plan import read_json
from study.surface import draw_cell
from study.tables import read_table

RADIUS, PITCH = 10.0, 32.0  # um


def extent(line):
    """Lowest and highest y of the outline on the gap line x = 0."""
    x, y = line.x_um.to_numpy(), line.y_um.to_numpy()
    cut = x[:-1] * x[1:] < 0
    at = y[:-1][cut] - x[:-1][cut] * (y[1:] - y[:-1])[cut] / (x[1:] - x[:-1])[cut]
    return (at.min(), at.max()) if len(at) else (np.nan, np.nan)


def mark(axes, x, low, high, text, colour):
    """A dimension line along y with its text at its right."""
    axes.annotate(
        "", (x, low), (x, high), arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0, "color": colour}
    )
    axes.text(x + 0.5, 0.5 * (low + high), text, color=colour, va="center")


def draw_outline(axes, line, two_s, names):
    """Cell and pillar in the mid plane; bars for D_perp and 2s."""
    axes.add_patch(plt.Circle((0, 0), RADIUS, fc=style.PILLAR, ec="none"))
    axes.add_patch(plt.Circle((0, PITCH), RADIUS, fc=style.PILLAR, ec="none"))
    axes.fill(line.x_um, line.y_um, fc="#D9373040", ec="#8C1F1A", lw=1)
    axes.plot([0, 0], [RADIUS, PITCH - RADIUS], color=style.BLACK, ls=(0, (4, 2)), lw=0.8)
    low, high = extent(line)
    if low == low:
        axes.plot([0, 9], [low, low], [0, 9], [high, high], color=style.BLUE, lw=0.5)
        mark(axes, 8.5, low, high, r"$D_\perp$" if names else "", style.BLUE)
    if two_s == two_s:
        mark(axes, -9.0, RADIUS, RADIUS + two_s, "", style.GREEN)
        axes.plot([-9.5, 0], [RADIUS + two_s] * 2, [-9.5, 0], [RADIUS] * 2, color=style.GREEN, lw=0.5)
        axes.text(
            -9.5, RADIUS + 0.5 * two_s, "$2s$" if names else "", color=style.GREEN, va="center", ha="right"
        )
    axes.set(xlim=(-12, 12), ylim=(6, 24), aspect="equal")
    axes.set_axis_off()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--plan", "--shapes", "--outlines", "--faces", "--numbers", "--separation", "--output"):
        parser.add_argument(name, required=True)
    arguments = parser.parse_args()
    shapes, lines, numbers = (
        read_table(path) for path in (arguments.shapes, arguments.outlines, arguments.numbers)
    )
    faces, separation = read_table(arguments.faces).to_numpy(), read_table(arguments.separation)
    plan = read_json(arguments.plan)
    wanted = plan["figures"]["gap_cells"]
    flow = separation[separation.variant == wanted["flow_variant"]]
    flow = flow[(flow.row_shift_um - wanted["row_shift_um"]).abs() < 1e-6]
    two_s = 2 * float(flow.s_um.iloc[0]) if len(flow) else np.nan
    cells = numbers.to_dict("records")
    columns = max(len(cells), 1)
    figure = style.new_figure(style.PAGE, 3.1)
    grid = figure.add_gridspec(2, columns + 1, width_ratios=[1.5] + [1] * columns, height_ratios=[1, 1.15])
    for column, cell in enumerate(cells, start=1):
        capillary = cell["capillary_number"]
        line = lines[lines.capillary_number == capillary]
        if column == 1:
            definition = figure.add_subplot(grid[:, 0])
            draw_outline(definition, line, two_s, names=True)
            definition.set_title("(a)", loc="left")
        upper = figure.add_subplot(grid[0, column], projection="3d")
        points = shapes[shapes.capillary_number == capillary][["x_um", "y_um", "z_um"]].to_numpy()
        draw_cell(upper, points, faces, half_width=6.6)
        upper.set_title(f"({'bcdefghi'[column - 1]}) Ca = {capillary:g}\n{cell['class']}", loc="left")
        lower = figure.add_subplot(grid[1, column])
        draw_outline(lower, line, two_s, names=False)
        lower.set_title(rf"$D_\perp$ = {cell['d_perp_um']:.2f} μm", y=-0.3)
    critical = f"$2s$ = {two_s:.2f} μm" if two_s == two_s else "$2s$ not run at this row shift"
    figure.supxlabel(f"$d$ = {wanted['row_shift_um']:.1f} μm, {critical}; dashed: gap line", fontsize=8)
    style.save(figure, arguments.output, plan["note"])


main()
