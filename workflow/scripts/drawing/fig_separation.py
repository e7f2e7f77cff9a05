"""The separation distance s against the relative row shift of every device, at the pillar below a gap and at
the one above it. A pillar that looks the same from both sides has one s."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

SIDES = {"s_um": ("o", "pillar below"), "s_upper_um": ("^", "pillar above")}


def best(rows):
    """Of each row shift the row with the smallest lattice spacing; a limit (spacing 0) comes first."""
    return rows.sort_values("dx_um").groupby("row_shift_um").first().reset_index()


def main():
    arguments = required_arguments(__doc__, "plan", "table", "output")
    table = read_table(arguments.table)
    table = table[table.status == "converged"]
    figure = style.new_figure(style.COLUMN, 2.9)
    axes = figure.add_subplot()
    for number, (device, rows) in enumerate(table.groupby("device")):
        colour = style.SERIES[number % len(style.SERIES)][0]
        chosen = best(rows)
        for name, (mark, side) in SIDES.items():
            look = {"color": colour, "marker": mark, "ls": "-" if name == "s_um" else ":"}
            axes.plot(chosen.epsilon, chosen[name], label=f"{device}, {side}", mfc="none", **look)
    axes.set_xlabel(r"relative row shift $\varepsilon$")
    axes.set_ylabel("separation distance s (µm)")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    style.legend_below(figure, 2)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
