"""The optical tweezer as a predictor of the extent of a cell in the array: Ca_tw = (2 F / A) r / kS."""

import math

import numpy as np
from scipy.interpolate import PchipInterpolator

AREA_OVER_RADIUS_SQUARED = 8.72  # of the paper, Section 3.3
RADIUS_M, SHEAR_MODULUS_N_PER_M = 3.9e-6, 5.3e-6


def force_pN(capillary_number):
    """Pull at which the tweezer's capillary number has this value: 90.1 pN * Ca_tw."""
    return capillary_number * AREA_OVER_RADIUS_SQUARED * RADIUS_M * SHEAR_MODULUS_N_PER_M / 2 * 1e12


class TweezerCurve:
    """Transverse diameter (um) against the capillary number, for every denominator of the table of
    stretching.
    """

    def __init__(self, stretching):
        rows = stretching[(stretching.method == "static") & (stretching.status == "converged")]
        self._curves = {}
        for denominator, curve in rows.sort_values("force_pN").groupby("skalak_denominator"):
            force, diameter = curve.force_pN.to_numpy(float), curve.transverse_um.to_numpy(float)
            self._curves[float(denominator)] = PchipInterpolator(force, diameter, extrapolate=False)

    def diameter(self, capillary_number, denominator):
        """The diameter; NaN outside the range of forces and without a curve of this denominator."""
        curve = self._curves.get(float(denominator))
        return float(curve(force_pN(capillary_number))) if curve else math.nan


class SeparationCurve:
    """Separation distance s (um) against the row shift, a power law between the neighbouring simulated
    ones.
    """

    def __init__(self, separation):
        rows = separation[(separation.status == "converged") & (separation.s_um > 0)]
        self._curves = {
            name: curve.sort_values("row_shift_um")[["row_shift_um", "s_um"]].to_numpy(float).T
            for name, curve in rows.groupby(["device", "variant"])
        }

    def distance(self, device, variant, row_shift_um):
        """s; NaN outside the range of row shifts and for an unknown device or variant."""
        if (device, variant) not in self._curves:
            return math.nan
        shifts, distances = self._curves[device, variant]
        if not shifts[0] - 1e-9 <= row_shift_um <= shifts[-1] + 1e-9:
            return math.nan
        return float(np.exp(np.interp(math.log(row_shift_um), np.log(shifts), np.log(distances))))
