"""D_perp, centre at the gap line and film against the lattice spacing for every cell that passed on two
lattices or more with otherwise default settings. Lines go to dx = 0: by the observed order through the three
finest lattices where they have one, else straight through the two finest. Cells are not comparable, and have
no limit, if their class differs between the lattices, or the number of rows from zig to zig: D_perp is then
of another crossing. A film that ends below zero shows that these lattices are too coarse for a limit.
"""

import numpy as np
from study import style
from study.arguments import figure_arguments
from study.extent import MARKERS, panel_note, shade
from study.fits import first_order_limit
from study.passages import DECIDED
from study.plan import read_json
from study.tables import read_table, write_table

OBSERVABLES = {
    "d_perp_um": r"lateral extent $D_\perp$ / μm",
    "centre_um": "centre at the gap line / μm",
    "film_um": "film thickness / μm",
}
POINT = ["row_shift_um", "capillary_number"]
COLUMNS = [
    "observable",
    *POINT,
    "dx_um",
    "class",
    "lane_rows",
    "value",
    "order",
    "change_percent",
    "status",
    "run",
]
SWEEPS = ("boundary/lattice-", "accuracy")


def default_cells(passages, plan):
    """Cells of the sweep over the phase space, its refinement and the brackets, one per point and lattice."""
    sweep = plan["figures"]["trajectory_sweep"]
    names = passages.sweep.astype(str)
    rows = passages[names.isin([sweep, f"{sweep}-fine"]) | names.str.startswith(SWEEPS)]
    home = passages[names == sweep]
    for setting in ("skalak_denominator", "lateral_flow"):
        rows = rows[rows[setting].isin(home[setting].unique())]
    rows = rows[rows["class"].isin(DECIDED)]
    rows = rows.assign(row_shift_um=rows.row_shift_um.round(4), dx_um=rows.dx_um.round(4))
    return rows.drop_duplicates([*POINT, "dx_um"])


def lane_rows(crossings):
    """Rows from the last zig but one to the last, by run: which crossing D_perp of a zigzag cell is of."""
    zigs = crossings[crossings.bump == 0].sort_values(["run", "row"]).drop_duplicates(["run", "row"])
    return zigs.groupby("run").row.diff().groupby(zigs.run).last()


def series_of(cells, observable):
    """One observable of one point from coarse to fine, then its limit at dx = 0; empty for one lattice."""
    known = cells[cells[observable].notna()].sort_values("dx_um", ascending=False)
    if len(known) < 2:
        return []
    place = {"observable": observable} | {name: known[name].iloc[0] for name in POINT}
    names = {"dx_um": "dx_um", "class": "class", "lane_rows": "lane_rows", observable: "value", "run": "run"}
    rows = [place | cell for cell in known[list(names)].rename(columns=names).to_dict("records")]
    lanes = known[known["class"] == "zigzag"].lane_rows
    if known["class"].nunique() > 1:
        status = "class differs"
    elif lanes.nunique(dropna=False) > 1:
        status = "crossing differs"
    else:
        values = known[observable].to_numpy(float)
        end, order = first_order_limit(known.dx_um.to_numpy(float), values)
        status = "limit" if end >= 0 else "negative"
        change = 100 * (end / values[0] - 1) if values[0] else None
        found = {"dx_um": 0.0, "class": rows[0]["class"], "value": end, "order": order or 1.0}
        rows.append(place | found | {"change_percent": change})
    return [row | {"status": status} for row in rows]


def draw_series(axes, rows, colour, label):
    """Points of one cell and the curve through the finest two to dx = 0."""
    measured, end = [row for row in rows if row["dx_um"] > 0], rows[-1]
    axes.plot([], [], color=colour, label=label)
    if end["dx_um"] == 0:
        finest = measured[-1]
        dx = np.linspace(0, measured[-2]["dx_um"], 50)
        rise = (finest["value"] - end["value"]) * (dx / finest["dx_um"]) ** end["order"]
        axes.plot(dx, end["value"] + rise, color=colour, lw=0.8)
        mark = "d" if end["status"] == "limit" else "x"
        axes.plot(0, end["value"], mark, ms=3.5, mfc="white", color=colour, clip_on=False, zorder=4)
    else:
        places = [row["dx_um"] for row in measured]
        axes.plot(places, [row["value"] for row in measured], color=colour, lw=0.8, ls=(0, (1, 1.5)))
    for row in measured:
        face = colour if row["class"] == "displaced" else "white"
        axes.plot(row["dx_um"], row["value"], MARKERS[row["class"]], color=colour, mfc=face, ms=4, zorder=3)


def draw_panel(axes, series, observable):
    """All cells of one observable."""
    shown = [rows for rows in series if rows[0]["observable"] == observable]
    points = sorted({(rows[0]["row_shift_um"], rows[0]["capillary_number"]) for rows in series})
    for rows in shown:
        point = (rows[0]["row_shift_um"], rows[0]["capillary_number"])
        label = rf"$d$ = {point[0]:.1f} μm, Ca = {point[1]:.3g}"
        draw_series(axes, rows, shade(points.index(point), len(points)), label)
    axes.set(xlabel=r"lattice spacing $\Delta x$ / μm", ylabel=OBSERVABLES[observable])
    if shown:
        spacings = sorted({row["dx_um"] for rows in shown for row in rows} | {0.0})
        axes.set_xticks(spacings, [f"{dx:.3g}" for dx in spacings])
        axes.set_xlim(-0.04 * spacings[-1], 1.05 * spacings[-1])
    else:
        panel_note(axes, "no cell on two lattices")
    if any(row["status"] == "negative" for rows in shown for row in rows):
        axes.axhline(0, color=style.BLACK, lw=0.6, ls="--", zorder=0)


def add_legend(figure, axes):
    """The points and what the markers mean, below the panels."""
    for name in DECIDED:
        face = style.BLACK if name == "displaced" else "white"
        axes.plot([], [], MARKERS[name], color=style.BLACK, mfc=face, label=name)
    axes.plot([], [], "d", ms=3.5, mfc="white", color=style.BLACK, label="limit")
    axes.plot([], [], "x", ms=3.5, color=style.BLACK, label="below zero: no limit")
    axes.plot([], [], color=style.BLACK, lw=0.8, ls=(0, (1, 1.5)), label="class or crossing differs")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=7)


def main():
    arguments = figure_arguments(__doc__, "table", "crossings")
    plan = read_json(arguments.plan)
    cells = default_cells(read_table(arguments.table), plan)
    cells = cells.assign(lane_rows=cells.run.map(lane_rows(read_table(arguments.crossings))))
    groups = [one for _, one in cells.groupby(POINT)]
    series = [rows for name in OBSERVABLES for one in groups if (rows := series_of(one, name))]
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g", "dx_um": ".4f", "value": ".4f"}
    styles |= {"order": ".2f", "lane_rows": ".0f", "change_percent": ".2f"}
    lines = [row for rows in series for row in rows]
    write_table(lines, COLUMNS, arguments.csv, COLUMNS[:4], styles)
    figure = style.new_figure(style.PAGE, 3.3)
    panels = figure.subplots(1, 3)
    for axes, letter, name in zip(panels, "abc", OBSERVABLES, strict=True):
        draw_panel(axes, series, name)
        style.panel_label(axes, letter)
    add_legend(figure, panels[0])
    style.save(figure, arguments.output, plan["note"])


main()
