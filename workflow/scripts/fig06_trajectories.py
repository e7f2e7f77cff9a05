"""Figure 6: trajectories of the cell's centre, a panel for each row shift, a line for each Ca."""

from study import style
from study.arguments import required_arguments
from study.plan import read_json
from study.tables import read_table

RADIUS, PITCH = 10.0, 32.0  # um


def y_range(panel):
    """Range of y of a panel: the trajectories with some room, at least one and a half gaps and pillars."""
    middle, half = 0.5 * (panel.y_um.min() + panel.y_um.max()), 0.5 * (panel.y_um.max() - panel.y_um.min())
    half = max(half + 6, 0.75 * PITCH)
    return middle - half, middle + half


def draw(axes, panel, shift, number, x_range):
    """One panel; the legend states the class of every cell."""
    low, high = y_range(panel)
    style.add_pillars(axes, RADIUS, PITCH, shift, x_range, (low, high))
    for index, (capillary, line) in enumerate(panel.groupby("capillary_number")):
        colour, dash = style.SERIES[index % len(style.SERIES)]
        label = f"Ca = {capillary:g}, {line['class'].iloc[0]}"
        axes.plot(line.x_um, line.y_um, color=colour, ls=dash, label=label)
    title = rf"({'abcdefgh'[number]}) $\epsilon$ = {80 * shift / PITCH:g}/80, $d$ = {shift:.1f} μm"
    axes.set_title(title, loc="left")
    axes.set(xlim=x_range, ylim=(low, high), aspect="equal", ylabel="$y$ / μm")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=2.6)


def main():
    arguments = required_arguments(__doc__, "plan", "trajectories", "output")
    table = read_table(arguments.trajectories)
    shifts = sorted(table.row_shift_um.unique())
    panels = [table[table.row_shift_um == shift] for shift in shifts]
    spans = [high - low for low, high in map(y_range, panels)]
    width = table.x_um.max() + PITCH / 2
    height = sum(max(span / width * 5.0, 0.85) + 0.32 for span in spans) + 0.4
    figure = style.new_figure(style.PAGE, height)
    grid = figure.subplots(len(panels), 1, squeeze=False, gridspec_kw={"height_ratios": spans})[:, 0]
    for number, (axes, panel, shift) in enumerate(zip(grid, panels, shifts, strict=True)):
        draw(axes, panel, shift, number, (-PITCH / 2, table.x_um.max() + 2))
    grid[-1].set_xlabel("$x$ / μm")
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
