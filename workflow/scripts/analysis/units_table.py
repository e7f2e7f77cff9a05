"""What the capillary number means in SI units for a healthy cell, by the definition Ca = p' l r / kS with
l = sqrt(G H) and with l = H, beside the values that the paper prints; the paper's contradict its definition.

The velocity is p' / resistance with the mean resistance of the variants `paper` and `refined`.
"""

import math

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table, write_table
from study.paper.claims import load_claims

GAP_M, DEPTH_M, RADIUS_M = 12e-6, 4.8e-6, 3.9e-6
SHEAR_MODULUS_N_PER_M = 5.3e-6
PASCAL_PER_BAR = 1e5
COLUMNS = [
    "source",
    "capillary_number",
    "length_scale_um",
    "resistance_Pa_s_per_m2",
    "pressure_gradient_bar_per_m",
    "mean_velocity_mm_per_s",
    "ratio_printed_to_this",
]


def computed(source, capillary_number, length_m, resistance, printed_gradient):
    """Row of the pressure gradient and velocity that give a capillary number."""
    gradient = capillary_number * SHEAR_MODULUS_N_PER_M / (length_m * RADIUS_M)
    return {
        "source": source,
        "capillary_number": capillary_number,
        "length_scale_um": length_m * 1e6,
        "resistance_Pa_s_per_m2": resistance,
        "pressure_gradient_bar_per_m": gradient / PASCAL_PER_BAR,
        "mean_velocity_mm_per_s": gradient / resistance * 1e3,
        "ratio_printed_to_this": printed_gradient / (gradient / PASCAL_PER_BAR),
    }


def main():
    arguments = required_arguments(__doc__, "table", "claims", "output")
    printed = load_claims(arguments.claims)["unit-conversion"]["value"]
    table = read_table(arguments.table)
    lengths = {"l = sqrt(G H)": math.sqrt(GAP_M * DEPTH_M), "l = H": DEPTH_M}
    rows = []
    for capillary_number, gradient, velocity in zip(
        printed["capillary_number"],
        printed["pressure_gradient_bar_per_m"],
        printed["mean_velocity_mm_per_s"],
        strict=True,
    ):
        row = {"source": "printed", "capillary_number": capillary_number}
        rows.append(row | {"pressure_gradient_bar_per_m": gradient, "mean_velocity_mm_per_s": velocity})
        for variant in ("paper", "refined"):
            resistance = table[table.variant == variant].resistance_Pa_s_per_m2.mean()
            for name, length in lengths.items():
                source = f"{name}, resistance of {variant}"
                rows.append(computed(source, capillary_number, length, resistance, gradient))
    styles = dict.fromkeys(["pressure_gradient_bar_per_m", "mean_velocity_mm_per_s"], ".4f")
    styles |= {"ratio_printed_to_this": ".3f", "length_scale_um": ".3f", "resistance_Pa_s_per_m2": ".4e"}
    write_table(rows, COLUMNS, arguments.output, ["source", "capillary_number"], styles)


main()
