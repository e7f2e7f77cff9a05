"""What a run says about its device: its facts and the outline of its pillar, um."""

import math

import numpy as np

FACTS = ["pitch_x_um", "pitch_y_um", "depth_um", "gap_um", "length_scale_um", "open_share", "gap_line_x_um"]
#: Points on the outline of a circle that is known by its radius alone.
CIRCLE = 180


def circle_facts(geometry):
    """Facts and outline of an array of circles from the geometry of a case: for runs of a solver that did not
    state them."""
    radius, pitch, depth = (geometry[name] for name in ("pillar_radius_um", "pitch_um", "depth_um"))
    gap, angle = pitch - 2 * radius, np.linspace(0, 2 * math.pi, CIRCLE, endpoint=False)
    return {
        "pitch_x_um": pitch,
        "pitch_y_um": pitch,
        "gap_um": gap,
        "gap_line_x_um": 0.0,
        "length_scale_um": math.sqrt(gap * depth),
        "open_share": 1 - math.pi * radius**2 / pitch**2,
        "outline_um": np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]).tolist(),
    }


def facts_of(run):
    """{fact: value} of the device of a run, with `outline_um`, a list of points about the pillar's centre."""
    geometry = run.case["geometry"]
    return (run.summary.get("device") or circle_facts(geometry)) | {"depth_um": geometry["depth_um"]}


def pressure_gradient_bar_per_m(capillary_number, shear_modulus_uN_per_m, length_scale_um, radius_um):
    """p' = Ca kS / (l r) in bar/m (equal to mbar/mm); l and r in um, kS in uN/m."""
    return capillary_number * shear_modulus_uN_per_m / (length_scale_um * radius_um) * 1e6 * 1e-5


def shear_modulus(plan, cell):
    """kS of a cell of the study in uN/m; None where the study does not say it."""
    return plan["cells"][cell].get("shear_modulus_uN_per_m")
