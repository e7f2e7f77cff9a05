"""The window of row shift and pressure gradient in which a device tells two cells apart: a bar from where the
one zigzags to where the other is no longer displaced."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

THICK, APART = 4, 0.09  # of a bar: points, um from one pair to the next


def main():
    arguments = required_arguments(__doc__, "plan", "window", "output")
    table = read_table(arguments.window)
    figure = style.new_figure(style.COLUMN, 2.9)
    axes = figure.add_subplot()
    pairs = table.groupby(["device", "zigzag_cell", "displaced_cell"])
    for number, ((device, soft, stiff), rows) in enumerate(pairs):
        colour = style.SERIES[1:][number % (len(style.SERIES) - 1)][0]
        label = f"{device}: {soft} zigzags, {stiff} is displaced"
        for row in rows.itertuples():
            height = row.row_shift_um + APART * number
            ends = [row.from_bar_per_m, row.to_bar_per_m]
            axes.plot(ends, [height] * 2, color=colour, lw=THICK, solid_capstyle="butt", label=label)
    if table.empty:
        axes.text(0.5, 0.5, "no window: see the page of the study", ha="center", transform=axes.transAxes)
    else:
        axes.set_xscale("log")
        style.log_numbers(axes.xaxis, table.from_bar_per_m.min(), table.to_bar_per_m.max())
    axes.set_xlabel("pressure gradient (bar/m = mbar/mm)")
    axes.set_ylabel("row shift d (µm)")
    style.legend_below(figure, 1)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
