"""Figure 7: the phase space of capillary number and row shift. Cells of the sweep, brackets of the boundary
with the fitted exponentials and the paper's Eq. (5); beside it the boundary with blocked lateral flow."""

from typing import NamedTuple

import numpy as np
from study import style
from study.arguments import figure_arguments
from study.boundary import PARAMETERS, UNDISPUTED, bootstrap_boundary, brackets_of, law
from study.claims import load_claims
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = [
    "panel",
    "kind",
    "series",
    "row_shift_um",
    "capillary_number",
    "class",
    *UNDISPUTED,
]
COLUMNS += ["status", "contradictions", "d_um", "d_low_um", "d_high_um"]
CURVE = np.geomspace(0.08, 2.5, 60)  # capillary numbers of the curves
REACH = 1.2  # a fitted curve ends at its outermost brackets times this
MARKERS = {"displaced": "o", "zigzag": "s", "undecided": "D", "diverged": "x", "interrupted": "x"}


class Look(NamedTuple):
    """How a series of brackets is drawn, what the legend calls it, and in which panels it stands."""

    colour: str
    marker: str
    label: str
    panels: tuple = ("free",)


BOTH = ("free", "blocked")
#: The series that are drawn, in this order.
LOOKS = {
    "lattice-0.8": Look(style.PURPLE, "v", "dx = 0.8 μm"),
    "lattice-0.4": Look(style.GREEN, "^", "dx = 0.4 μm", BOTH),
    "lattice-0.2": Look(style.ORANGE, "v", "dx = 0.2 μm"),
    "lattice-0.133": Look(style.PURPLE, "<", "dx = 0.133 μm"),
    "corrected-0.4": Look(style.BLUE, "o", "dx = 0.4 μm, corrected", BOTH),
    "corrected-0.2": Look(style.VERMILION, "o", "dx = 0.2 μm, corrected"),
    "extrapolated": Look(style.BLACK, "D", "extrapolated, dx → 0"),
    "extrapolated-3": Look("#777777", "D", "extrapolated, dx → 0 (3 lattices)"),
    "blocked-lateral": Look(style.PURPLE, "s", "no net lateral flow", ("blocked",)),
    "blocked-corrected": Look(style.VERMILION, "s", "the same, corrected", ("blocked",)),
    "blocked-corrected-0.2": Look(style.ORANGE, "D", "the same, corrected, dx = 0.2 μm", ("blocked",)),
}


def cell_rows(passages, panel, sweep):
    """The cells of a sweep, coloured points of a panel."""
    for row in passages[passages.sweep == sweep].to_dict("records"):
        yield {"panel": panel, "kind": "cell", "series": sweep} | {
            name: row[name] for name in ("row_shift_um", "capillary_number", "class")
        }


def bracket_rows(boundary, panel, series):
    """The brackets of a series."""
    for row in boundary[boundary.series == series].to_dict("records"):
        yield {"panel": panel, "kind": "bracket"} | {name: row[name] for name in COLUMNS if name in row}


def curve_rows(fits, boundary, panel, series):
    """The fitted law of a series with the 95 % band of its bootstrap, as far as its brackets reach."""
    fit = fits[fits.name == f"boundary/{series}"].set_index("parameter")
    if not set(PARAMETERS) <= set(fit.index):
        return
    brackets = brackets_of(boundary, series)
    curve = CURVE[(np.nanmin(brackets[1:]) / REACH < CURVE) & (np.nanmax(brackets[1:]) * REACH > CURVE)]
    middle = law([fit.value[name] for name in PARAMETERS], curve)
    samples = bootstrap_boundary(*brackets)[1]
    low, high = np.percentile(law(samples.T[:, :, None], curve), [2.5, 97.5], axis=0)
    for values in zip(curve, middle, low, high, strict=True):
        numbers = dict(zip(("capillary_number", "d_um", "d_low_um", "d_high_um"), values, strict=True))
        yield {"panel": panel, "kind": "fit", "series": series} | numbers


def paper_rows(claim, panel):
    """The paper's Eq. (5)."""
    for capillary in CURVE:
        d = float(law([claim["value"][name] for name in PARAMETERS], capillary))
        yield {"panel": panel, "kind": "paper", "series": "Eq. (5)", "capillary_number": capillary, "d_um": d}


