"""Figure 7: the phase space of capillary number and row shift, as far as the paper's diagram goes. Cells, the
paper's boundary Eq. (5) and ours: brackets and the law fitted to them with the 95 % band of its bootstrap,
(a) with the plain kernel, where thin lines are the boundary by the other calibrations of bending, and (b)
with the corrected one."""

import numpy as np
from study import style
from study.arguments import figure_arguments
from study.boundary import PARAMETERS, UNDISPUTED, bootstrap_boundary, brackets_of, law
from study.brackets import FROM_CELLS
from study.claims import load_claims
from study.passages import DECIDED
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = ["panel", "kind", "series", "row_shift_um", "capillary_number", "class", *UNDISPUTED]
COLUMNS += ["status", "contradictions", "d_um", "d_low_um", "d_high_um"]
LARGEST = 1.6  # capillary number at the right edge
CURVE = np.linspace(0, LARGEST, 81)  # capillary numbers of the curves
REACH = 1.2  # a fitted curve ends at its outermost brackets times this
OURS = {"default": "plain kernel", "corrected": "corrected kernel"}  # series of a panel: its title
#: The other calibrations of bending in panel (a): colour, line style, name.
OTHERS = {
    "hinge_sphere": (style.ORANGE, "-.", r"hinge_sphere, $c=\sqrt{3}$"),
    "hinge_sheet": (style.SKY, "-", r"hinge_sheet, $c=1/\sqrt{3}$"),
}


def cell_rows(passages, panel, sweep):
    """The cells of a sweep."""
    cells = passages[(passages.sweep == sweep) & (passages.capillary_number <= LARGEST)]
    names = ("row_shift_um", "capillary_number", "class")
    for row in cells.to_dict("records"):
        yield {"panel": panel, "kind": "cell", "series": sweep} | {name: row[name] for name in names}


def bracket_rows(boundary, panel, series):
    """The brackets of a series."""
    for row in boundary[boundary.series == series].to_dict("records"):
        yield {"panel": panel, "kind": "bracket"} | {name: row[name] for name in COLUMNS if name in row}


def curve_rows(fits, boundary, panel, series):
    """The fitted law of a series as far as its brackets reach, with its band if the panel is its own; of
    another series without a fit the (geometric) middles of its brackets."""
    fit = fits[fits.name == f"boundary/{series}"].set_index("parameter")
    shifts, low, high = brackets_of(boundary, series)
    kind, columns = "fit", []
    if set(PARAMETERS) <= set(fit.index):
        curve = CURVE[(np.nanmin([low, high]) / REACH < CURVE) & (np.nanmax([low, high]) * REACH > CURVE)]
        columns = [curve, law([fit.value[name] for name in PARAMETERS], curve)]
        if series == panel:
            samples = bootstrap_boundary(shifts, low, high)[1]
            columns += list(np.percentile(law(samples.T[:, :, None], curve), [2.5, 97.5], axis=0))
    elif series != panel:
        closed = ~np.isnan(low + high)
        kind, columns = "middle", [np.sqrt(low * high)[closed], shifts[closed]]
    for values in sorted(zip(*columns, strict=True)):
        numbers = zip(("capillary_number", "d_um", "d_low_um", "d_high_um"), values, strict=False)
        yield {"panel": panel, "kind": kind, "series": series} | dict(numbers)


def paper_rows(claim, panel):
    """The paper's Eq. (5)."""
    for capillary, d in zip(CURVE, law([claim["value"][name] for name in PARAMETERS], CURVE), strict=True):
        yield {"panel": panel, "kind": "paper", "series": "Eq. (5)", "capillary_number": capillary, "d_um": d}


def collect(arguments, sweep):
    """All rows of the figure; a panel has the name of its series."""
    passages, boundary, fits = (
        read_table(path) for path in (arguments.passages, arguments.boundary, arguments.fits)
    )
    claim = load_claims(arguments.claims)["phase-boundary"]
    for panel, cells in (("default", sweep), ("corrected", "corrected")):
        yield from cell_rows(passages, panel, cells)
        yield from bracket_rows(boundary, panel, panel)
        yield from curve_rows(fits, boundary, panel, panel)
        yield from paper_rows(claim, panel)
    for series in OTHERS:
        yield from curve_rows(fits, boundary, "default", series)


