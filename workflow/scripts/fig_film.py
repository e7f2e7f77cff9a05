"""Thickness of the liquid film between cell and pillar at the defining crossing against Ca,
a line for every row shift, the class as marker."""

from study import style
from study.arguments import figure_arguments
from study.extent import GREY, MARKERS, capillary_axis, note_missing, of_sweep, shade
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = ["row_shift_um", "capillary_number", "class", "dx_um", "film_um", "run"]


def draw(axes, rows):
    """One line for every row shift; films thinner than a lattice spacing are shaded."""
    shifts = sorted(rows.row_shift_um.unique())
    for k, shift in enumerate(shifts):
        line = rows[(rows.row_shift_um == shift) & rows.film_um.notna()].sort_values("capillary_number")
        colour = shade(k, len(shifts))
        axes.plot(line.capillary_number, line.film_um, lw=0.8, color=colour, label=rf"$d$ = {shift:.1f} μm")
        for name, points in line.groupby("class"):
            look = {"ms": 3.5, "mew": 0.8, "mfc": colour if name == "displaced" else "white", "color": colour}
            axes.plot(points.capillary_number, points.film_um, MARKERS[name], ls="", **look)
    for name in sorted(rows[rows.film_um.notna()]["class"].unique()):
        look = {"ms": 3.5, "color": GREY, "mfc": GREY if name == "displaced" else "white"}
        axes.plot([], [], MARKERS[name], ls="", label=style.CLASSES[name][1], **look)
    if len(rows):
        spacing = rows.dx_um.iloc[0]
        axes.axhspan(0, spacing, color=style.PILLAR, alpha=0.35, lw=0, label="below one lattice spacing")
    capillary_axis(axes, rows.capillary_number)
    axes.set(ylabel="film between cell and pillar / μm")
    axes.set_ylim(bottom=0)
    note_missing(axes, rows, "film_um")


def main():
    arguments = figure_arguments(__doc__, "table")
    plan = read_json(arguments.plan)
    rows = of_sweep(read_table(arguments.table), plan)
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g", "dx_um": ".4f", "film_um": ".3f"}
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:2], styles)
    figure = style.new_figure(5.2, 3.4)
    axes = figure.add_subplot()
    draw(axes, rows)
    figure.legend(loc="outside right center", fontsize=7)
    style.save(figure, arguments.output, plan["note"])


main()
