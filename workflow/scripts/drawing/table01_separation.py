"""Table 1 as a picture: separation distance against the row shift, printed and computed, with power
laws."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.numerics.fits import power_law
from study.paper.claims import load_claims
from study.planning.documents import read_json

PITCH = 32.0  # um
ROUNDING = 0.05  # um, of the printed values
MARKERS = ["s", "^", "D", "v"]
COLOURS = [style.BLUE, style.GREEN, style.VERMILION, style.ORANGE]


def joined(table, printed, variants):
    """One row for each row shift: printed value and those of the variants."""
    rows = []
    for shift in sorted(set(printed) | set(table.row_shift_um.round(3))):
        row = {"row_shift_um": shift, "epsilon": shift / PITCH, "printed_s_um": printed.get(shift)}
        for variant in variants:
            found = table[(table.variant == variant) & (table.row_shift_um.sub(shift).abs() < 1e-6)]
            row[f"{variant}_s_um"] = found.s_um.iloc[0] if len(found) else None
            if variant == "refined":
                row["refined_uncertainty_um"] = found.s_uncertainty_um.iloc[0] if len(found) else None
        rows.append(row)
    return rows


def draw(axes, table, fits, printed, variants, equation):
    """Points and power laws on logarithmic axes."""
    curve = np.geomspace(1.8, 9.5, 60)
    shifts = sorted(printed)
    values = [printed[shift] for shift in shifts]
    axes.errorbar(
        shifts,
        values,
        ROUNDING,
        fmt="o",
        color=style.BLACK,
        ms=4,
        capsize=2,
        lw=0.8,
        label="Table 1, printed",
    )
    label = rf"Eq. (4): $2s$ = {equation['A_um']:g} μm $\epsilon^{{{equation['B']:g}}}$"
    look = {"color": style.BLACK, "lw": 1.0, "ls": (0, (5, 2)), "label": label}
    axes.plot(curve, 0.5 * power_law(curve / PITCH, equation["A_um"], equation["B"]), **look)
    law = fits.set_index(["name", "parameter"]).value
    for number, variant in enumerate(variants):
        rows = table[(table.variant == variant) & (table.status == "converged")]
        label, colour = variant, COLOURS[number % 4]
        name = f"separation-law/{variant}"
        if (name, "B") in law.index:
            a, b = law[(name, "A_um")], law[(name, "B")]
            axes.plot(curve, 0.5 * power_law(curve / PITCH, a, b), color=colour, lw=0.8)
            label += rf": $2s$ = {a:.1f} μm $\epsilon^{{{b:.3f}}}$"
        axes.plot(rows.row_shift_um, rows.s_um, MARKERS[number % 4], color=colour, mfc="none", label=label)
    axes.set(xscale="log", yscale="log", ylim=(1, 6), ylabel="separation distance $s$ / μm")
    ticks = [1, 1.5, 2, 3, 4, 5]
    axes.yaxis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.yaxis.set_ticks([], minor=True)
    axes.legend(loc="upper left", fontsize=7)


def draw_differences(axes, rows, variants):
    """Computed minus printed, with the band that the rounding of the printed values allows."""
    axes.axhspan(-ROUNDING, ROUNDING, color="#E0E0E0", lw=0)
    axes.axhline(0, color=style.BLACK, lw=0.6)
    compared = [row for row in rows if row["printed_s_um"] is not None]
    for number, variant in enumerate(variants):
        aside = 1 + 0.012 * (
            number - 0.5 * (len(variants) - 1)
        )  # so that equal values do not hide one another
        points = [row for row in compared if row[f"{variant}_s_um"] is not None]
        shifts = [aside * row["row_shift_um"] for row in points]
        differences = [row[f"{variant}_s_um"] - row["printed_s_um"] for row in points]
        axes.plot(shifts, differences, MARKERS[number % 4], color=COLOURS[number % 4], mfc="none")
    axes.set(xlabel="row shift $d$ / μm", ylabel="$s$ − printed / μm")
    ticks = [2, 3, 4, 5, 6, 8]
    axes.xaxis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.xaxis.set_ticks([], minor=True)


def main():
    arguments = figure_arguments(__doc__, "table", "fits", "claims")
    plan, table, fits = read_json(arguments.plan), read_table(arguments.table), read_table(arguments.fits)
    claims = load_claims(arguments.claims)
    printed, equation = claims["table-1"]["value"], claims["separation-law"]["value"]
    printed = {float(d): s for d, s in printed.items()}
    variants = plan["figures"]["law_variants"]
    rows = joined(table, printed, variants)
    columns = ["row_shift_um", "epsilon", "printed_s_um", *(f"{name}_s_um" for name in variants)]
    columns += ["refined_uncertainty_um"] if "refined" in variants else []
    styles = dict.fromkeys(columns, ".3f") | {"row_shift_um": ".1f", "epsilon": ".4f", "printed_s_um": ".1f"}
    write_table(rows, columns, arguments.csv, ["row_shift_um"], styles)
    figure = style.new_figure(style.COLUMN, 4.4)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=[2.2, 1])
    draw(upper, table, fits, printed, variants, equation)
    draw_differences(lower, rows, variants)
    style.save(figure, arguments.output, plan["note"])


main()
