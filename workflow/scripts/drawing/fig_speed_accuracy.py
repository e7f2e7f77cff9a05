"""Speed against accuracy, the headline: error of (a) the critical capillary number and (b) the lateral
extent against minutes on one core, from rules without a passage through the presets. The step line is
the frontier, the grey band the error of the preset by which the others are judged.

(a) The largest relative difference of the middle of the bracket from that of `reference`, over the row
shifts of d = 6 um and more (filled, stiff cells) and over those below (open, soft cells); a triangle is
a bracket that is open, whose difference is at least that large. The band is half the widest bracket of
`reference`. A rule has its boundary where the tweezer's diameter of the grid passes 2 s: s of the printed
law, of the simulated flow (3D) or of the depth-averaged one (2D). (b) The
largest relative error of D_perp over the points of the accuracy study; of the tweezer's diameter over
the displaced cells of the grid.
"""

import numpy as np
import pandas as pd
from matplotlib.ticker import FuncFormatter, NullFormatter
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import UNDISPUTED
from study.analysis.frontier import on_frontier, step_line
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.paper.claims import SWEEP
from study.planning.documents import read_json

COLUMNS = ["quantity", "name", "cells", "minutes", "error", "at_least", "band"]
#: Series of brackets that were made with a preset, and the preset.
PRESETS = {"draft": "draft", "default": "standard", "corrected": "corrected", "refined": "refined"}
PRESETS |= {"reference": "reference"}
REFERENCE, STIFF_FROM_UM = "reference", 6.0
#: Rules without a passage: name, and the size (um) that the extent of the stretched cell has to exceed.
RULES = {"rule, printed law": "printed_d_cr_um", "rule, 3D flow": "s_um", "rule, 2D flow": "s_flat_um"}
FLAT = "depth-averaged flow"


def middles(brackets):
    """{row shift: (middle, half width relative to it, open on one side)} of a series of brackets."""
    found = {}
    for row in brackets.to_dict("records"):
        low, high = (row[name] for name in UNDISPUTED)
        if low == low and high == high:
            found[row["row_shift_um"]] = (np.sqrt(low * high), np.sqrt(high / low) - 1, False)
        elif low == low or high == high:
            found[row["row_shift_um"]] = (low if low == low else high, 0.0, True)
    return found


def rule_middles(grid, column):
    """The same of a rule: the capillary number at which the extent passes the size, by row shift."""
    found = {}
    for shift, cells in grid.groupby("row_shift_um"):
        cells = cells.sort_values("capillary_number").drop_duplicates("capillary_number")
        size = cells[column] * (2 if column.startswith("s_") else 1)
        excess = (cells.tweezer_um - size).to_numpy()
        numbers = np.log(cells.capillary_number.to_numpy())
        for k in np.flatnonzero((excess[:-1] > 0) & (excess[1:] <= 0))[:1]:
            share = excess[k] / (excess[k] - excess[k + 1])
            found[shift] = (float(np.exp(numbers[k] + share * (numbers[k + 1] - numbers[k]))), 0.0, False)
    return found


def critical_rows(found, truth, minutes, name):
    """Largest difference from the reference of one setting, of stiff and of soft cells."""
    band = max((half for _, half, is_open in truth.values() if not is_open), default=None)
    for cells in ("stiff", "soft"):
        errors = {}
        for shift in set(found) & set(truth):
            if truth[shift][2] or (shift >= STIFF_FROM_UM) != (cells == "stiff"):
                continue
            errors[shift] = (abs(found[shift][0] / truth[shift][0] - 1), found[shift][2])
        if errors:
            error, at_least = max(errors.values())
            row = {"quantity": "critical Ca", "name": name, "cells": cells, "minutes": minutes}
            yield row | {"error": error, "at_least": int(at_least), "band": band}


def bracket_times(times):
    """Median minutes of a passage by series of brackets."""
    rows = times[times.stage.isin(["boundary", "uncertainty"])].drop_duplicates("part")
    return dict(zip(rows.part, rows.median_s / 60, strict=True))


def flat_separation(cheap, row_shifts):
    """(s in um at these row shifts, seconds) of the depth-averaged flow on its finest grid: the power law
    through its points; (None, None) without two of them."""
    flat = cheap[cheap.method == FLAT].drop_duplicates("row_shift_um", keep="last")
    if len(flat) < 2:
        return None, None
    slope, level = np.polyfit(np.log(flat.row_shift_um), np.log(flat.s_um), 1)
    return np.exp(level + slope * np.log(row_shifts)), flat.seconds.max()


def rule_minutes(a_priori, times, flat_seconds):
    """Minutes that a rule takes: stretched cells for the diameter, the flow for s."""
    stretching = times[times.stage == "stretching"].median_s
    flow = times[(times.stage == "streamlines") & (times.part == a_priori.s_variant.iloc[0])].median_s
    if not len(stretching):
        return {}
    cell = stretching.min()
    seconds = {"rule, printed law": cell}
    if len(flow):
        seconds["rule, 3D flow"] = cell + flow.iloc[0]
    if flat_seconds:
        seconds["rule, 2D flow"] = cell + flat_seconds
    return {name: value / 60 for name, value in seconds.items()}


