"""Separation distance, flow resistance and Reynolds numbers of every variant of the flow, and their
limits at vanishing lattice spacing (study.numerics.fits.refined_limit says how)."""

from collections import defaultdict

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.numerics.fits import refined_limit
from study.planning.documents import read_json

LIMITS = {
    "s_um": "separation_um",
    "s_upper_um": "separation_upper_um",
    "resistance_Pa_s_per_m2": "resistance_Pa_s_per_m2",
    "lateral_velocity_ratio": "lateral_velocity_ratio",
}
NUMBERS = [
    "reynolds_number",
    "reynolds_number_superficial",
    "reynolds_number_slit",
    "mean_velocity",
    "density_variation",
    "lateral_force_ratio",
    "steps",
    "status",
]
COLUMNS = [
    "device",
    "variant",
    "dx_um",
    "row_shift_um",
    "epsilon",
    "s_um",
    "s_uncertainty_um",
    "observed_order",
    "s_upper_um",
    "s_upper_uncertainty_um",
    "resistance_Pa_s_per_m2",
    "resistance_uncertainty_Pa_s_per_m2",
    "lateral_velocity_ratio",
    *NUMBERS,
    "run",
]
STYLES = {
    "s_um": ".4f",
    "s_upper_um": ".4f",
    "s_uncertainty_um": ".4f",
    "s_upper_uncertainty_um": ".4f",
    "observed_order": ".2f",
    "row_shift_um": ".1f",
    "epsilon": ".4f",
    "dx_um": ".4f",
    "resistance_Pa_s_per_m2": ".5e",
    "resistance_uncertainty_Pa_s_per_m2": ".1e",
}


def row_of(run):
    """Table row of one run."""
    summary = run.summary
    row = {
        "device": run.labels["device"],
        "variant": run.labels["variant"],
        "dx_um": run.dx_um,
        "run": run.id,
    }
    row |= {"row_shift_um": run.row_shift_um, "epsilon": run.epsilon}
    row |= {name: summary.get(key) for name, key in LIMITS.items()}
    return row | {name: summary.get(name) for name in NUMBERS}


def limit_rows(name, variants, rows):
    """Rows of a limit dx -> 0, one for each device and row shift that all its variants have."""
    by_shift = defaultdict(list)
    for row in rows:
        if row["variant"] in variants and row["status"] == "converged":
            by_shift[row["device"], row["row_shift_um"]].append(row)
    for (device, shift), members in by_shift.items():
        if len(members) < len(variants):
            continue
        spacings = [row["dx_um"] for row in members]
        estimates = {key: refined_limit(spacings, [row[key] for row in members]) for key in LIMITS}
        yield {
            "device": device,
            "variant": name,
            "dx_um": 0.0,
            "row_shift_um": shift,
            "epsilon": members[0]["epsilon"],
            **{key: estimate[0] for key, estimate in estimates.items()},
            "s_uncertainty_um": estimates["s_um"][1],
            "s_upper_uncertainty_um": estimates["s_upper_um"][1],
            "observed_order": estimates["s_um"][2],
            "resistance_uncertainty_Pa_s_per_m2": estimates["resistance_Pa_s_per_m2"][1],
            "status": "converged",
        }


def main():
    arguments = table_arguments(__doc__)
    rows = [row_of(run) for run in load_runs(arguments.plan, arguments.runs, "streamlines")]
    refinement = read_json(arguments.plan)["refinement"]
    limits = [row for name, variants in refinement.items() for row in limit_rows(name, variants, rows)]
    write_table(rows + limits, COLUMNS, arguments.output, ["device", "variant", "row_shift_um"], STYLES)


main()
