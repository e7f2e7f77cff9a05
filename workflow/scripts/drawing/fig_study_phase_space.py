"""The phase space of every sweep of a study: what a cell does at each capillary number and row shift, and the
brackets of the boundary of the same device and cell."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

MARKS = {"displaced": "o", "zigzag": "s"}
OTHER = "D"  # undecided, diverged, interrupted
BRACKETS = "boundary/"  # begins the sweep of a run that a bracket asked for
COLUMNS, WIDTH, HEIGHT = 3, 2.2, 2.5  # panels in a row, size of one in inches


def draw_cells(axes, cells):
    """One mark a passage, filled where the cell is displaced."""
    for name, rows in cells.groupby("class"):
        colour, label = style.CLASSES[name]
        face = colour if name == "displaced" else "none"
        mark = MARKS.get(name, OTHER)
        axes.plot(rows.capillary_number, rows.row_shift_um, mark, color=colour, mfc=face, ms=4, label=label)


def draw_brackets(axes, brackets):
    """The interval of the critical capillary number at each row shift, and a line through the middles."""
    closed = brackets.dropna(subset=["ca_displaced", "ca_zigzag"]).sort_values("row_shift_um")
    if closed.empty:
        return
    for row in closed.itertuples():
        axes.plot(
            [row.ca_displaced, row.ca_zigzag], [row.row_shift_um] * 2, color=style.GREEN, lw=2.5, zorder=1
        )
    middles = np.sqrt(closed.ca_displaced * closed.ca_zigzag)
    axes.plot(middles, closed.row_shift_um, color=style.GREEN, lw=1, zorder=1, label="boundary")


def panels_of(passages, boundary):
    """(title, passages) of every panel: sweeps, and boundaries of a device and cell that have no sweep."""
    grids = passages[~passages.sweep.str.startswith(BRACKETS)]
    found = [(sweep, grids[grids.sweep == sweep]) for sweep in dict.fromkeys(grids.sweep)]
    swept = {(cells.device.iloc[0], cells.cell.iloc[0]) for _, cells in found}
    for (series, device, cell), _ in boundary.groupby(["series", "device", "cell"]):
        cells = passages[passages.sweep == BRACKETS + series]
        if (device, cell) not in swept and len(cells):
            found.append((series, cells))
    return found


def main():
    arguments = required_arguments(__doc__, "plan", "passages", "boundary", "output")
    passages, boundary = read_table(arguments.passages), read_table(arguments.boundary)
    drawn = panels_of(passages, boundary)
    columns = min(COLUMNS, len(drawn))
    rows = -(-len(drawn) // columns)
    low = min(cells.capillary_number.min() for _, cells in drawn)
    high = max(cells.capillary_number.max() for _, cells in drawn)
    figure = style.new_figure(max(style.COLUMN, WIDTH * columns), HEIGHT * rows + 0.4)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, (sweep, cells) in zip(panels.flat, drawn, strict=False):
        device, cell = cells.device.iloc[0], cells.cell.iloc[0]
        draw_cells(axes, cells)
        draw_brackets(axes, boundary[(boundary.device == device) & (boundary.cell == cell)])
        axes.set_title(f"{sweep}\ndevice {device}, cell {cell}")
        axes.set_xscale("log")
        style.log_numbers(axes.xaxis, low, high)
    for axes in panels.flat[len(drawn) :]:
        axes.set_axis_off()
    for axes in panels[-1]:
        axes.set_xlabel("capillary number Ca")
    for axes in panels[:, 0]:
        axes.set_ylabel("row shift d (µm)")
    style.legend_below(figure, 5)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
