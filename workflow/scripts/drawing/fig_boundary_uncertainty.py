"""How sure the boundary is: the bracket of the critical capillary number with one thing changed (blue), over
that of the series that the change is made to (grey), one panel a row shift with several changes; the dashed
line is the paper's Eq. (5). Arrows are open ends: the boundary lies beyond."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.boundary import PARAMETERS, UNDISPUTED, critical_capillary_number
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.drawing.extent import panel_note
from study.paper.claims import load_claims
from study.planning.documents import read_json

REFERENCE = ["reference_displaced", "reference_zigzag"]
COLUMNS = ["row_shift_um", "cause", "setting", "reference", *UNDISPUTED, *REFERENCE]
COLUMNS += ["printed_ca", "change_percent"]
STYLES = {"row_shift_um": ".1f", "change_percent": ".1f", "printed_ca": ".3f"}
STYLES |= dict.fromkeys([*UNDISPUTED, *REFERENCE], ".4g")
TICKS = np.array([0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0, 1.5, 2.0])
ARROW = {"arrowstyle": "->,head_width=0.25", "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
FEWEST = 0.25  # of the changes of the row shift that has most: with fewer there is no panel
MARGIN = 1.25  # a panel reaches this factor beyond the outermost end; so does an arrow from its end


def draw_bracket(axes, ends, place, colour, width, layer):
    """A bracket as a bar; an arrow where it has an open end."""
    low, high = ends
    if np.isfinite(ends).all():
        look = {"color": colour, "zorder": layer, "lw": width, "ms": width, "mew": 1.2}
        axes.plot(ends, [place, place], "|-", solid_capstyle="butt", **look)  # marks, for thin ones
        return
    for end, beyond in ((low, low * MARGIN), (high, high / MARGIN)):
        if np.isfinite(end):
            arrow = ARROW | {"color": colour}
            axes.annotate("", (beyond, place), (end, place), arrowprops=arrow, zorder=layer)


def draw_panel(axes, rows, labels):
    """All brackets of one row shift."""
    for row in rows.to_dict("records"):
        place = labels.index((row["cause"], row["setting"]))
        draw_bracket(axes, [row[name] for name in REFERENCE], place, style.PILLAR, 7, 2)
        draw_bracket(axes, [row[name] for name in UNDISPUTED], place, style.BLUE, 2.5, 3)
    printed = rows.printed_ca.iloc[0]
    if np.isfinite(printed):
        axes.axvline(printed, color=style.VERMILION, ls="--", lw=1, zorder=0)
    known = rows[[*UNDISPUTED, *REFERENCE, "printed_ca"]].to_numpy(float)
    reach = np.nanmin(known) / MARGIN, np.nanmax(known) * MARGIN
    inside = TICKS[(reach[0] < TICKS) & (reach[1] > TICKS)]
    ticks = inside[len(inside) // 4 :: 1 + len(inside) // 4]  # three or four
    axes.set_xscale("log")
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.set_xlim(reach)
    axes.grid(axis="y", lw=0.3, color=style.PILLAR)
    axes.tick_params(axis="y", length=0)
    axes.set(title=rf"$d$ = {rows.row_shift_um.iloc[0]:g} μm", xlabel="critical Ca")


def draw(table, labels):
    """The figure: a panel for every row shift, the largest first; a line for every change (cause, setting),
    the first on top."""
    labels = [label for label in labels if label in set(zip(table.cause, table.setting, strict=True))][::-1]
    shifts = sorted(
        (shift for shift, rows in table.groupby("row_shift_um") if len(rows) >= FEWEST), reverse=True
    )
    figure = style.new_figure(style.PAGE, 1.2 + 0.18 * max(len(labels), 4))
    panels = figure.subplots(1, max(len(shifts), 1), sharey=True, squeeze=False)[0]
    for axes, shift in zip(panels, shifts, strict=bool(shifts)):
        draw_panel(axes, table[table.row_shift_um == shift], labels)
    if table.empty:
        panel_note(panels[0], "no data")
        return figure
    names = [f"{cause}: {setting}".replace(" um", " μm") for cause, setting in labels]
    panels[0].set_yticks(range(len(labels)), names, fontsize=7)
    panels[0].set_ylim(-0.7, len(labels) - 0.3)
    panels[0].plot([], [], color=style.BLUE, lw=2.5, label="one thing changed")
    panels[0].plot([], [], color=style.PILLAR, lw=7, label="without the change")
    panels[0].plot([], [], color=style.VERMILION, ls="--", lw=1, label="paper, Eq. (5)")
    style.legend_below(figure, 3)
    return figure


def main():
    arguments = figure_arguments(__doc__, "table", "claims")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    claim = load_claims(arguments.claims)["phase-boundary"]["value"]
    law = [claim[name] for name in PARAMETERS]
    printed = [critical_capillary_number(shift, law) for shift in table.row_shift_um]
    table = table.assign(printed_ca=np.array(printed, float), setting=table.setting.astype(str))
    write_table(table.to_dict("records"), COLUMNS, arguments.csv, styles=STYLES)
    labels = [(row["cause"], row["setting"]) for row in plan["uncertainty"]]
    style.save(draw(table, labels), arguments.output, plan["note"])


main()
