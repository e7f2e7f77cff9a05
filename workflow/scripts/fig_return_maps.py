"""Return maps: gap position at the next pillar line against that at this one, a panel for every row shift, a
line for every capillary number. A cell on the diagonal stays where it is and is displaced for ever; open
symbols are steps on which the cell falls back by a lane."""

import math

from matplotlib.ticker import MultipleLocator
from study import style
from study.arguments import figure_arguments
from study.extent import GREY, of_sweep, shade
from study.plan import read_json
from study.tables import read_table, write_table

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
TICK = 2.0  # um


def draw_panel(axes, rows, numbers, limits):
    """Steps of every cell at one row shift and the diagonal."""
    axes.plot(limits, limits, color=GREY, lw=0.6, ls="--", zorder=1)
    for number, cell in rows.groupby("capillary_number"):
        colour = shade(numbers.index(number), len(numbers))
        for kept, steps in cell.sort_values("gap_position_um").groupby("bump"):
            look = {"ms": 2.5, "mew": 0.7, "lw": 0.5, "mfc": colour if kept else "none"}
            axes.plot(steps.gap_position_um, steps.next_gap_position_um, "o-", color=colour, **look)
    axes.set(xlim=limits, ylim=limits, aspect="equal")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MultipleLocator(TICK))


def draw(figure, maps):
    """All panels, the labels of the axes and the legend."""
    shifts, numbers = sorted(maps.row_shift_um.unique()), sorted(maps.capillary_number.unique())
    values = maps[["gap_position_um", "next_gap_position_um"]].to_numpy()
    limits = (math.floor(2 * values.min()) / 2, math.ceil(2 * values.max()) / 2)
    columns = min(COLUMNS_OF_PANELS, len(shifts))
    panels = figure.subplots(
        math.ceil(len(shifts) / columns), columns, squeeze=False, sharex=True, sharey=True
    )
    for axes in panels.flat[len(shifts) :]:
        axes.axis("off")
    for index, (axes, shift) in enumerate(zip(panels.flat, shifts, strict=False)):
        draw_panel(axes, maps[maps.row_shift_um == shift], numbers, limits)
        axes.set_title(rf"$d$ = {shift:.1f} μm")
        axes.tick_params(labelbottom=index + columns >= len(shifts))
    entries = [
        panels[0, 0].plot([], [], "o-", ms=2.5, color=shade(k, len(numbers)), label=f"Ca = {number:g}")[0]
        for k, number in enumerate(numbers)
    ]
    entries += panels[0, 0].plot([], [], "o", ms=2.5, mfc="none", color=GREY, label="falls back")
    figure.legend(handles=entries, loc="outside right center", fontsize=7)
    figure.supxlabel("gap position at a pillar line / μm", fontsize=8)
    figure.supylabel("gap position at the next / μm", fontsize=8)


def main():
    arguments = figure_arguments(__doc__, "table")
    plan = read_json(arguments.plan)
    maps = of_sweep(read_table(arguments.table), plan).dropna(subset=COLUMNS[4:6])
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g"} | dict.fromkeys(COLUMNS[4:6], ".4f")
    write_table(maps.to_dict("records"), COLUMNS, arguments.csv, [*COLUMNS[:2], "row"], styles)
    rows = max(1, math.ceil(maps.row_shift_um.nunique() / COLUMNS_OF_PANELS))
    figure = style.new_figure(style.PAGE, 0.7 + 1.6 * rows)
    if len(maps):
        draw(figure, maps)
    else:
        figure.text(0.5, 0.5, "no cell passed two pillar lines", ha="center", color=GREY)
    style.save(figure, arguments.output, plan["note"])


main()
