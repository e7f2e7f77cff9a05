"""Work-precision diagram of one study: error against work units, a panel for every kind of error, over
all points.

Lower left is better. The step line is the Pareto frontier; its settings are named, of passages the
presets. Coloured lines join the settings of a method that are steps of one quantity; all other settings
are grey. The grey band is the uncertainty of the references, below which nothing is told apart.
Settings that failed or found another class at some point are not drawn, as no goal can be met with
them; the CSV has them, and of passages the errors at each point.
"""

import re

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter
from study.analysis.accuracy import ALL, judged_points
from study.analysis.arguments import figure_arguments
from study.analysis.frontier import on_frontier, step_line
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.planning.documents import read_json

COLUMNS = [
    "point",
    "error_kind",
    "method",
    "setting",
    "error",
    "reference",
    "reference_uncertainty",
    "work_units",
]
COLUMNS += ["seconds", "status", "on_frontier"]
PRESETS = "preset"
COLOURS = [style.BLUE, style.GREEN, style.ORANGE, style.PURPLE, style.SKY]
#: A setting that is a step of one quantity: 0.4 um, x 0.25, 20 cells.
STEP = re.compile(r"(?:x )?([0-9.]+)(?: \w+)?")
STYLES = dict.fromkeys(["error", "reference_uncertainty", "work_units", "seconds"], ".3e")


def resolved(rows):
    """Errors as far as the references can tell."""
    return np.fmax(rows.error.to_numpy(float), rows.reference_uncertainty.fillna(0.0).to_numpy(float))


def ordered_steps(part):
    """The rows of a method in the order of their steps; whether a line joins them: where all are steps."""
    steps = [STEP.fullmatch(setting) for setting in part.setting]
    if not all(steps):
        return part, False
    order = np.argsort([float(step[1]) for step in steps], kind="stable")
    return part.iloc[order], True


def printed(text):
    """A name of the tables as it is printed."""
    return re.sub(r"\bum\b", "μm", text.replace("D_perp", "@").replace("_", " ").replace("@", r"$D_\perp$"))


def ladders(rows):
    """The methods whose settings are steps of one quantity, those most often on a frontier first: one for
    each colour."""
    counts = {}
    for method, part in rows.groupby("method"):
        if part.setting.nunique() > 1 and ordered_steps(part)[1]:
            counts[method] = part.on_frontier.sum(), part.setting.nunique()
    return sorted(counts, key=lambda method: (*(-one for one in counts[method]), method))[: len(COLOURS)]


def set_axes(axes, rows, kind):
    """Logarithmic axes of at least a decade, so that there is a labelled tick; the lowest error shown."""
    floors = rows.reference_uncertainty.dropna()
    levels = [level for level in (*rows.error, *floors) if level > 0] or [1e-3]
    low, high = min(levels) / 2, 3 * max(levels)
    axes.set(xscale="log", yscale="log", ylim=(low, max(high, 20 * low)), xlabel="work / node updates")
    axes.set_title(printed(kind), loc="left")
    axes.xaxis.set_major_locator(LogLocator(numticks=6))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_formatter(NullFormatter())
    spread = rows.work_units.dropna()
    if len(spread) and spread.min() > 0:
        middle, decades = np.sqrt(spread.min() * spread.max()), np.log10(spread.max() / spread.min())
        reach = 10 ** (0.5 * max(1.35 * decades, 1.2))
        axes.set_xlim(middle / reach, middle * reach)
    if len(floors):
        axes.axhspan(low, floors.max(), color="#777777", alpha=0.18, lw=0, zorder=0)
    return low


def name_points(axes, rows, low):
    """Names beside their points, above and below in turn along the work, so that neighbours keep apart; those
    near an edge reach towards the middle."""
    ends = np.log(axes.get_xlim())
    for number, row in enumerate(rows.sort_values("work_units").itertuples()):
        text = row.setting if row.method == PRESETS or not row.setting else f"{row.method}, {row.setting}"
        text = printed(text if row.setting else row.method)
        share = (np.log(row.work_units) - ends[0]) / (ends[1] - ends[0])
        align = "left" if share < 0.25 else "right" if share > 0.75 else "center"
        place = {"xytext": (0, -11 if number % 2 else 5), "textcoords": "offset points", "ha": align}
        axes.annotate(text, (row.work_units, max(row.error, 1.3 * low)), fontsize=7, zorder=6, **place)


def draw(axes, rows, kind, coloured):
    """One panel: the settings of one kind of error."""
    good = rows[(rows.status == "ok") & rows.error.notna() & rows.work_units.notna() & (rows.work_units > 0)]
    low = set_axes(axes, good, kind)
    if good.empty:
        return
    kept = good[on_frontier(good.work_units, resolved(good))]
    axes.plot(*step_line(kept.work_units, resolved(kept)), color=style.BLACK, lw=2.2, alpha=0.35, zorder=1)
    for method, part in good.groupby("method"):
        if method == PRESETS:
            look = {"color": style.VERMILION, "marker": "D", "ms": 5, "zorder": 5, "ls": ""}
        elif method in coloured:
            colour = COLOURS[coloured.index(method)]
            look = {"color": colour, "marker": "o", "ms": 3.5, "lw": 0.9, "zorder": 4}
            part = ordered_steps(part)[0]
        else:
            look = {"color": "#BBBBBB", "marker": "o", "ms": 3, "ls": "", "zorder": 2}
        axes.plot(part.work_units, part.error.clip(lower=low), **look)
    named = good[good.method == PRESETS]
    if named.empty:
        named = kept[~kept.method.isin(coloured)].drop_duplicates(["work_units", "error"])
    name_points(axes, named, low)


def main():
    arguments = figure_arguments(__doc__, "table", "study")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    table["setting"] = table.setting.astype(object).where(table.setting.notna(), "").astype(str)
    table = table[table.study == arguments.study]
    judged = judged_points(table)
    order = ["point", "error_kind", "work_units"]
    write_table(judged.to_dict("records"), COLUMNS, arguments.csv, order, STYLES)
    rows = table[table.point == ALL]
    kinds = list(dict.fromkeys(rows.error_kind))
    coloured = ladders(rows[rows.status == "ok"])
    figure = style.new_figure(style.PAGE if len(kinds) > 1 else 4.4, 3.0)
    grid = figure.subplots(1, max(len(kinds), 1), squeeze=False)[0]
    for axes, kind in zip(grid, kinds, strict=False):
        draw(axes, rows[rows.error_kind == kind], kind, coloured)
    grid[0].set_ylabel("largest error over all points")
    entries = [(printed(method), colour, "-") for method, colour in zip(coloured, COLOURS, strict=False)]
    entries += [("other settings", "#BBBBBB", "")]
    entries += [("presets", style.VERMILION, "")] if PRESETS in set(rows.method) else []
    for name, colour, line in entries:
        grid[0].plot([], [], "o", color=colour, ls=line, ms=3.5, lw=0.9, label=name)
    grid[0].plot([], [], color=style.BLACK, lw=2.2, alpha=0.35, label="frontier")
    style.legend_below(figure, ncols=3, fontsize=7)
    style.save(figure, arguments.output, plan["note"])


main()
