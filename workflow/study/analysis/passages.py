"""What the study says of one passage of a cell: the columns of passages.csv, their formats, one row."""

FROM_SUMMARY = [
    "d_perp_um",
    "d_perp_at_centre_um",
    "centre_um",
    "film_um",
    "area_change",
    "volume_change",
    "min_face_ratio",
    "max_local_area_strain",
    "crossings",
    "zigs",
    "defining_crossing",
    "steps",
    "node_updates",
    "membrane_updates",
    "density_variation",
    "failing_quantity",
    "failing_value",
    "failing_step",
]
#: Where a passage stands, by which the rows are sorted.
KEYS = [
    "sweep",
    "device",
    "cell",
    "dx_um",
    "skalak_denominator",
    "lateral_flow",
    "row_shift_um",
    "epsilon",
    "capillary_number",
]
COLUMNS = [*KEYS, "class", *FROM_SUMMARY, "speed_um_per_kilostep", "run"]
STYLES = {
    "dx_um": ".4f",
    "row_shift_um": ".1f",
    "epsilon": ".4f",
    "capillary_number": ".4g",
    "d_perp_um": ".3f",
    "d_perp_at_centre_um": ".3f",
    "centre_um": ".3f",
    "film_um": ".3f",
    "area_change": ".2e",
    "volume_change": ".2e",
    "density_variation": ".2e",
    "min_face_ratio": ".3f",
    "max_local_area_strain": ".3f",
    "speed_um_per_kilostep": ".4f",
}


def mean_speed(run):
    """Mean speed along x in um per 1000 steps, from the first pillar line to the last; None for one line."""
    step = run.data("crossings/step")
    if step is None or len(step) < 2:
        return None
    return 1000.0 * (len(step) - 1) * run.case["geometry"]["pitch_um"] / float(step[-1] - step[0])


def row_of(run):
    """Table row of one passage."""
    summary = run.summary
    return {
        **{name: run.labels[name] for name in ("sweep", "device", "cell")},
        "dx_um": run.dx_um,
        "skalak_denominator": run.case["cell"]["skalak_denominator"],
        "lateral_flow": run.case["fluid"]["lateral_flow"],
        "row_shift_um": run.row_shift_um,
        "epsilon": run.epsilon,
        "capillary_number": run.case["cell"]["capillary_number"],
        "class": summary["status"],
        **{name: summary.get(name) for name in FROM_SUMMARY},
        "speed_um_per_kilostep": mean_speed(run),
        "run": run.id,
    }
