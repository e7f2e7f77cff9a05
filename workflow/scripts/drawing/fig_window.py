"""The window of row shift and pressure gradient in which a device tells two cells apart."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.plan import read_json


def main():
    arguments = required_arguments(__doc__, "plan", "window", "output")
    table = read_table(arguments.window)
    figure = style.new_figure(style.COLUMN, 2.7)
    axes = figure.add_subplot()
    for number, (_, rows) in enumerate(table.groupby("device")):
        colour = style.SERIES[1:][number % (len(style.SERIES) - 1)][0]
        ends = (rows.from_bar_per_m, rows.to_bar_per_m)
        axes.fill_betweenx(rows.row_shift_um, *ends, color=colour, alpha=0.3, lw=0)
        axes.plot(
            ends[0],
            rows.row_shift_um,
            "o-",
            color=colour,
            ms=3,
            label=f"{rows.zigzag_cell.iloc[0]} zigzags from here",
        )
        axes.plot(
            ends[1],
            rows.row_shift_um,
            "s--",
            color=colour,
            ms=3,
            label=f"{rows.displaced_cell.iloc[0]} is displaced up to here",
        )
    if table.empty:
        axes.text(0.5, 0.5, "no window: see the page of the study", ha="center", transform=axes.transAxes)
    else:
        axes.set_xscale("log")
    axes.set_xlabel("pressure gradient (bar/m = mbar/mm)")
    axes.set_ylabel("row shift d (µm)")
    style.legend_below(figure, 1)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
