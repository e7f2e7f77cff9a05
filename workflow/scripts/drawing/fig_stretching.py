"""The stretched cells of a study: axial (filled) and transverse (open) diameters against the force."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

MARKS = "os^Dv<>"


def main():
    arguments = required_arguments(__doc__, "plan", "table", "output")
    table = read_table(arguments.table)
    figure = style.new_figure(style.COLUMN, 3.0)
    axes = figure.add_subplot()
    for number, ((series, denominator), rows) in enumerate(table.groupby(["series", "skalak_denominator"])):
        colour, dash = style.SERIES[number % len(style.SERIES)]
        look = {"color": colour, "ls": dash, "marker": MARKS[number % len(MARKS)]}
        lines = rows.sort_values("force_pN")
        axes.plot(lines.force_pN, lines.axial_um, label=f"{series}, k = {denominator:g}", **look)
        axes.plot(lines.force_pN, lines.transverse_um, mfc="none", **look)
    axes.set_xlabel("force (pN)")
    axes.set_ylabel("diameter of the cell (µm)")
    axes.set_ylim(bottom=0)
    style.legend_below(figure, 2)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
