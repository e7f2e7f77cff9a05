"""Companion of Figure 6: class and lateral extent D_perp of every cell of the whole sweep, in colours."""

import matplotlib.pyplot as plt
from matplotlib.colors import to_rgba
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.planning.documents import read_json

COLUMNS = [
    "row_shift_um",
    "capillary_number",
    "class",
    "d_perp_um",
    "d_perp_at_centre_um",
    "centre_um",
    "film_um",
]

# A class in a field, beside its colour.
SHORT = {
    "displaced": "D",
    "zigzag": "Z",
    "undecided": "?",
    "diverged": "×",
    "failed": "!",
    "interrupted": "–",
}
SIZE = 7  # of the numbers in the fields, points


def draw(axes, table):
    """One coloured field with D_perp in um for each pair of row shift and capillary number."""
    shifts, numbers = sorted(table.row_shift_um.unique()), sorted(table.capillary_number.unique())
    for row in table.to_dict("records"):
        i, j = numbers.index(row["capillary_number"]), shifts.index(row["row_shift_um"])
        colour, _ = style.CLASSES[row["class"]]
        axes.add_patch(plt.Rectangle((i, j), 1, 1, fc=to_rgba(colour, 0.25), ec="white", lw=1.5))
        extent = "" if row["d_perp_um"] != row["d_perp_um"] else f"\n{row['d_perp_um']:.2f}"
        axes.text(i + 0.5, j + 0.5, SHORT[row["class"]] + extent, ha="center", va="center", fontsize=SIZE)
    for label in sorted(set(table["class"])):
        colour, name = style.CLASSES[label]
        axes.add_patch(plt.Rectangle((0, 0), 0, 0, fc=to_rgba(colour, 0.25), label=f"{SHORT[label]}: {name}"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=5, title=r"class, $D_\perp$ / μm")
    axes.set_xticks([i + 0.5 for i in range(len(numbers))], [f"{value:g}" for value in numbers])
    names = [rf"{shift:.1f} ({2.5 * shift:g}/80)" for shift in shifts]
    axes.set_yticks([j + 0.5 for j in range(len(shifts))], names)
    axes.set(xlim=(0, len(numbers)), ylim=(0, len(shifts)), xlabel="Ca", ylabel=r"$d$ / μm ($\epsilon$)")
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def main():
    arguments = figure_arguments(__doc__, "table")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    chosen = table[table.sweep == plan["figures"]["trajectory_sweep"]]
    styles = dict.fromkeys(COLUMNS[3:], ".3f") | {"row_shift_um": ".1f"}
    write_table(chosen.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:2], styles)
    figure = style.new_figure(style.PAGE, 1.1 + 0.34 * chosen.row_shift_um.nunique())
    draw(figure.add_subplot(), chosen)
    style.save(figure, arguments.output, plan["note"])


main()
