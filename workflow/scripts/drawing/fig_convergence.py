"""D_perp and film of the passages of the accuracy study against the lattice spacing: couplings that are
right meet at dx = 0. The plain and the corrected kernel decide, others are thin and grey; the CSV has
the centre at the gap line as well. Open markers have another class than the corrected coupling on the
finest lattice: their D_perp is of another crossing."""

import re

from study.analysis.accuracy import passage_ladders
from study.analysis.arguments import figure_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.planning.documents import read_json

COLUMNS = ["point", "error_kind", "method", "spacing", "value", "class"]
STYLES = {"spacing": ".4f", "value": ".4f"}
#: What the legend calls a coupling, and its colour, marker and width; others are drawn in grey.
LOOKS = {
    "phi4": ("plain kernel", style.GREEN, "^", 1.4),
    "phi4_corrected": ("corrected kernel", style.BLUE, "o", 1.4),
    "phi4_corrected, finer mesh": ("corrected, edges of 0.7 dx", "#999999", "D", 0.7),
    "phi4_corrected, interpolated walls": ("corrected, interpolated walls", "#999999", "s", 0.7),
}
#: The lengths drawn.
NAMES = {"D_perp": r"$D_\perp$ / μm", "film": "film / μm"}


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
        label, colour, marker, width = LOOKS.get(method, (method, "#BBBBBB", "x", 0.7))
        axes.plot(part.spacing, part.value, color=colour, lw=width, marker=marker, ms=3.5, label=label)
        other = part[part["class"] != expected]
        axes.plot(other.spacing, other.value, marker, color=colour, mfc="white", ms=3.5)
    axes.set_xlim(0, 1.06 * rows.spacing.max())


def main():
    arguments = figure_arguments(__doc__, "table", "runs")
    rows = ladders(arguments)
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:4], STYLES)
    points = list(dict.fromkeys(rows.point))
    kinds = [kind for kind in dict.fromkeys(rows.error_kind) if kind.partition(",")[0] in NAMES]
    figure = style.new_figure(style.PAGE, 0.8 + 1.5 * max(1, len(kinds)))
    if len(rows):
        grid = figure.subplots(len(kinds), len(points), squeeze=False, sharex=True)
        for line, kind in zip(grid, kinds, strict=True):
            for axes, point in zip(line, points, strict=True):
                part = rows[(rows.error_kind == kind) & (rows.point == point)]
                best = part[part.method == "phi4_corrected"]
                expected = best["class"].iloc[0] if len(best) else ""
                draw(axes, part, expected)
                if kind == kinds[0]:
                    place = re.sub(r"\bum\b", "μm", point.replace("d =", "$d$ ="))
                    axes.set_title(f"{place}, {expected}", loc="left")
            line[0].set_ylabel(NAMES[kind.partition(",")[0]])
        for axes in grid[-1]:
            axes.set_xlabel(r"lattice spacing $\Delta x$ / μm")
        style.legend_below(figure, ncols=4)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
