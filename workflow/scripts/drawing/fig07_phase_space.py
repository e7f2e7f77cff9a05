"""Figure 7: the phase space of capillary number and row shift, as far as the paper's diagram goes. Two
lines and a band decide: the paper's boundary Eq. (5), and ours, the law fitted to the brackets with the
95 % band of its bootstrap. Cells stand behind them, with a cross where the paper states another class;
the bars are the ranges of Ca within which its text has the class change. Thin lines: our boundary with
another choice."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import (
    PARAMETERS,
    UNDISPUTED,
    bootstrap_boundary,
    brackets_of,
    law,
    printed_class,
)
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.paper import phase_space
from study.paper.claims import SERIES, load_claims
from study.planning.brackets import FROM_CELLS
from study.planning.classes import DECIDED
from study.planning.documents import read_json

COLUMNS = ["kind", "series", "row_shift_um", "capillary_number", "class", "printed_class", *UNDISPUTED]
COLUMNS += ["status", "contradictions", "d_um", "d_low_um", "d_high_um"]
#: Our boundary with one other choice: the name on its line and the Ca at which it stands.
OTHERS = {"hinge_sphere": ("stiffer folds", 0.6), "corrected": ("corrected kernel", 0.62)}
OTHERS |= {"hinge_sheet": ("softer folds", 0.28)}


def cell_rows(passages, sweep, statements):
    """The cells of a sweep."""
    cells = passages[(passages.sweep == sweep) & (passages.capillary_number <= phase_space.LARGEST)]
    for row in cells[["row_shift_um", "capillary_number", "class"]].to_dict("records"):
        printed = printed_class(statements, row["row_shift_um"], row["capillary_number"])
        yield {"kind": "cell", "series": sweep, "printed_class": printed} | row


def bracket_rows(boundary):
    """Our brackets."""
    for row in boundary[boundary.series == SERIES].to_dict("records"):
        yield {"kind": "bracket"} | {name: row[name] for name in COLUMNS if name in row}


def curve_rows(fits, boundary, series):
    """The fitted law of a series as far as its brackets reach, with its band if it is ours; of another series
    without a fit the (geometric) middles of its brackets."""
    fit = fits[fits.name == f"boundary/{series}"].set_index("parameter")
    shifts, low, high = brackets_of(boundary, series)
    kind, columns = "fit", []
    if set(PARAMETERS) <= set(fit.index):
        curve = phase_space.reached([low, high])
        columns = [curve, law([fit.value[name] for name in PARAMETERS], curve)]
        if series == SERIES:
            samples = bootstrap_boundary(shifts, low, high)[1]
            columns += list(np.percentile(law(samples.T[:, :, None], curve), [2.5, 97.5], axis=0))
    elif series != SERIES:
        closed = ~np.isnan(low + high)
        kind, columns = "middle", [np.sqrt(low * high)[closed], shifts[closed]]
    for values in sorted(zip(*columns, strict=True)):
        numbers = zip(("capillary_number", "d_um", "d_low_um", "d_high_um"), values, strict=False)
        yield {"kind": kind, "series": series} | dict(numbers)


def collect(arguments, sweep):
    """All rows of the figure."""
    passages, boundary, fits = (
        read_table(path) for path in (arguments.passages, arguments.boundary, arguments.fits)
    )
    claim = load_claims(arguments.claims)["phase-boundary"]
    yield from cell_rows(passages, sweep, claim["statements"])
    yield from bracket_rows(boundary)
    for series in (SERIES, *OTHERS):
        yield from curve_rows(fits, boundary, series)
    yield from phase_space.paper_rows(claim)


def draw_cells(axes, cells):
    """Displaced cells filled, zigzag ones open, pale; those without a class are diamonds."""
    look = {"alpha": 0.6, "zorder": 2}
    for name, mark in phase_space.MARKS.items():
        phase_space.draw_cells(axes, cells[cells["class"] == name], name, mark, name, **look)
    rest = cells[~cells["class"].isin(DECIDED)]
    phase_space.draw_cells(axes, rest, "undecided", "D", "no class", **look)
    phase_space.draw_contradictions(axes, cells)


def draw_others(axes, table):
    """Thin lines with their names above them, the softest one's below."""
    for series, (name, place) in OTHERS.items():
        rows = table[table.kind.isin(["fit", "middle"]) & (table.series == series)]
        if len(rows):
            axes.plot(rows.capillary_number, rows.d_um, color="#777777", lw=0.7, zorder=3)
            at = rows.iloc[int(np.argmin(np.abs(rows.capillary_number - place)))]
            below = series == "hinge_sheet"
            look = {
                "ha": "right" if below else "left",
                "va": "top" if below else "bottom",
                "color": "#555555",
            }
            axes.text(at.capillary_number, at.d_um, name, fontsize=7, **look)


def draw_lines(axes, table):
    """The two boundaries: the paper's with the ranges of its text, ours with band and two-sided brackets."""
    paper = table[table.kind == "paper"]
    phase_space.draw_paper(axes, paper, paper[paper.series == "text"], below_um=0.13, layer=5)
    ours = {"color": style.GREEN, "zorder": 4}
    line = table[(table.kind == "fit") & (table.series == SERIES)]
    found = "band of 95 % and brackets"
    if (table.status == FROM_CELLS).any():
        found = f"{FROM_CELLS}, no brackets"
    axes.plot(line.capillary_number, line.d_um, lw=2.2, label=f"this study, {found}", **ours)
    ends = (line[name].astype(float) for name in ("d_low_um", "d_high_um"))
    axes.fill_between(line.capillary_number, *ends, color=style.GREEN, alpha=0.25, lw=0)
    for row in table[(table.kind == "bracket") & table[UNDISPUTED].notna().all(axis=1)].to_dict("records"):
        look = {"lw": 2.2, "solid_capstyle": "butt", "ms": 6, "mew": 1.2} | ours
        axes.plot([row[name] for name in UNDISPUTED], [row["row_shift_um"]] * 2, "|-", **look)


def main():
    arguments = figure_arguments(__doc__, "passages", "boundary", "fits", "claims")
    plan = read_json(arguments.plan)
    rows = list(collect(arguments, plan["figures"]["trajectory_sweep"]))
    styles = dict.fromkeys(["row_shift_um", "d_um", "d_low_um", "d_high_um"], ".3f")
    styles |= dict.fromkeys(["capillary_number", *UNDISPUTED], ".4g")
    write_table(rows, COLUMNS, arguments.csv, styles=styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 4.2)
    axes = figure.add_subplot()
    draw_cells(axes, table[table.kind == "cell"])
    draw_others(axes, table)
    draw_lines(axes, table)
    phase_space.draw_frame(axes)
    style.legend_below(figure, 3)
    style.save(figure, arguments.output, plan["note"])


main()
