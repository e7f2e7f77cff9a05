"""The window of row shift and pressure gradient in which a device tells two cells apart: a bar from where the
one zigzags to where the other is no longer displaced."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

SHARE = 0.7  # of the space between two row shifts that bars may take


def main():
    arguments = required_arguments(__doc__, "plan", "window", "output")
    table = read_table(arguments.window)
    figure = style.new_figure(style.COLUMN, 2.9)
    axes = figure.add_subplot()
    pairs = table.groupby(["device", "zigzag_cell", "displaced_cell"])
    shifts = np.unique(table.row_shift_um)
    thick = SHARE * (np.diff(shifts).min() if len(shifts) > 1 else 1) / max(1, len(pairs))  # um
    for number, ((device, soft, stiff), rows) in enumerate(pairs):
        colour = style.SERIES[1:][number % (len(style.SERIES) - 1)][0]
        label = f"{device}: {soft} zigzags, {stiff} is displaced"
        middles = rows.row_shift_um + thick * ((len(pairs) - 1) / 2 - number)
        widths = rows.to_bar_per_m - rows.from_bar_per_m
        axes.barh(middles, widths, 0.9 * thick, rows.from_bar_per_m, color=colour, label=label)
    if table.empty:
        axes.text(0.5, 0.5, "no window: see the page of the study", ha="center", transform=axes.transAxes)
    else:
        axes.set_yticks(shifts)
        axes.set_xscale("log")
        axes.set_xlim(0.85 * table.from_bar_per_m.min(), 1.15 * table.to_bar_per_m.max())
        style.log_numbers(axes.xaxis, table.from_bar_per_m.min(), table.to_bar_per_m.max())
    axes.set_xlabel("pressure gradient (bar/m = mbar/mm)")
    axes.set_ylabel("row shift d (µm)")
    style.legend_below(figure, 1)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