def collect(accuracy, boundary, a_priori, times, cheap):
    """All rows of the figure."""
    minutes, known = bracket_times(times), dict(list(boundary.groupby("series")))
    grid = a_priori[a_priori.sweep == SWEEP]
    flat, flat_seconds = flat_separation(cheap, grid.row_shift_um)
    grid = grid.assign(s_flat_um=flat)
    rules = rule_minutes(grid, times, flat_seconds) if len(grid) else {}
    if REFERENCE in known:
        truth = middles(known[REFERENCE])
        for series, preset in PRESETS.items():
            if series in known and series in minutes and series != REFERENCE:
                yield from critical_rows(middles(known[series]), truth, minutes[series], preset)
        band = max((half for _, half, is_open in truth.values() if not is_open), default=None)
        row = {
            "quantity": "critical Ca",
            "name": REFERENCE,
            "cells": "stiff",
            "minutes": minutes.get(REFERENCE),
        }
        yield row | {"error": band, "at_least": 0, "band": band}
        for rule, column in RULES.items():
            if rules.get(rule) and len(grid):
                yield from critical_rows(rule_middles(grid, column), truth, rules[rule], rule)
    rows = accuracy[(accuracy.method == "preset") & (accuracy.point != "all")]
    rows = rows[rows.error_kind.astype(str).str.startswith("D_perp") & rows.error.notna()]
    for preset, part in rows.groupby("setting"):
        row = {"quantity": "D_perp", "name": preset, "cells": "all", "minutes": part.seconds.median() / 60}
        yield row | {"error": part.error.max(), "at_least": 0, "band": part.reference_uncertainty.max()}
    decided = grid[(grid["class"] == "displaced") & grid.d_perp_um.notna()]
    if len(decided) and rules.get("rule, printed law"):
        error = (decided.tweezer_um / decided.d_perp_um - 1).abs().max()
        row = {
            "quantity": "D_perp",
            "name": "stretched cell",
            "cells": "all",
            "minutes": rules["rule, printed law"],
        }
        yield row | {"error": error, "at_least": 0, "band": None}


def draw_points(axes, rows, face, label):
    """Filled or open points, and triangles where the difference is at least that large."""
    for at_least, marker, more in ((0, "o", ""), (1, "^", ", at least")):
        shown = rows[rows.at_least == at_least]
        if len(shown):
            look = {"ms": 5, "mew": 1, "color": style.BLUE, "mfc": face, "ls": "", "zorder": 4}
            axes.plot(shown.minutes, 100 * shown.error, marker, label=f"{label}{more}", **look)


def draw(axes, rows):
    """One panel, errors in per cent."""
    main, band = rows[rows.cells != "soft"], rows.band.max()
    levels = [level for level in (*rows.error, band) if level > 0]
    low, closed = 100 * min(levels) / 2.5, main[main.at_least == 0]
    axes.set(xscale="log", yscale="log", xlabel="minutes on one core, for one cell")
    floor = band if band > 0 else 0.0
    if floor:
        axes.axhspan(
            low, 100 * band, color="#777777", alpha=0.2, lw=0, zorder=0, label="error of the reference"
        )
    kept = closed[on_frontier(closed.minutes, np.fmax(closed.error, floor))]
    if len(kept):
        x, y = step_line(kept.minutes, np.fmax(kept.error, floor))
        axes.plot(x, 100 * y, color=style.BLACK, lw=2.2, alpha=0.35, zorder=1, label="frontier")
    draw_points(axes, rows[rows.cells == "soft"], "white", "soft cells, d below 6 μm")
    draw_points(axes, main, style.BLUE, "stiff cells; in (b) all")
    for row in main.itertuples():
        beside = main[(main.minutes / row.minutes).between(0.45, 2.2) & (main.name != row.name)]
        above = len(beside) > 0 and row.error >= beside.error.max()
        place = {"xytext": (0, 5 if above else -11), "textcoords": "offset points", "ha": "center"}
        axes.annotate(row.name, (row.minutes, 100 * row.error), fontsize=7, zorder=6, **place)
    axes.set(ylim=(low, 250 * max(levels)), xlim=(rows.minutes.min() / 3, rows.minutes.max() * 3))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())


def main():
    arguments = figure_arguments(__doc__, "accuracy", "boundary", "uncertainty", "a-priori", "times", "cheap")
    plan = read_json(arguments.plan)
    boundary = read_table(arguments.boundary)[["series", "row_shift_um", *UNDISPUTED]]
    others = read_table(arguments.uncertainty)[["series", "row_shift_um", *UNDISPUTED]]
    named = {name: getattr(arguments, name) for name in ("accuracy", "a_priori", "times", "cheap")}
    tables = {name: read_table(path) for name, path in named.items()}
    boundary = pd.concat([boundary, others]).drop_duplicates(["series", "row_shift_um"])
    rows = list(collect(boundary=boundary, **tables))
    styles = {"minutes": ".3g", "error": ".3f", "band": ".3f"}
    write_table(rows, COLUMNS, arguments.csv, COLUMNS[:3], styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 3.3)
    panels = figure.subplots(1, 2)
    titles = {"critical Ca": "error of the critical Ca / %", "D_perp": r"error of $D_\perp$ / %"}
    for axes, (quantity, title), letter in zip(panels, titles.items(), "ab", strict=True):
        part = table[table.quantity == quantity]
        if len(part):
            draw(axes, part)
        axes.set_title(f"({letter}) {title}", loc="left")
    style.legend_below(figure, 4, fontsize=7)
    style.save(figure, arguments.output, plan["note"])


main()