def draw_cells(axes, cells):
    """Displaced cells filled, zigzag ones open; those without a class are diamonds."""
    decided = cells["class"].isin(DECIDED)
    failed = set(cells["class"][~decided]) - {"undecided"}
    kinds = {"displaced": (cells["class"] == "displaced", "o"), "zigzag": (cells["class"] == "zigzag", "s")}
    kinds["undecided"] = (~decided, "D")
    for name, (chosen, mark) in kinds.items():
        colour, rows = style.CLASSES[name][0], cells[chosen]
        look = {"ms": 3.4, "mew": 0.7, "color": colour, "mfc": colour if name == "displaced" else "none"}
        label = "undecided or failed" if failed and name == "undecided" else name
        if len(rows):
            axes.plot(rows.capillary_number, rows.row_shift_um, mark, ls="", label=label, zorder=2, **look)


def draw_ours(axes, table, panel):
    """The law of the panel's own series with its band, and its two-sided brackets."""
    ours = {"color": style.GREEN, "zorder": 4}
    law_of = table[(table.kind == "fit") & (table.series == panel)]
    label = r"ours: hinge_half, $c=\sqrt{3}/2$"
    if (table.status == FROM_CELLS).any():
        label += f",\n{FROM_CELLS}, no brackets"
    axes.plot(law_of.capillary_number, law_of.d_um, lw=1.6, label=label, **ours)
    ends = (law_of[name].astype(float) for name in ("d_low_um", "d_high_um"))
    axes.fill_between(law_of.capillary_number, *ends, color=style.GREEN, alpha=0.25, lw=0)
    closed = table[(table.kind == "bracket") & table[UNDISPUTED].notna().all(axis=1)]
    for row in closed.to_dict("records"):
        look = {"lw": 2.2, "solid_capstyle": "butt", "ms": 6, "mew": 1.2} | ours
        axes.plot([row[name] for name in UNDISPUTED], [row["row_shift_um"]] * 2, "|-", **look)


def draw(axes, table, panel):
    """One panel."""
    draw_cells(axes, table[table.kind == "cell"])
    paper = table[table.kind == "paper"]
    dashes = {"color": style.BLACK, "ls": (0, (5, 2)), "zorder": 5}
    axes.plot(paper.capillary_number, paper.d_um, label="paper, Eq. (5)", **dashes)
    if (table.kind == "cell").any() or (table.kind == "bracket").any():
        draw_ours(axes, table, panel)
    else:
        style.say_no_runs(axes)
    for series, (colour, line, label) in OTHERS.items():
        rows = table[table.kind.isin(["fit", "middle"]) & (table.series == series)]
        if len(rows):
            axes.plot(rows.capillary_number, rows.d_um, color=colour, ls=line, lw=0.9, zorder=3, label=label)
    axes.set(xlim=(0, LARGEST), ylim=(1.6, 9.2), xlabel="capillary number Ca")
    axes.set_xticks(np.arange(0, LARGEST + 0.1, 0.4))


def main():
    arguments = figure_arguments(__doc__, "passages", "boundary", "fits", "claims")
    plan = read_json(arguments.plan)
    rows = list(collect(arguments, plan["figures"]["trajectory_sweep"]))
    styles = dict.fromkeys(["row_shift_um", "d_um", "d_low_um", "d_high_um"], ".3f")
    styles |= dict.fromkeys(["capillary_number", *UNDISPUTED], ".4g")
    write_table(rows, COLUMNS, arguments.csv, styles=styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 3.7)
    panels = figure.subplots(1, 2, sharey=True, width_ratios=[1.5, 1])
    for letter, axes, (panel, title) in zip("ab", panels, OURS.items(), strict=True):
        draw(axes, table[table.panel == panel], panel)
        axes.set_title(f"({letter}) {title}", loc="left")
    panels[0].set_ylabel("row shift $d$ / μm")
    style.legend_below(figure, 4)
    style.save(figure, arguments.output, plan["note"])


main()
