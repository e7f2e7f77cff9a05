"""Tornado of the sensitivity study: the choices (ten; of s three) that change D_perp most at the points
of Fig. 8, the critical capillary number, and s. A cross marks another class than by default, a triangle
the open end of a bracket of the critical capillary number, whose change is at least that large.
Whiskers span the bracket, that of the default settings not included."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import panel_note
from study.drawing.wording import words
from study.planning.documents import read_json

COLUMNS = ["observable", "choice", "value", "words", "row_shift_um", "capillary_number", "result", "low"]
COLUMNS += ["high", "class", "class_changed", "change", "at_least", "relative_change", "unit"]
PANELS = {
    "d_perp": r"change of $D_\perp$ / μm",
    "critical_ca": "change of the critical Ca",
    "s": r"change of $s$ / μm",
}
COLOURS = [style.BLUE, style.ORANGE, style.GREEN, style.PURPLE, style.SKY, style.VERMILION]
LEGEND = {"fontsize": 7, "handlelength": 1, "columnspacing": 0.8, "handletextpad": 0.4, "borderpad": 0}
BAR = 0.8  # share of the height of a row that its bars fill
SHOWN = {"d_perp": 10, "critical_ca": 10, "s": 3}  # choices of a panel


def changes(table):
    """The changes with the choice in words, whether the class is not that of the default settings, and of
    brackets with one end how large the change is at least."""
    default = table[table.choice == "default"].set_index("observable")
    rows = table[table.choice != "default"].copy()
    rows["words"] = [words(*pair) for pair in zip(rows.choice, rows.value, strict=True)]
    before, result = (rows.observable.map(default[name]) for name in ("class", "result"))
    # A critical capillary number has the status of its bracket in the column of the class.
    passages = rows.observable.astype(str).str.startswith("d_perp")
    changed = passages & rows["class"].notna() & before.notna() & (rows["class"] != before)
    rows["class_changed"] = changed.astype(int)
    above = (rows.low - result).where(rows.high.isna() & (rows.low > result))
    below = (rows.high - result).where(rows.low.isna() & (rows.high < result))
    rows["at_least"] = above.fillna(below)
    return rows


def draw_bar(axes, row, place, height, colour):
    """One change; whiskers are the ends of the bracket of a critical capillary number."""
    axes.barh(place, row.bar, height, color=colour, lw=0)
    if np.isfinite([row.low, row.high]).all():
        ends = [[row.result - row.low], [row.high - row.result]]
        axes.errorbar(row.bar, place, xerr=ends, color=style.BLACK, lw=0.7, capsize=1.5)
    if row.class_changed:
        axes.plot(row.bar, place, "x", ms=3.5, mew=0.9, color=style.BLACK)
    if np.isfinite(row.at_least):
        axes.plot(row.bar, place, ">" if row.bar > 0 else "<", ms=3.5, color=style.BLACK)


def draw_legend(axes, rows, observables, kind):
    """What the colours and marks stand for, in one line above a panel."""
    column, prefix = ("capillary_number", "Ca: ") if kind == "d_perp" else ("row_shift_um", "$d$ / μm: ")
    handles = []
    for observable, colour in zip(observables, COLOURS, strict=False):
        label = f"{'' if handles else prefix}{rows[rows.observable == observable][column].iloc[0]:g}"
        handles.append(axes.barh(0, 0, color=colour, label=label))
    marks = {"x": (rows.class_changed == 1, "another class"), ">": (rows.at_least.notna(), "at least")}
    for mark, (drawn, label) in marks.items():
        if drawn.any():
            handles += axes.plot([], [], mark, ms=3.5, color=style.BLACK, ls="", label=label)
    axes.legend(handles=handles, loc="lower right", bbox_to_anchor=(1.02, 1), ncols=len(handles), **LEGEND)


def draw_panel(axes, rows, kind, letter):
    """The tornado of one kind of observable."""
    rows = rows.assign(bar=rows.change.fillna(rows.at_least)).dropna(subset="bar")
    sizes = rows.bar.abs().groupby(rows.words).max().reset_index().sort_values(["bar", "words"])
    names = sizes.words.tolist()[-SHOWN[kind] :]
    title = f"({letter}) the {len(names)} largest of {len(sizes)}"
    axes.set_title(title, loc="right", pad=14)
    axes.set_xlabel(PANELS[kind])
    if rows.empty:
        axes.set(xticks=[], yticks=[])
        panel_note(axes, "no data")
        return
    rows = rows[rows.words.isin(names)].sort_values(["row_shift_um", "capillary_number"])
    observables = list(dict.fromkeys(rows.observable))
    height = BAR / len(observables)
    for row in rows.itertuples():
        k = observables.index(row.observable)
        draw_bar(axes, row, names.index(row.words) + BAR / 2 - (k + 0.5) * height, height, COLOURS[k])
    draw_legend(axes, rows, observables, kind)
    axes.axvline(0, color=style.BLACK, lw=0.6)
    axes.set_yticks(range(len(names)), names, fontsize=7)
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.tick_params(axis="y", length=0)
    axes.locator_params(axis="x", nbins=4)
    axes.margins(x=0.08)


def main():
    arguments = figure_arguments(__doc__, "table")
    plan, rows = read_json(arguments.plan), changes(read_table(arguments.table))
    styles = dict.fromkeys(["result", "low", "high", "change", "at_least", "relative_change"], ".4f")
    styles |= {"row_shift_um": ".1f", "capillary_number": ".4g"}
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:3], styles)
    kinds = rows.observable.astype(str).str.split("(").str[0]
    figure = style.new_figure(style.PAGE, 4.6)
    panels = figure.subplot_mosaic([["d_perp", "critical_ca"], ["d_perp", "s"]], height_ratios=[2.6, 1])
    for (kind, axes), letter in zip(panels.items(), "abc", strict=True):
        draw_panel(axes, rows[kinds == kind], kind, letter)
    style.save(figure, arguments.output, plan["note"])


main()
