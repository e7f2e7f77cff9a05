"""Thickness of the liquid film between cell and pillar at the defining crossing against Ca: displaced
cells, a line for every row shift, over the lattice spacing, below which it is not resolved."""

from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import capillary_axis, note_missing, of_sweep, shade
from study.planning.documents import read_json

COLUMNS = ["row_shift_um", "capillary_number", "class", "dx_um", "film_um", "run"]


def draw(axes, rows):
    """Displaced cells, a line for every row shift; the others pale. Films thinner than a lattice spacing are
    shaded."""
    known = rows[rows.film_um.notna()]
    shifts = sorted(known[known["class"] == "displaced"].row_shift_um.unique())
    for k, shift in enumerate(shifts):
        line = known[(known.row_shift_um == shift) & (known["class"] == "displaced")]
        line = line.sort_values("capillary_number")
        label = (
            rf"$d$ = {shift:.1f} μm" if shift in (shifts[0], shifts[len(shifts) // 2], shifts[-1]) else None
        )
        look = {"lw": 0.9, "ms": 3.2, "color": shade(k, len(shifts))}
        axes.plot(line.capillary_number, line.film_um, "o-", label=label, **look)
    others = known[known["class"] != "displaced"]
    axes.plot(
        others.capillary_number, others.film_um, "^", ms=3, mew=0.6, mfc="none", color="#AAAAAA", zorder=1
    )
    axes.plot([], [], "^", ms=3, mew=0.6, mfc="none", color="#AAAAAA", label="not displaced")
    if len(rows):
        spacing = rows.dx_um.iloc[0]
        label = "thinner than a lattice spacing"
        axes.axhspan(0, spacing, color=style.PILLAR, alpha=0.35, lw=0, label=label, zorder=0)
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
    figure = style.new_figure(style.COLUMN, 3.2)
    draw(figure.add_subplot(), rows)
    style.legend_below(figure, 2, fontsize=7)
    style.save(figure, arguments.output, plan["note"])


main()
