"""The class of every cell of the sweep against two rules: tweezer diameter at Ca_tw = Ca against 2 s, which
needs no passage, and centre at the gap line against s, which does. Filled: right, ringed: wrong, grey: the
rule or the simulation gives no class."""

from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import GREY, MARKERS, capillary_axis, of_sweep, panel_note
from study.planning.classes import DECIDED
from study.planning.documents import read_json

RULES = {
    "tweezer": r"tweezer diameter > 2$s$",
    "centre": "centre at the gap line > $s$",
}
COLUMNS = ["row_shift_um", "capillary_number", "class"]
COLUMNS += [f"{kind}_{rule}" for rule in RULES for kind in ("predicted", "right")]
COST = ["hit_rate", "node_updates"]


def power_of_ten(value):
    """A large number for a caption: 3.5e8 as mathematics; plain if it is zero."""
    if not value:
        return "0"
    mantissa, exponent = f"{value:.1e}".split("e")
    return rf"{mantissa}$\times 10^{{{int(exponent)}}}$"


def caption(summary, rule):
    """What the summary says of a rule: hits and the fluid work behind it."""
    found = summary[summary.rule == rule]
    if found.empty or found.hit_rate.isna().iloc[0]:
        return "no cell judged"
    row = found.iloc[0]
    hits = f"{row.right:.0f} of {row.right + row.wrong:.0f} right ({100 * row.hit_rate:.0f} %)"
    return f"{hits}, {row.left_out:.0f} not judged\nwork: {power_of_ten(row.node_updates)} node updates"


def draw_rule(axes, rows, rule):
    """The cells in the colour of their simulated class, by what the rule says of them."""
    right = rows[f"right_{rule}"]
    unknown = rows[right.isna()]
    for name, cells in unknown.groupby("class"):
        axes.plot(
            cells.capillary_number, cells.row_shift_um, MARKERS[name], ms=3, color=GREY, mfc="none", mew=0.5
        )
    for name in DECIDED:
        colour, cells = style.CLASSES[name][0], rows[(rows["class"] == name) & right.notna()]
        axes.plot(cells.capillary_number, cells.row_shift_um, MARKERS[name], ls="", ms=4, color=colour)
    wrong = rows[right == 0]
    axes.plot(wrong.capillary_number, wrong.row_shift_um, "o", ms=8.5, mfc="none", color=style.BLACK, mew=1)
    capillary_axis(axes, rows.capillary_number)
    axes.set_ylabel(r"row shift $d$ / μm")
    if rows.empty:
        panel_note(axes, "no data")


def add_legend(figure, axes):
    """One legend for both panels, below them."""
    for name in DECIDED:
        colour, label = style.CLASSES[name]
        axes.plot([], [], MARKERS[name], color=colour, label=label)
    axes.plot([], [], "o", ms=8.5, mfc="none", color=style.BLACK, label="rule wrong")
    axes.plot([], [], "s", ms=3, mfc="none", mew=0.5, color=GREY, label="not judged (any marker)")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=4)


def main():
    arguments = figure_arguments(__doc__, "table", "summary")
    plan = read_json(arguments.plan)
    rows = of_sweep(read_table(arguments.table), plan)
    summary = of_sweep(read_table(arguments.summary), plan)
    given = COLUMNS + [f"{name}_{rule}" for rule in RULES for name in COST]
    shown = rows.assign(
        **{f"{name}_{rule}": summary[summary.rule == rule][name].max() for rule in RULES for name in COST}
    )
    styles = {"row_shift_um": ".1f", "capillary_number": ".4g"} | {f"right_{rule}": ".0f" for rule in RULES}
    styles |= {f"hit_rate_{rule}": ".4f" for rule in RULES}
    write_table(shown.to_dict("records"), given, arguments.csv, COLUMNS[:2], styles)
    figure = style.new_figure(style.PAGE, 3.6)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, letter, (rule, label) in zip(panels, "ab", RULES.items(), strict=True):
        draw_rule(axes, rows, rule)
        axes.set_title(f"({letter}) displaced if {label}\n{caption(summary, rule)}", loc="left")
    panels[1].set_ylabel("")
    add_legend(figure, panels[0])
    style.save(figure, arguments.output, plan["note"])


main()
