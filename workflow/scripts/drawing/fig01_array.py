"""Figure 1: the array with streams of equal flux; a small particle zigzags with the flow, a large one is
displaced."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

RADIUS, PITCH = 10.0, 32.0  # um


def draw(axes, table, wanted):
    """Pillars, streams in every lane, and both particles."""
    shift, rows = wanted["row_shift_um"], wanted["rows"]
    x_range, y_range = (-PITCH / 2, (rows - 0.5) * PITCH), (-PITCH / 2, 2 * PITCH)
    style.add_pillars(axes, RADIUS, PITCH, shift, x_range, y_range)
    for _, line in table[table.kind == "stream"].groupby("line"):
        for lane in range(-3, 4):
            axes.plot(line.x_um, line.y_um + lane * PITCH, color=style.SKY, lw=0.5, zorder=1)
    small = table[table.kind == "small"]
    axes.plot(small.x_um, small.y_um, color=style.VERMILION, lw=1.5, label="small particle: zigzag", zorder=3)
    large = table[table.kind == "cell"]
    name = f"cell, Ca = {wanted['capillary_number']:g}: displaced" if len(large) else "no displaced cell"
    axes.plot(large.x_um, large.y_um, color=style.BLUE, lw=1.5, ls=(0, (5, 2)), label=name, zorder=3)
    for _, line in table[table.kind == "outline"].groupby("line"):
        axes.fill(line.x_um, line.y_um, fc="#0072B240", ec=style.BLUE, lw=0.8, zorder=2)
    axes.plot([], [], color=style.SKY, lw=0.5, label="streams of equal flux")
    axes.set(xlim=x_range, ylim=y_range, aspect="equal", xlabel="$x$ / μm", ylabel="$y$ / μm")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)


def main():
    arguments = required_arguments(__doc__, "plan", "lines", "output")
    plan = read_json(arguments.plan)
    figure = style.new_figure(style.PAGE, 3.2)
    draw(figure.add_subplot(), read_table(arguments.lines), plan["figures"]["array"])
    style.save(figure, arguments.output, plan["note"])


main()
