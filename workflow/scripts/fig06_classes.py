"""Companion of Figure 6: class and lateral extent D_perp of every cell of the sweep, in colours."""

import argparse

import matplotlib.pyplot as plt
from matplotlib.colors import to_rgba
from study import style
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = [
    "row_shift_um",
    "capillary_number",
    "class",
    "d_perp_um",
    "d_perp_at_centre_um",
    "centre_um",
    "film_um",
]


def draw(axes, table):
    """One coloured field for each pair of row shift and capillary number."""
    shifts, numbers = sorted(table.row_shift_um.unique()), sorted(table.capillary_number.unique())
    for row in table.to_dict("records"):
        i, j = numbers.index(row["capillary_number"]), shifts.index(row["row_shift_um"])
        colour, label = style.CLASSES[row["class"]]
        axes.add_patch(plt.Rectangle((i, j), 1, 1, fc=to_rgba(colour, 0.25), ec="white", lw=2))
        extent = "" if row["d_perp_um"] != row["d_perp_um"] else f"\n{row['d_perp_um']:.2f} μm"
        axes.text(i + 0.5, j + 0.5, label + extent, ha="center", va="center")
    axes.set_xticks([i + 0.5 for i in range(len(numbers))], [f"{value:g}" for value in numbers])
    names = [rf"{shift:.1f} ({2.5 * shift:g}/80)" for shift in shifts]
    axes.set_yticks([j + 0.5 for j in range(len(shifts))], names)
    axes.set(xlim=(0, len(numbers)), ylim=(0, len(shifts)), xlabel="Ca", ylabel=r"$d$ / μm ($\epsilon$)")
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--plan", "--table", "--csv", "--output"):
        parser.add_argument(name, required=True)
    arguments = parser.parse_args()
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    figures = plan["figures"]
    chosen = table[
        (table.sweep == figures["trajectory_sweep"])
        & table.row_shift_um.isin(figures["trajectory_row_shifts_um"])
        & table.capillary_number.isin(figures["trajectory_capillary_numbers"])
    ]
    styles = dict.fromkeys(COLUMNS[3:], ".3f") | {"row_shift_um": ".1f"}
    write_table(chosen.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:2], styles)
    figure = style.new_figure(5.0, 0.9 + 0.48 * chosen.row_shift_um.nunique())
    draw(figure.add_subplot(), chosen)
    style.save(figure, arguments.output, plan["note"])


main()
