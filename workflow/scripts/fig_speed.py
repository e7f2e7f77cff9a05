"""Slowing near the boundary: (a) mean speed of the cells against Ca; (b) time of the slowest
row of the passage against the distance from the critical capillary number Ca_c, the middle of the bracket.
The cell lingers at a stagnation point of the gap, so that this time grows as -ln |Ca / Ca_c - 1|."""

import numpy as np
from study import style
from study.arguments import figure_arguments
from study.extent import (
    GREY,
    MARKERS,
    capillary_axis,
    draw_classes,
    panel_note,
    shade,
)
from study.passages import DECIDED
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = [
    "sweep",
    "row_shift_um",
    "capillary_number",
    "class",
    "speed_um_per_kilostep",
    "slowest_row_kilosteps",
]
COLUMNS += ["critical_capillary_number", "half_width", "distance", "run"]
SERIES = "default"  # of the brackets with the settings of the sweep
LEGEND = {"fontsize": 6.5, "handlelength": 1.2, "columnspacing": 0.8, "handletextpad": 0.4}


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


def draw_lines(axes, rows):
    """Panel (a): a line for every row shift with its number at the right end; close numbers move apart."""
    speeds = rows.dropna(subset=["speed_um_per_kilostep"]).sort_values("capillary_number")
    ends = speeds.groupby("row_shift_um").tail(1).sort_values("speed_um_per_kilostep")
    gap, height = 0.035 * np.ptp(speeds.speed_um_per_kilostep.to_numpy()) if len(speeds) else 0, -np.inf
    for end in ends.itertuples():
        line = speeds[speeds.row_shift_um == end.row_shift_um]
        axes.plot(line.capillary_number, line.speed_um_per_kilostep, color=GREY, lw=0.5, zorder=1)
        height = max(end.speed_um_per_kilostep, height + gap)
        place = {"textcoords": "offset points", "fontsize": 6, "color": GREY}
        axes.annotate(f"{end.row_shift_um:.1f}", (end.capillary_number, height), (5, -2), **place)
    if len(ends):
        axes.annotate("$d$ / μm", (end.capillary_number, height + 2 * gap), (0, -2), **place)


def draw_slowing(axes, rows):
    """Panel (b): a straight line is logarithmic slowing."""
    shown = rows[rows.distance.notna() & rows.slowest_row_kilosteps.notna()]
    shown = shown[(shown.distance != 0) & shown["class"].isin(DECIDED)]
    shifts = sorted(shown.row_shift_um.unique())
    for k, shift in enumerate(shifts):
        colour = shade(k, len(shifts))
        width = 100 * shown[shown.row_shift_um == shift].half_width.iloc[0]
        axes.plot([], [], color=colour, label=rf"$d$ = {shift:.1f} μm, $\mathrm{{Ca}}_c$ ± {width:.0f} %")
        for (_, name), side in shown[shown.row_shift_um == shift].groupby([shown.distance > 0, "class"]):
            side = side.assign(distance=side.distance.abs()).sort_values("distance")
            look = {"ms": 3.5, "lw": 0.6, "mfc": colour if name == "displaced" else "white", "color": colour}
            axes.plot(side.distance, side.slowest_row_kilosteps, marker=MARKERS[name], **look)
    axes.set(xlabel=r"$|\mathrm{Ca}/\mathrm{Ca}_c - 1|$", ylabel="slowest row / 1000 steps")
    for name in sorted(shown["class"].unique()):
        look = {"ms": 3.5, "mfc": GREY if name == "displaced" else "white", "color": GREY}
        axes.plot([], [], MARKERS[name], ls="", label=name, **look)
    if len(shown):
        axes.set_xscale("log")
        axes.legend(loc="lower left", bbox_to_anchor=(0.07, 1.0), ncols=2, **LEGEND)
    else:
        axes.set(xticks=[], yticks=[])
        panel_note(axes, "no two-sided bracket of the boundary")


def main():
    arguments = figure_arguments(__doc__, "table", "crossings", "boundary")
    plan = read_json(arguments.plan)
    tables = (read_table(path) for path in (arguments.table, arguments.crossings, arguments.boundary))
    rows = cells(*tables, plan)
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g"} | dict.fromkeys(COLUMNS[4:9], ".4f")
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:3], styles)
    figure = style.new_figure(style.PAGE, 3.3)
    left, right = figure.subplots(1, 2)
    draw_lines(left, rows)
    draw_classes(left, rows, "capillary_number", "speed_um_per_kilostep")
    capillary_axis(left, rows.capillary_number)
    left.set(ylabel="mean speed / (μm / 1000 steps)")
    if len(rows):
        left.legend(loc="lower left", bbox_to_anchor=(0.07, 1.0), ncols=5, **LEGEND)
    else:
        panel_note(left, "no data")
    draw_slowing(right, rows)
    style.panel_label(left, "a")
    style.panel_label(right, "b")
    style.save(figure, arguments.output, plan["note"])


main()
