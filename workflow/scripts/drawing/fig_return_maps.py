"""Return maps: the step of the gap position from one pillar line to the next against the position, a
panel for every row shift that has both classes. A displaced cell comes to a step of zero and stays; a
cell that zigzags (open symbols) never does and falls back (triangles at the upper edge)."""

import math

from matplotlib.ticker import MultipleLocator
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import GREY, of_sweep, shade
from study.planning.documents import read_json

COLUMNS = [
    "row_shift_um",
    "capillary_number",
    "class",
    "row",
    "gap_position_um",
    "next_gap_position_um",
    "bump",
]
COLUMNS_OF_PANELS = 4
RANGE = (1.5, 5.0)  # um, gap positions shown: those next to the pillar
STEPS = (-1.2, 0.3)  # um, steps shown; a cell that falls back steps further and stands at the upper edge


def panels_of(maps, plan):
    """The row shifts at which both classes occur, or else all, and the capillary numbers of Fig. 6."""
    wanted = plan["figures"].get("trajectory_capillary_numbers")
    if wanted:
        maps = maps[maps.capillary_number.round(6).isin([round(number, 6) for number in wanted])]
    both = maps.groupby("row_shift_um")["class"].agg(lambda names: {"displaced", "zigzag"} <= set(names))
    chosen = [shift for shift, found in both.items() if found] or sorted(both.index)
    return maps[maps.row_shift_um.isin(chosen)], chosen


def draw_panel(axes, rows, numbers):
    """Steps of every cell at one row shift: y' - y against y; zero is a cell that stays where it is."""
    axes.axhline(0, color=style.BLACK, lw=0.8, zorder=1)
    for number, cell in rows.groupby("capillary_number"):
        colour = shade(numbers.index(number), len(numbers))
        cell = cell.assign(step=cell.next_gap_position_um - cell.gap_position_um)
        kept = cell[cell.bump == 1].sort_values("gap_position_um")
        look = {"color": colour, "mfc": colour if cell["class"].iloc[0] == "displaced" else "white"}
        axes.plot(kept.gap_position_um, kept.step, "o-", ms=3, mew=0.7, lw=0.7, **look)
        fallen = cell[(cell.bump == 0) & cell.gap_position_um.between(*RANGE)]
        edge = [0.75 * STEPS[1]] * len(fallen)
        axes.plot(fallen.gap_position_um, edge, "^", ms=4, mew=0.7, color=colour, mfc="white")
    axes.set(xlim=RANGE, ylim=STEPS)
    axes.xaxis.set_major_locator(MultipleLocator(1.0))


def draw(figure, maps, shifts):
    """All panels, the labels of the axes and the legend."""
    numbers = sorted(maps.capillary_number.unique())
    columns = min(COLUMNS_OF_PANELS, len(shifts))
    panels = figure.subplots(
        math.ceil(len(shifts) / columns), columns, squeeze=False, sharex=True, sharey=True
    )
    for axes in panels.flat[len(shifts) :]:
        axes.axis("off")
    for axes, shift in zip(panels.flat, shifts, strict=False):
        draw_panel(axes, maps[maps.row_shift_um == shift], numbers)
        axes.set_title(rf"$d$ = {shift:.1f} μm")
        axes.set_xlabel("place $y$ in the gap / μm")
    for axes in panels[:, 0]:
        axes.set_ylabel("step $y' - y$ / μm")
    first = panels[0, 0]
    for k, number in enumerate(numbers):
        first.plot([], [], "o-", ms=3, lw=0.7, color=shade(k, len(numbers)), label=f"Ca = {number:g}")
    first.plot([], [], "o", ms=3, mfc="white", color=GREY, label="cell that zigzags")
    first.plot([], [], "^", ms=4, mfc="white", color=GREY, label="falls back")
    style.legend_below(figure, 4)


def main():
    arguments = figure_arguments(__doc__, "table")
    plan = read_json(arguments.plan)
    maps = of_sweep(read_table(arguments.table), plan).dropna(subset=COLUMNS[4:6])
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g"} | dict.fromkeys(COLUMNS[4:6], ".4f")
    write_table(maps.to_dict("records"), COLUMNS, arguments.csv, [*COLUMNS[:2], "row"], styles)
    if len(maps):
        maps, shifts = panels_of(maps, plan)
        rows = math.ceil(len(shifts) / COLUMNS_OF_PANELS)
        figure = style.new_figure(style.PAGE, 0.9 + 1.7 * rows)
        draw(figure, maps, shifts)
    else:
        figure = style.new_figure(style.PAGE, 1.5)
        figure.text(0.5, 0.5, "no cell passed two pillar lines", ha="center", color=GREY)
    style.save(figure, arguments.output, plan["note"])


main()