def collect(arguments, sweep):
    """All rows of the figure."""
    passages, boundary, fits = (
        read_table(path) for path in (arguments.passages, arguments.boundary, arguments.fits)
    )
    claim = load_claims(arguments.claims)["phase-boundary"]
    rows = []
    for panel in BOTH:
        rows += cell_rows(passages, panel, sweep if panel == "free" else "blocked-lateral")
        for series in (name for name, look in LOOKS.items() if panel in look.panels):
            rows += bracket_rows(boundary, panel, series)
            rows += curve_rows(fits, boundary, panel, series)
        rows += paper_rows(claim, panel)
    return rows


def draw_brackets(axes, rows, colour, marker, shift, label):
    """Brackets as bars with a symbol in their (geometric) middle, hollow if they are wider than asked for."""
    for row in rows.to_dict("records"):
        low, high = (row[name] for name in UNDISPUTED)
        if low != low or high != high:
            continue  # the boundary is not within the range of Ca at this row shift
        y, middle = row["row_shift_um"] + shift, np.sqrt(low * high)
        narrow = row["status"] == "bracketed" and row["contradictions"] == 0
        face = colour if narrow else "white"
        axes.plot([low, high], [y, y], color=colour, lw=1.2, zorder=4)
        axes.plot(middle, y, marker, color=colour, mfc=face, ms=4, zorder=5)
    axes.plot([], [], color=colour, marker=marker, ms=4, label=label)


def draw(axes, table):
    """One panel."""
    cells = table[table.kind == "cell"]
    for label, group in cells.groupby("class"):
        colour, _ = style.CLASSES[label]
        edge = {"mec": colour, "mew": 1.0} if MARKERS[label] == "x" else {"mec": "white", "mew": 0.3}
        style_of = {"color": colour, "ms": 4.5, "alpha": 0.55, "zorder": 2, "label": label} | edge
        axes.plot(group.capillary_number, group.row_shift_um, MARKERS[label], **style_of)
    drawn = [name for name in LOOKS if ((table.series == name) & table.kind.isin(["bracket", "fit"])).any()]
    for number, series in enumerate(drawn):
        colour, marker, label, _ = LOOKS[series]
        rows = table[table.series == series]
        shift = 0.03 * (number - 0.5 * (len(drawn) - 1))  # side by side at the same row shift
        draw_brackets(axes, rows[rows.kind == "bracket"], colour, marker, shift, label)
        curve = rows[rows.kind == "fit"]
        axes.plot(curve.capillary_number, curve.d_um, color=colour, zorder=3)
        axes.fill_between(
            curve.capillary_number.astype(float),
            curve.d_low_um.astype(float),
            curve.d_high_um.astype(float),
            color=colour,
            alpha=0.15,
            lw=0,
            zorder=1,
        )
    paper = table[table.kind == "paper"]
    axes.plot(
        paper.capillary_number, paper.d_um, color=style.BLACK, ls=(0, (5, 2)), lw=1, label="paper, Eq. (5)"
    )
    axes.set_xscale("log")
    ticks = [0.1, 0.2, 0.5, 1, 2]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set(xlim=(0.085, 2.8), ylim=(1.5, 9.3), xlabel="Ca", ylabel="$d$ / μm")


def main():
    arguments = figure_arguments(__doc__, "passages", "boundary", "fits", "claims")
    plan = read_json(arguments.plan)
    rows = collect(arguments, plan["figures"]["trajectory_sweep"])
    styles = dict.fromkeys(["row_shift_um", "d_um", "d_low_um", "d_high_um"], ".3f")
    styles |= dict.fromkeys(["capillary_number", *UNDISPUTED], ".4g")
    write_table(rows, COLUMNS, arguments.csv, styles=styles)
    table = read_table(arguments.csv)
    figure = style.new_figure(style.PAGE, 4.0)
    panels = figure.subplots(1, 2, sharey=True)
    for letter, axes, name in zip("ab", panels, BOTH, strict=True):
        draw(axes, table[table.panel == name])
        axes.set_title(
            f"({letter}) lateral flow {name if name == 'free' else 'free and blocked'}", loc="left"
        )
        axes.legend(
            loc="upper center", bbox_to_anchor=(0.5, -0.17), ncols=2, handlelength=1.8, columnspacing=1.0
        )
    panels[1].set_ylabel("")
    style.save(figure, arguments.output, plan["note"])


main()
