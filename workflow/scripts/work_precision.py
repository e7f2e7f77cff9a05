"""Work-precision diagram of one study: error against work units and against seconds, over all points. For
passages each point stands for itself, error against work: a setting that finds the class at one point may
miss it at another.

Lower left is better. Lines join settings that are steps of one quantity, the step line is the Pareto
frontier, open markers at the upper edge are settings that failed or found another class, and the grey bands
are the uncertainty of the references, below which nothing is told apart. Beside it stand the settings on the
frontier, with the number of others of the same cost and error; of passages those on the frontier of any
point, with their errors at all of them.
"""

import re
import textwrap

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter
from study import style
from study.accuracy import ALL, judged_points
from study.arguments import figure_arguments
from study.frontier import on_frontier, step_line
from study.plan import read_json
from study.tables import read_table, write_table

COSTS = {"work_units": "work / node updates", "seconds": "run time / s"}
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "h", "p", "*", "d", "8", "$+$", "1", (4, 1, 0)]
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
NAME_WIDTH = 36  # letters of a setting before its line breaks
#: A setting that is a step of one quantity: 0.4 um, x 0.25, 20 cells.
STEP = re.compile(r"(?:x )?([0-9.]+)(?: \w+)?")
STYLES = dict.fromkeys(["error", "reference_uncertainty", "work_units", "seconds"], ".3e")


def resolved(rows):
    """Errors as far as the references can tell."""
    return np.fmax(rows.error.to_numpy(float), rows.reference_uncertainty.fillna(0.0).to_numpy(float))


def looks(rows):
    """Colour and marker of each method, in the order of the table."""
    names = sorted(rows.method.unique())
    colours = [colour for colour, _ in style.SERIES]
    return {name: (colours[i % len(colours)], MARKERS[i % len(MARKERS)]) for i, name in enumerate(names)}


def ordered_steps(part):
    """The rows of a method in the order of their steps; whether a line joins them: where all are steps."""
    steps = [STEP.fullmatch(setting) for setting in part.setting]
    if not all(steps):
        return part, False
    order = np.argsort([float(step[1]) for step in steps], kind="stable")
    return part.iloc[order], True


def draw(axes, rows, cost, look, named):
    """One panel: the settings of one kind of error against one cost. `named`: methods in the legend."""
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
        ordered, joined = ordered_steps(part)
        errors = ordered.error.clip(lower=low)  # none at all: at the lower edge
        line = "-" if joined else "none"
        axes.plot(ordered[cost], errors, linestyle=line, marker=marker, color=colour, lw=0.8, label=method)
    for method, part in failed.groupby("method"):
        colour, marker = look[method]
        edge = np.full(len(part), high)
        label = None if method in named else f"{method} ({part.status.iloc[0]})"
        axes.plot(
            part[cost],
            edge,
            marker=marker,
            linestyle="none",
            color=colour,
            mfc="none",
            ms=6,
            clip_on=False,
            zorder=5,
            label=label,
        )


def write_list(axes, places, heads, lines):
    """A small table in words: the first column from the left, the others from the right."""
    axes.set_axis_off()
    if len(lines) > LISTED:
        lines = [*lines[:LISTED], (f"and {len(lines) - LISTED} more",)]
    line, top = 1.0 / (LISTED + 2), 1.0
    for number, texts in enumerate([heads, *lines]):
        size, weight = (6.5, "normal") if number else (7, "bold")
        name = textwrap.wrap(texts[0], NAME_WIDTH, subsequent_indent="   ")
        for column, (place, text) in enumerate(zip(places, ["\n".join(name), *texts[1:]], strict=False)):
            align = "right" if column else "left"
            axes.text(place, top, text, ha=align, va="top", fontsize=size, weight=weight)
        top -= line * len(name)


def printed(text):
    """A name of the tables as it is printed."""
    return re.sub(r"\bum\b", "μm", text.replace("D_perp", r"$D_\perp$"))


def name_of(row):
    """Method and setting in words."""
    return printed(f"{row.method}: {row.setting}" if row.setting else row.method)


def shown_error(row):
    """Text of an error, as far as the reference can tell."""
    below = row.error < row.reference_uncertainty
    return f"< {row.reference_uncertainty:.1e}" if below else f"{row.error:.1e}"


def list_frontier(axes, rows):
    """The settings on the frontier, with error and work."""
    lines = []
    kept = rows[rows.on_frontier == 1].sort_values("work_units").groupby(["work_units", "error"], sort=False)
    for (work, _), part in kept:
        more = f" (+{len(part) - 1})" if len(part) > 1 else ""
        lines.append((name_of(part.iloc[0]) + more, shown_error(part.iloc[0]), f"{work:.1e}"))
    write_list(axes, (0.0, 0.78, 0.99), ("on the frontier", "error", "work"), lines)


def list_frontiers(axes, rows):
    """The settings on the frontier of any point, cheapest first, with their errors at every point."""
    points = list(dict.fromkeys(rows.point))
    named = rows.assign(name=[name_of(row) for row in rows.itertuples()])
    chosen = named[named.on_frontier == 1].groupby("name").work_units.mean().sort_values()
    lines = []
    for name in chosen.index:
        at = {row.point: row for row in named[named.name == name].itertuples()}
        texts = [shown_error(at[point]) if at[point].status == "ok" else "fails" for point in points]
        lines.append((name, *texts))
    heads = ("on a frontier", *(printed(point.partition(",")[0].removeprefix("d = ")) for point in points))
    write_list(axes, (0.0, 0.66, 0.83, 1.0), heads, lines)


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
    look, named = looks(rows), set(rows.method[rows.status == "ok"])
    panels = panels_of(rows)
    several = rows.point.nunique() > 1
    write = list_frontiers if several else list_frontier
    figure = style.new_figure(12.5 if several else 10.0, 0.9 + 2.4 * len(kinds))
    grid = figure.subplots(
        len(kinds), len(panels) + 1, squeeze=False, width_ratios=[1.0] * len(panels) + [1.2]
    )
    for line, kind in zip(grid, kinds, strict=True):
        part = rows[rows.error_kind == kind]
        for axes, (point, cost) in zip(line, panels, strict=False):
            draw(axes, part[part.point == point], cost, look, named)
            if several and kind == kinds[0]:
                axes.set_title(printed(point), loc="left", pad=8)
        line[0].set_ylabel(f"error of {printed(kind)}")
        write(line[-1], part)
    style.legend_below(figure, ncols=4)
    style.save(figure, arguments.output, plan["note"])


main()
