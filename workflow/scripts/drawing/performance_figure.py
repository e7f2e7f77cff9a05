"""Speed of the fluid against the bare collision, and what a whole step with a cell is made of."""

import numpy as np
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

RATES = ["bare collision", "fluid step 80^2", "fluid step 160^2", "fluid step 320^2"]
COLOURS = [
    style.BLUE,
    style.ORANGE,
    style.GREEN,
    style.SKY,
    style.VERMILION,
    style.PURPLE,
    style.YELLOW,
    style.PILLAR,
]
PARTS = [
    "membrane forces",
    "regularisation",
    "inside/outside field",
    "stencils",
    "spreading",
    "interpolation",
]


def draw_rates(axes, table):
    """Node updates per second: bars for the two precisions, half height."""
    rates = table[table.unit == "MLUPS"]
    width = 0.38
    for shift, (precision, colour) in enumerate(zip(["single", "double"], COLOURS, strict=False)):
        rows = rates[(rates.precision == precision) & (rates.height != "full")].set_index("quantity").value
        values = [rows.get(name, np.nan) for name in RATES]
        bars = axes.bar(
            np.arange(len(RATES)) + (shift - 0.5) * width, values, width, color=colour, label=precision
        )
        axes.bar_label(bars, fmt="%.0f", padding=1, fontsize=7)
    labels = [name.replace("fluid step ", "").replace("^2", "²") for name in RATES]
    axes.set_xticks(range(len(RATES)), ["bare\ncollision", *labels[1:]])
    axes.set_ylabel("million node updates per second")
    axes.set_xlabel("fluid step, nodes in the plane (half height)")
    axes.set_ylim(0, 1.25 * rates.value.max())
    axes.legend(loc="upper left", ncols=2)


def draw_step(axes, table):
    """The whole step at 80 x 80 x 6 in single precision, with its parts."""
    rows = (
        table[(table.unit == "ms") & (table.threads == 1)]
        .drop_duplicates("quantity")
        .set_index("quantity")
        .value
    )
    shares = {name: rows[name] for name in PARTS if name in rows}
    whole = rows["whole step 80^2"]
    nodes = table[table.quantity == "fluid nodes 80^2"].value.iloc[0]
    rate = table[
        (table.quantity == "fluid step 80^2") & (table.precision == "single") & (table.height == "half")
    ]
    steps = table[table.quantity == "fluid steps per update"].value.iloc[0]
    shares["inside/outside field"] /= table[table.quantity == "updates per inside/outside field"].value.iloc[
        0
    ]
    fluid = 1e-3 * nodes / rate.value.iloc[0]
    left = 0.0
    parts = {"fluid alone": fluid} | {name: value / steps for name, value in shares.items()}
    parts["rest"] = max(0.0, whole - sum(parts.values()))
    for (name, value), colour in zip(parts.items(), COLOURS, strict=False):
        axes.barh(0, value, left=left, color=colour, edgecolor="white", label=f"{name}: {1e3 * value:.0f} µs")
        left += value
    axes.set(yticks=[], xlabel="ms per fluid step, one core", ylim=(-0.5, 2.6))
    axes.set_title(f"whole step {whole:.3f} ms", loc="left")
    axes.legend(loc="upper left", ncols=2, handlelength=1.0)


def main():
    arguments = figure_arguments(__doc__, "table")
    table = read_table(arguments.table)
    table.to_csv(arguments.csv, index=False, lineterminator="\n")
    figure = style.new_figure(style.PAGE, 2.8)
    left, right = figure.subplots(1, 2, gridspec_kw={"width_ratios": [1, 1.15]})
    draw_rates(left, table)
    draw_step(right, table)
    machine = table[table.quantity == "processor"].unit
    figure.supxlabel(f"processor: {machine.iloc[0]}" if len(machine) else "", fontsize=7)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
