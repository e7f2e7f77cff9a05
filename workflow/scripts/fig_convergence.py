"""D_perp, centre at the gap line and film of the passages of the accuracy study against the lattice spacing,
of every coupling that was run on two lattices or more. Couplings that are right meet at dx = 0. Open markers
have another class than the corrected coupling on the finest lattice: their D_perp is of another crossing.
"""

from study import style
from study.accuracy import passage_ladders
from study.arguments import figure_arguments
from study.plan import read_json
from study.runs import load_runs
from study.tables import read_table, write_table

COLUMNS = ["point", "error_kind", "method", "spacing", "value", "class"]
STYLES = {"spacing": ".4f", "value": ".4f"}
#: What the legend calls a coupling, and its colour and marker; others are drawn in grey.
LOOKS = {
    "phi4": ("plain kernel", style.GREEN, "^"),
    "phi4_corrected": ("corrected, central linear walls", style.BLUE, "o"),
    "phi4_corrected, finer mesh": ("corrected, edges of 0.7 dx", style.SKY, "D"),
    "phi4_corrected, interpolated walls": ("corrected, interpolated walls", style.VERMILION, "s"),
    "retraction 0.5": ("plain kernel, retraction 0.5", style.ORANGE, "v"),
}
NAMES = {
    "D_perp": r"lateral extent $D_\perp$ / μm",
    "centre": "centre at the gap line / μm",
    "film": "film / μm",
}


def ladders(arguments):
    """Rows of the couplings that were run on two lattices or more, with the class that each passage found."""
    labels = ("method", "setting", "point")
    known = {
        tuple(run.labels[name] for name in labels): run.summary["status"]
        for run in load_runs(arguments.plan, arguments.runs, "accuracy-passages")
    }
    table = read_table(arguments.table)
    table["class"] = [known.get(key, "") for key in zip(*(table[name] for name in labels), strict=True)]
    return passage_ladders(table).sort_values(COLUMNS[:4])


def draw(axes, rows, expected):
    """One panel: one length at one point. Open markers: another class than expected."""
    for method, part in rows.groupby("method"):
        label, colour, marker = LOOKS.get(method, (method, "#777777", "x"))
        axes.plot(part.spacing, part.value, color=colour, lw=0.9, marker=marker, label=label)
        other = part[part["class"] != expected]
        axes.plot(other.spacing, other.value, marker, color=colour, mfc="white")
    axes.set_xlim(0, 1.06 * rows.spacing.max())


def main():
    arguments = figure_arguments(__doc__, "table", "runs")
    rows = ladders(arguments)
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:4], STYLES)
    points, kinds = list(dict.fromkeys(rows.point)), list(dict.fromkeys(rows.error_kind))
    figure = style.new_figure(style.PAGE, 0.8 + 1.9 * max(1, len(kinds)))
    if len(rows):
        grid = figure.subplots(len(kinds), len(points), squeeze=False, sharex=True)
        for line, kind in zip(grid, kinds, strict=True):
            for axes, point in zip(line, points, strict=True):
                part = rows[(rows.error_kind == kind) & (rows.point == point)]
                best = part[part.method == "phi4_corrected"]
                expected = best["class"].iloc[0] if len(best) else ""
                draw(axes, part, expected)
                if kind == kinds[0]:
                    axes.set_title(f"{point}, {expected}", loc="left")
            name = kind.partition(",")[0]
            line[0].set_ylabel(NAMES.get(name, name))
        for axes in grid[-1]:
            axes.set_xlabel(r"lattice spacing $\Delta x$ / μm")
        style.legend_below(figure, ncols=3)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
