"""Work-precision diagram of one study: error against work units and against seconds, over all points. For
passages each point stands for itself, error against work: a setting that finds the class at one point may
miss it at another.

Lower left is better. Lines join the ladders of a method, the step line is the Pareto frontier, open markers
at the upper edge are settings that failed or found another class, and the grey bands are the uncertainty of
the references, below which nothing is told apart. Beside it stand the settings on the frontier, with the
number of others of the same cost and error.
"""

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter
from study import style
from study.accuracy import ALL, judged_points
from study.arguments import figure_arguments
from study.frontier import on_frontier, step_line
from study.plan import read_json
from study.tables import read_table, write_table

COSTS = {"work_units": "work / node updates", "seconds": "run time / s"}
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "h", "p", "*", "d", "8"]
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
LISTED = 12  # settings of the frontier that find room beside the diagram
STYLES = dict.fromkeys(["error", "reference_uncertainty", "work_units", "seconds"], ".3e")


def resolved(rows):
    """Errors as far as the references can tell."""
    return np.fmax(rows.error.to_numpy(float), rows.reference_uncertainty.fillna(0.0).to_numpy(float))


def looks(rows):
    """Colour and marker of each method, in the order of the table."""
    names = sorted(rows.method.unique())
    colours = [colour for colour, _ in style.SERIES]
    return {name: (colours[i % len(colours)], MARKERS[i % len(MARKERS)]) for i, name in enumerate(names)}


def draw(axes, rows, cost, look, ladders):
    """One panel: the settings of one kind of error against one cost."""
    good = rows[(rows.status == "ok") & rows.error.notna() & rows[cost].notna()]
    failed = rows[(rows.status != "ok") & rows[cost].notna()]
    floors = sorted(set(rows.reference_uncertainty.dropna()))
    levels = [level for level in (*good.error, *floors) if level > 0] or [1e-3]
    low, high = min(levels) / 2, 4 * max(levels)
    axes.set(xscale="log", yscale="log", ylim=(low, high), xlabel=COSTS[cost])
    axes.xaxis.set_major_locator(LogLocator(numticks=8))
    axes.xaxis.set_minor_formatter(NullFormatter())
    spread = rows[cost].dropna()
    if len(spread) and spread.min() > 0:
        # At least one decade, so that there is a labelled tick.
        middle, decades = np.sqrt(spread.min() * spread.max()), np.log10(spread.max() / spread.min())
        reach = 10 ** (0.5 * max(1.1 * decades, 1.2))
        axes.set_xlim(middle / reach, middle * reach)
    for floor in floors:
        axes.axhspan(low, floor, color="#777777", alpha=0.18, lw=0, zorder=0)
    kept = good[on_frontier(good[cost], resolved(good))]
    if len(kept):
        x, y = step_line(kept[cost], resolved(kept))
        axes.plot(x, y, color=style.BLACK, lw=2.2, alpha=0.35, zorder=1, solid_capstyle="butt")
    for method, part in good.groupby("method"):
        colour, marker = look[method]
        ordered = part.sort_values(cost)
        line = "-" if method in ladders else ""
        errors = ordered.error.clip(lower=low)  # none at all: at the lower edge
        axes.plot(ordered[cost], errors, line, marker=marker, color=colour, lw=0.8, label=method)
    for method, part in failed.groupby("method"):
        colour, marker = look[method]
        edge = np.full(len(part), high)
        axes.plot(part[cost], edge, marker, color=colour, mfc="none", ms=6, clip_on=False, zorder=5)


def list_frontier(axes, rows):
    """The settings on the frontier as a small table."""
    axes.set_axis_off()
    kept = rows[rows.on_frontier == 1].sort_values("work_units").groupby(["work_units", "error"], sort=False)
    places, line = (0.0, 0.74, 0.99), 1.0 / (LISTED + 2)
    heads = ("on the frontier", "error", "work")
    aligned = ("left", "right", "right")
    for place, text, align in zip(places, heads, aligned, strict=True):
        axes.text(place, 1.0, text, weight="bold", ha=align, va="top", fontsize=7)
    for number, ((work, error), part) in enumerate(kept, 1):
        if number > LISTED:
            axes.text(0, 1.0 - number * line, f"and {len(kept) - LISTED} more", va="top", fontsize=6.5)
            break
        row = part.iloc[0]
        name = f"{row.method}: {row.setting}" if row.setting else row.method
        name += f" (+{len(part) - 1})" if len(part) > 1 else ""
        below = error < row.reference_uncertainty
        texts = (name, f"< {row.reference_uncertainty:.1e}" if below else f"{error:.1e}", f"{work:.1e}")
        for place, text, align in zip(places, texts, aligned, strict=True):
            axes.text(place, 1.0 - number * line, text, ha=align, va="top", fontsize=6.5)


def panels_of(rows):
    """(point, cost) of the panels of a line: every point against work, or all points against every cost."""
    points = list(dict.fromkeys(rows.point))
    if points != [ALL]:
        return [(point, "work_units") for point in points]
    return [(ALL, cost) for cost in COSTS if rows[cost].notna().any()]


def main():
    arguments = figure_arguments(__doc__, "table", "study")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    table["setting"] = table.setting.astype(object).where(table.setting.notna(), "").astype(str)
    rows = judged_points(table[table.study == arguments.study])
    write_table(
        rows.to_dict("records"), COLUMNS, arguments.csv, ["point", "error_kind", "work_units"], STYLES
    )
    kinds = list(dict.fromkeys(rows.error_kind))
    methods = plan["accuracy"]["studies"].get(arguments.study, {}).get("methods", {})
    ladders = {name for name, method in methods.items() if "ladder" in method} | {"depth-averaged flow"}
    look = looks(rows)
    panels = panels_of(rows)
    listed = rows.point.nunique() == 1
    figure = style.new_figure(10.0, 0.9 + 2.4 * len(kinds))
    widths = [1.0] * len(panels) + [1.05] * listed
    grid = figure.subplots(len(kinds), len(widths), squeeze=False, width_ratios=widths)
    for line, kind in zip(grid, kinds, strict=True):
        part = rows[rows.error_kind == kind]
        for axes, (point, cost) in zip(line, panels, strict=False):
            draw(axes, part[part.point == point], cost, look, ladders)
            if not listed and kind == kinds[0]:
                axes.set_title(point, loc="left", pad=8)
        line[0].set_ylabel(f"error of {kind}")
        if listed:
            list_frontier(line[-1], part)
    style_handles = {}
    for axes in grid[:, : len(panels)].ravel():
        style_handles |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    figure.legend(style_handles.values(), style_handles.keys(), loc="outside lower center", ncols=4)
    style.save(figure, arguments.output, plan["note"])


main()
