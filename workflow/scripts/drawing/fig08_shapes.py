"""Figure 8: (a) the lateral extent D_perp at the gap line, (b) ... cells of growing Ca there.

Each cell is shown in three dimensions, from above beside its pillar, and cut by the plane of the gap line,
with D_perp and the critical diameter 2s of the flow.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from study.analysis.arguments import required_arguments
from study.analysis.surface import draw_cell, draw_from_above, section
from study.analysis.tables import read_table
from study.drawing import style
from study.paper.claims import load_claims
from study.planning.documents import read_json

RADIUS, PITCH, DEPTH = 10.0, 32.0, 4.8  # um
LEFT, RIGHT = -8.0, 8.0  # um, where the bars of 2s and of D_perp stand
PRINTED_AT = 6.8  # um, row shift of the printed extents


def bar(axes, x, low, high, text, colour):
    """A dimension line along y from the gap line's side, its text on the side away from the cell."""
    look = {"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0, "color": colour, "mutation_scale": 7}
    axes.annotate("", (x, low), (x, high), arrowprops=look)
    side = "left" if x > 0 else "right"
    axes.text(x + np.copysign(0.6, x), 0.5 * (low + high), text, color=colour, va="center", ha=side)
    axes.plot([0, x], [low, low], [0, x], [high, high], color=colour, lw=0.5)


def extent(cut):
    """Lowest and highest y (um) of a section; nan without one."""
    return (cut[..., 1].min(), cut[..., 1].max()) if len(cut) else (np.nan, np.nan)


def draw_gap(axes, cut, two_s, names):
    """Pillars, gap line, and the bars of D_perp and 2s; the names of the bars on request."""
    for centre in (0, PITCH):
        axes.add_patch(plt.Circle((0, centre), RADIUS, fc=style.PILLAR, ec="none", zorder=0))
    axes.plot([0, 0], [RADIUS, PITCH - RADIUS], color=style.BLACK, ls=(0, (4, 2)), lw=0.8)
    low, high = extent(cut)
    if low == low:
        bar(axes, RIGHT, low, high, r"$D_\perp$" if names else "", style.BLUE)
    if two_s == two_s:
        bar(axes, LEFT, RADIUS, RADIUS + two_s, "$2s$" if names else "", style.GREEN)
    axes.set(xlim=(-9.5, 9.5), ylim=(7, 23), aspect="equal")
    axes.set_axis_off()


def draw_definition(axes, line, cut, two_s):
    """Panel (a): outline of a cell in the mid plane with what is measured."""
    draw_gap(axes, cut, two_s, names=True)
    axes.fill(line.x_um, line.y_um, fc="#D9373040", ec="#8C1F1A", lw=1)
    axes.text(0.6, 21.6, "gap line", va="top")
    axes.set(xlim=(-11.5, 11.5))
    axes.set_title("(a)", loc="left")


def draw_section(axes, cut, two_s):
    """The membrane cut by the plane of the gap line, between pillar (left) and walls (above, below)."""
    half = 0.5 * DEPTH
    axes.add_patch(plt.Rectangle((7, -half), RADIUS - 7, DEPTH, fc=style.PILLAR, ec="none"))
    axes.plot([7, 23], [half, half], [7, 23], [-half, -half], color=style.BLACK, lw=0.8)
    axes.add_collection(LineCollection(cut[..., 1:], colors="#8C1F1A", linewidths=1, capstyle="round"))
    if two_s == two_s:
        axes.plot([RADIUS + two_s] * 2, [-half, half], color=style.GREEN, lw=0.8)
    axes.set(xlim=(7, 23), ylim=(-3, 3), aspect="equal")
    axes.set_axis_off()


def draw_cells(figure, grid, cells, shapes, faces, two_s, printed):
    """Panels (b) ...: one column for each cell."""
    for column, cell in enumerate(cells, start=1):
        points = shapes[shapes.capillary_number == cell["capillary_number"]]
        points = points[["x_um", "y_um", "z_um"]].to_numpy()
        cut = section(points, faces, axis=0, value=0.0)
        solid = figure.add_subplot(grid[0, column], projection="3d")
        draw_cell(solid, points, faces, half_width=5.6)
        letter = "bcdefghi"[column - 1]
        solid.set_title(f"({letter}) Ca = {cell['capillary_number']:g}\n{cell['class']}", loc="left", y=0.86)
        above = figure.add_subplot(grid[1, column])
        draw_gap(above, cut, two_s, names=False)
        draw_from_above(above, points, faces)
        across = figure.add_subplot(grid[2, column])
        draw_section(across, cut, two_s)
        print_of = printed.get(cell["capillary_number"])
        said = "" if print_of is None else f"\nin print {print_of:g} μm"
        across.set_title(rf"$D_\perp$ = {cell['d_perp_um']:.2f} μm{said}", y=-0.42, va="top")


def main():
    arguments = required_arguments(
        __doc__, "plan", "shapes", "outlines", "faces", "numbers", "separation", "claims", "output"
    )
    shapes, lines, numbers, separation = (
        read_table(path)
        for path in (arguments.shapes, arguments.outlines, arguments.numbers, arguments.separation)
    )
    faces, plan = read_table(arguments.faces).to_numpy(), read_json(arguments.plan)
    wanted = plan["figures"]["gap_cells"]
    flow = separation[separation.variant == wanted["flow_variant"]]
    flow = flow[(flow.row_shift_um - wanted["row_shift_um"]).abs() < 1e-6]
    two_s = 2 * float(flow.s_um.iloc[0]) if len(flow) else np.nan
    cells, claim = numbers.to_dict("records"), load_claims(arguments.claims)["d-perp-6.8"]
    here = abs(wanted["row_shift_um"] - PRINTED_AT) < 1e-6
    printed = {float(number): extent for number, extent in claim["value"].items()} if here else {}
    columns = max(len(cells), 1)
    figure = style.new_figure(style.PAGE, 4.0)
    grid = figure.add_gridspec(
        3, columns + 1, width_ratios=[1.35] + [1] * columns, height_ratios=[0.8, 1.15, 0.5]
    )
    if cells:
        capillary = cells[0]["capillary_number"]
        points = shapes[shapes.capillary_number == capillary][["x_um", "y_um", "z_um"]].to_numpy()
        cut = section(points, faces, axis=0, value=0.0)
        line = lines[lines.capillary_number == capillary]
        draw_definition(figure.add_subplot(grid[:2, 0]), line, cut, two_s)
    draw_cells(figure, grid, cells, shapes, faces, two_s, printed)
    critical = f"$2s$ = {two_s:.2f} μm" if two_s == two_s else "$2s$ not run at this row shift"
    where = f"$d$ = {wanted['row_shift_um']:.1f} μm, {critical}"
    figure.supxlabel(f"{where}; last row: section along the gap line, walls in black", fontsize=8)
    style.save(figure, arguments.output, plan["note"])


main()
