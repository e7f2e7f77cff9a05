"""Drift over a long run: extent, volume, area, smallest face and film at every pillar line."""

from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table
from study.drawing.style import PAGE, SERIES, VERMILION, new_figure, save
from study.planning.documents import read_json

#: Column, label, factor, and the bounds that the project asks for.
PANELS = [
    ("d_perp_change", r"$D_\perp$ against row 10 / %", 100, (-0.5, 0.5)),
    ("volume_change", "volume change / %", 100, (-0.5, 0.5)),
    ("area_change", "area change / %", 100, (-0.5, 0.5)),
    ("min_face_ratio", "smallest face / reference", 1, (0.6,)),
    ("film_um", r"smallest film / $\mathrm{\mu m}$", 1, ()),
]


def main():
    arguments = figure_arguments(__doc__, "table")
    table = read_table(arguments.table)
    table.to_csv(arguments.csv, index=False, lineterminator="\n")
    figure = new_figure(PAGE, 3.9)
    panels = figure.subplots(2, 3).ravel()
    for axes, (column, label, factor, bounds) in zip(panels, PANELS, strict=False):
        for (color, dashes), (name, rows) in zip(SERIES, table.groupby("name"), strict=False):
            axes.plot(rows.row, factor * rows[column], color=color, linestyle=dashes, label=name)
        for bound in bounds:
            axes.axhline(bound, color=VERMILION, linewidth=0.6)
        axes.set_xlabel("pillar row")
        axes.set_ylabel(label)
    panels[-1].set_axis_off()
    if len(table):
        handles, labels = panels[0].get_legend_handles_labels()
        panels[-1].legend(handles, labels, loc="center")
    panels[-1].text(
        0.5, 0.1, "red: bounds asked for", color=VERMILION, ha="center", transform=panels[-1].transAxes
    )
    save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
