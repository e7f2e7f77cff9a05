"""Slowing near the boundary: mean speed of the cells against Ca over the critical Ca of their row
shift, with the printed ratio (a cell of Ca = 0.3 at d = 6.0 um). The time of the slowest row is in the
CSV: the cell lingers at a stagnation point of the gap, so that it grows as -ln |Ca / Ca_c - 1|."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import PARAMETERS, critical_capillary_number
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import GREY, MARKERS, panel_note, shade
from study.paper.claims import load_claims
from study.planning.classes import DECIDED
from study.planning.documents import read_json

COLUMNS = [
    "sweep",
    "row_shift_um",
    "capillary_number",
    "class",
    "speed_um_per_kilostep",
    "slowest_row_kilosteps",
]
COLUMNS += ["critical_capillary_number", "half_width", "distance", "relative_speed", "run"]
SHIFT, STIFF, SLOW = 6.0, 0.1, 0.3  # row shift (um) and the capillary numbers of the printed ratio of speeds
SERIES = "default"  # of the brackets with the settings of the sweep


def slowest_rows(crossings):
    """Longest time from one pillar line to the next, in 1000 steps, by run."""
    ordered = crossings.sort_values(["run", "row"]).drop_duplicates(["run", "row"])
    return ordered.groupby("run").step.diff().div(1000).groupby(ordered.run).max()


def critical_numbers(boundary):
    """Middle and half width, as a ratio less 1, of the two-sided brackets of the default settings, by row
    shift. A wide bracket counts too: its width is shown."""
    rows = boundary[(boundary.series == SERIES) & boundary[["ca_displaced", "ca_zigzag"]].notna().all(axis=1)]
    middle = np.sqrt(rows.ca_displaced * rows.ca_zigzag)
    table = rows.assign(middle=middle, half_width=np.sqrt(rows.ca_zigzag / rows.ca_displaced) - 1)
    return table.groupby(rows.row_shift_um.round(3))[["middle", "half_width"]].first()


def cells(passages, crossings, boundary, plan):
    """Cells of the sweep and those of the brackets with its settings, each once."""
    names = [plan["figures"]["trajectory_sweep"], f"boundary/{SERIES}"]
    rows = passages[passages.sweep.isin(names)].drop_duplicates("run")
    shifts, known = rows.row_shift_um.round(3), critical_numbers(boundary)
    critical = shifts.map(known.middle)
    return rows.assign(
        slowest_row_kilosteps=rows.run.map(slowest_rows(crossings)),
        critical_capillary_number=critical,
        half_width=shifts.map(known.half_width),
        distance=rows.capillary_number / critical - 1,
    )


def relative_speed(rows):
    """Mean speed over that of the stiff cell with which the paper compares, at the same row shift."""
    stiff = rows[np.isclose(rows.capillary_number.astype(float), STIFF)]
    return rows.speed_um_per_kilostep / rows.row_shift_um.map(
        stiff.groupby("row_shift_um").speed_um_per_kilostep.first()
    )


def draw(axes, rows, printed):
    """A line for every row shift with a known critical capillary number, and the printed ratio."""
    shown = rows[rows.critical_capillary_number.notna() & rows.relative_speed.notna()]
    shown = shown[shown["class"].isin(DECIDED)]
    shifts = sorted(shown.row_shift_um.unique())
    for k, shift in enumerate(shifts):
        line = shown[shown.row_shift_um == shift].sort_values("capillary_number")
        colour, places = shade(k, len(shifts)), line.capillary_number / line.critical_capillary_number
        axes.plot(places, line.relative_speed, color=colour, lw=0.9, label=rf"$d$ = {shift:.1f} μm")
        for name, part in line.groupby("class"):
            look = {"ms": 3.2, "mew": 0.8, "mfc": colour if name == "displaced" else "white", "color": colour}
            at = part.capillary_number / part.critical_capillary_number
            axes.plot(at, part.relative_speed, MARKERS[name], ls="", zorder=3, **look)
    for name in sorted(shown["class"].unique()):
        look = {"ms": 3.5, "mfc": GREY if name == "displaced" else "white", "color": GREY}
        axes.plot([], [], MARKERS[name], ls="", label=name, **look)
    if shown.empty:
        axes.set(xticks=[], yticks=[])
        panel_note(axes, "no two-sided bracket of the boundary")
        return
    place = SLOW / critical_capillary_number(SHIFT, printed["law"])
    look = {"ms": 7, "mew": 1.4, "color": style.BLACK, "zorder": 5}
    axes.plot(place, printed["ratio"], "x", ls="", label=f"paper, $d$ = {SHIFT:.1f} μm", **look)
    axes.axvline(1, color=style.BLACK, lw=0.7)
    axes.set_xscale("log")
    ticks = [0.2, 0.5, 1, 2, 5, 10, 20]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set(
        xlabel=r"Ca over the critical Ca of the row shift", ylabel=f"mean speed over that at Ca = {STIFF:g}"
    )
    axes.set_ylim(bottom=0)


def main():
    arguments = figure_arguments(__doc__, "table", "crossings", "boundary", "claims")
    plan, claims = read_json(arguments.plan), load_claims(arguments.claims)
    tables = (read_table(path) for path in (arguments.table, arguments.crossings, arguments.boundary))
    rows = cells(*tables, plan)
    rows = rows.assign(relative_speed=relative_speed(rows))
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g"} | dict.fromkeys(COLUMNS[4:10], ".4f")
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:3], styles)
    figure = style.new_figure(style.COLUMN, 3.5)
    law = [claims["phase-boundary"]["value"][name] for name in PARAMETERS]
    draw(figure.add_subplot(), rows, {"law": law, "ratio": claims["slow-near-boundary"]["value"]})
    style.legend_below(figure, 3, fontsize=7, handlelength=1.4, columnspacing=1.0)
    style.save(figure, arguments.output, plan["note"])


main()
