"""Small made-up tables for the checks of the claims: cells that follow the printed boundary, and brackets."""

import math

import pandas as pd
from study.analysis.boundary import UNDISPUTED
from study.paper import claims_boundary, claims_classes, claims_extent, claims_flow  # noqa: F401 (register checks)
from study.paper.claims import CHECKS
from study.paper.grades import NOT_RUN, graded
from study.paper.readings import view

SHIFTS = (2.0, 3.2, 3.6, 4.4, 5.2, 6.0, 6.8, 7.2, 8.0, 8.8)
NUMBERS = (0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1.0, 1.2, 1.5, 1.9, 2.4)

#: Table 1 of the paper.
DISTANCES = {2.0: 1.2, 3.2: 1.7, 4.4: 2.1, 5.2: 2.4, 6.0: 2.7, 6.8: 3.0, 8.0: 3.4, 8.8: 3.6}
DEFAULT = {"id": "default", "sweep": "grid", "series": "default", "description": "what the verdicts rest on"}


def printed_class(shift, capillary):
    """Class by the printed boundary."""
    return "displaced" if shift < 2.9 + 5.4 * math.exp(-1.72 * capillary) else "zigzag"


def passage(sweep, shift, capillary, label=None, **other):
    """One row of the passages; its class is that of the printed boundary if none is given."""
    row = {"sweep": sweep, "dx_um": 0.4, "skalak_denominator": 12, "row_shift_um": shift}
    row |= {"capillary_number": capillary, "class": label or printed_class(shift, capillary)}
    row |= {"d_perp_um": 7.0 - 2.5 * capillary, "d_perp_at_centre_um": 6.9 - 2.5 * capillary, "film_um": 0.5}
    row |= {"speed_um_per_kilostep": 6.0, "run": f"{sweep}-{shift:g}-{capillary:g}"}
    return row | other


def bracket(series, shift, displaced, zigzag, **other):
    """One row of the boundary; None for an end that there is not."""
    row = {"series": series, "dx_um": 0.4, "row_shift_um": shift, "status": "bracketed"}
    row |= {"ca_displaced": displaced, "ca_zigzag": zigzag}
    row |= {"runs": f"{series}-{shift:g}-a {series}-{shift:g}-b"}
    row |= dict(zip(UNDISPUTED, (displaced, zigzag), strict=True)) | other
    return {key: math.nan if value is None else value for key, value in row.items()}


def prediction(row):
    """The row of the predictions for a passage: with s = 2.5 um, right as long as that is where it lies."""
    keys = ("sweep", "dx_um", "skalak_denominator", "row_shift_um", "capillary_number", "class", "run")
    found = {key: row[key] for key in keys}
    found |= {"s_um": 2.5, "printed_d_cr_um": 5.4, "tweezer_um": 6.0, "right_tweezer": 1.0}
    return found | dict.fromkeys(("right_tweezer_printed_law", "right_d_perp", "right_centre"), 1.0)


def fit_rows(name, **parameters):
    """Rows of a fit."""
    return [
        {"name": name, "parameter": key, "value": value, "std_error": 0.1}
        | {"low": value - 0.1, "high": value + 0.1}
        for key, value in parameters.items()
    ]


def flow(variant, shift, resistance):
    """One row of the flow without a cell, with the printed separation distances."""
    row = {"variant": variant, "dx_um": 0.4, "row_shift_um": shift, "epsilon": shift / 32}
    row |= {"s_um": DISTANCES[shift], "s_uncertainty_um": 0.01, "resistance_Pa_s_per_m2": resistance}
    row |= {"reynolds_number": 0.46, "reynolds_number_slit": 0.77, "reynolds_number_superficial": 0.32}
    return row | {"status": "converged", "run": f"{variant}-{shift:g}"}


def stretched():
    """A static stretching whose transverse diameter falls evenly: 8 um at rest, 6 um at 200 pN."""
    forces = (0.0, 50.0, 100.0, 200.0)
    row = {"method": "static", "skalak_denominator": 12, "mesh_frequency": 10, "status": "converged"}
    row |= {"area_over_radius_squared": 8.72, "run": "stretched"}
    return [row | {"force_pN": f, "axial_um": 8 + f / 25, "transverse_um": 8 - f / 100} for f in forces]


def tables(passages=(), brackets=()):
    """All tables that the checks read: the printed grid, and the passages and brackets that are given."""
    rows = [passage("grid", shift, number) for shift in SHIFTS for number in NUMBERS] + list(passages)
    units = {"source": "l = sqrt(G H), resistance of paper", "capillary_number": [0.1, 1.5]}
    units |= {"pressure_gradient_bar_per_m": [0.1791, 2.6859], "mean_velocity_mm_per_s": [0.0206, 0.3096]}
    flows = [flow("paper", d, 8.8e8) for d in DISTANCES] + [
        flow("blocked-lateral", d, 9e8) for d in DISTANCES
    ]
    stokes = {"row_shift_um": [2.0, 5.2, 8.0], "dx_um": 0.4, "relative_change": 1e-5}
    stokes |= {"reversal_max_high": 1e-3, "s_um_high": 1.2, "s_upper_um_high": 1.21, "runs": "a b"}
    found = {"passages": rows, "a_priori": [prediction(row) for row in rows]}
    found["phase_boundary"] = [bracket("default", 2.0, 2.4, None), *brackets]
    found["fits"] = fit_rows("boundary/default", offset_um=2.9, amplitude_um=5.4, rate=1.72)
    found["fits"] += fit_rows("separation-law/paper", A_um=19.2, B=0.76)
    found["fits"] += fit_rows("separation-law/blocked-lateral", A_um=18.5, B=0.7)
    mirror = {"dx_um": 0.4, "capillary_number": 0.4, "d_displaced_um": 5.2, "d_zigzag_um": 5.6}
    found |= {"streamline_separation": flows, "stretching": stretched(), "critical_row_shift": [mirror]}
    found |= {"units": units, "stokes_checks": stokes}
    return {name: pd.DataFrame(value) for name, value in found.items()}


def judged(claims, name, given, reading=DEFAULT):
    """The finding of a claim by some tables in a reading; None where it has no runs."""
    experiment = pd.DataFrame({"set": "SURESH2005_FIG7", "F_pN": [50.0], "DA_um": 10.0, "DA_err_um": 1.0})
    experiment = experiment.assign(DT_um=7.5, DT_err_um=1.0)
    return CHECKS[name](view(given, reading), claims[name], experiment)


def grade_of(claims, name, given, reading=DEFAULT):
    """The grade of a claim by some tables in a reading."""
    found = judged(claims, name, given, reading)
    return NOT_RUN if found is None else graded(claims[name], found)[0]
