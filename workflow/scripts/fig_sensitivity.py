"""Tornado of the sensitivity study: what every choice changes of D_perp at the points of Fig. 8, of the
critical capillary number and of s; the largest change on top. A cross marks another class than by default;
whiskers span the bracket of a critical capillary number, that of the default settings not included.
"""

import numpy as np
from study import style
from study.arguments import figure_arguments
from study.extent import panel_note
from study.plan import read_json
from study.tables import read_table, write_table

COLUMNS = ["observable", "choice", "value", "row_shift_um", "capillary_number", "result", "low", "high"]
COLUMNS += ["class", "class_changed", "change", "relative_change", "unit"]
PANELS = {
    "d_perp": r"change of $D_\perp$ / μm",
    "critical_ca": r"change of critical Ca",
    "s": r"change of $s$ / μm",
}
COLOURS = [style.BLUE, style.ORANGE, style.GREEN, style.PURPLE, style.SKY, style.VERMILION]
LEGEND = {"fontsize": 6.5, "handlelength": 1, "columnspacing": 0.8, "handletextpad": 0.4, "borderpad": 0}
BAR = 0.8  # share of the height of a row that its bars fill


def with_names(table):
    """The changes with the name of the row, and whether the class is not that of the default settings."""
    default = table[table.choice == "default"].set_index("observable")["class"]
    rows = table[table.choice != "default"].copy()
    rows["name"] = (
        rows.choice.str.replace("_um", " / μm").str.replace("_", " ") + ": " + rows.value.astype(str)
    )
    before = rows.observable.map(default)
    # A critical capillary number has the status of its bracket in this column, which is no class.
    passages = rows.observable.astype(str).str.startswith("d_perp")
    changed = passages & rows["class"].notna() & before.notna() & (rows["class"] != before)
    rows["class_changed"] = changed.astype(int)
    return rows


def label_of(row, kind):
    """What a bar belongs to within its row of the tornado."""
    return f"Ca = {row.capillary_number:g}" if kind == "d_perp" else rf"$d$ = {row.row_shift_um:g} μm"


def draw_bar(axes, row, place, height, colour):
    """One change; whiskers are the ends of the bracket of a critical capillary number."""
    axes.barh(place, row.change, height, color=colour, lw=0)
    if np.isfinite([row.low, row.high]).all():
        ends = [[row.result - row.low], [row.high - row.result]]
        axes.errorbar(row.change, place, xerr=ends, color=style.BLACK, lw=0.7, capsize=1.5)
    if row.class_changed:
        axes.plot(row.change, place, "x", ms=3.5, mew=0.9, color=style.BLACK)


def draw_panel(axes, rows, kind):
    """The tornado of one kind of observable."""
    shown, missing = rows[rows.change.notna()], int(rows.change.isna().sum())
    shifts = ", ".join(f"{shift:g}" for shift in sorted(set(rows.row_shift_um)))
    remark = f"; without value: {missing}" if missing else ""
    axes.set_xlabel(f"{PANELS[kind]}\n($d$ = {shifts} μm{remark})")
    if shown.empty:
        axes.set(xticks=[], yticks=[])
        panel_note(axes, "no data")
        return
    sizes = shown.change.abs().groupby(shown.name).max()
    names = sizes.reset_index().sort_values(["change", "name"]).name.tolist()
    observables = list(
        shown.drop_duplicates("observable").sort_values(["row_shift_um", "capillary_number"]).observable
    )
    height = BAR / len(observables)
    for k, observable in enumerate(observables):
        members, colour = shown[shown.observable == observable], COLOURS[k % len(COLOURS)]
        for row in members.itertuples():
            place = names.index(row.name) + BAR / 2 - (k + 0.5) * height
            draw_bar(axes, row, place, height, colour)
        axes.barh(0, 0, color=colour, label=label_of(members.iloc[0], kind))
    if shown.class_changed.any():
        axes.plot([], [], "x", ms=3.5, color=style.BLACK, ls="", label="another class")
    axes.axvline(0, color=style.BLACK, lw=0.6)
    axes.set_yticks(range(len(names)), names, fontsize=7)
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.tick_params(axis="y", length=0)
    axes.locator_params(axis="x", nbins=7 if kind == "d_perp" else 4)
    axes.margins(x=0.08)
    axes.legend(loc="lower right", bbox_to_anchor=(1.02, 1), ncols=3 if len(observables) < 4 else 2, **LEGEND)


def main():
    arguments = figure_arguments(__doc__, "table")
    plan, rows = read_json(arguments.plan), with_names(read_table(arguments.table))
    styles = dict.fromkeys(["result", "low", "high", "change", "relative_change"], ".4f")
    styles |= {"row_shift_um": ".1f", "capillary_number": ".4g"}
    write_table(rows.to_dict("records"), COLUMNS, arguments.csv, COLUMNS[:3], styles)
    kinds = rows.observable.astype(str).str.split("(").str[0]
    most = max([rows[kinds == "d_perp"].name.nunique(), 6])
    figure = style.new_figure(style.PAGE, 1.6 + 0.24 * most)
    panels = figure.subplot_mosaic([["d_perp", "critical_ca"], ["d_perp", "s"]], width_ratios=[1.3, 1])
    for (kind, axes), letter in zip(panels.items(), "abc", strict=True):
        draw_panel(axes, rows[kinds == kind], kind)
        style.panel_label(axes, letter)
    style.save(figure, arguments.output, plan["note"])


main()
