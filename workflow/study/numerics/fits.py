"""Fits and estimates of the analysis. Pure functions of arrays."""

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq, curve_fit


def power_law(x, prefactor, exponent):
    """prefactor * x^exponent"""
    return prefactor * np.power(x, exponent)


def fit_power_law(x, y):
    """Least-squares fit y = A x^B; returns ((A, B), (standard errors)). Needs three points or more."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 3:
        raise ValueError("a power law with uncertainty needs at least three points")
    slope, offset = np.polyfit(np.log(x), np.log(y), 1)
    values, covariance = curve_fit(power_law, x, y, p0=(np.exp(offset), slope))
    return tuple(values), tuple(np.sqrt(np.diag(covariance)))


def bootstrap_power_law(x, y, samples=400, seed=20141):
    """95 % intervals of (A, B) of y = A x^B by resampling the points; NaN with fewer than four points."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 4:
        return ((np.nan, np.nan), (np.nan, np.nan))
    random, found = np.random.default_rng(seed), []
    while len(found) < samples:
        pick = random.integers(len(x), size=len(x))
        if len(set(x[pick])) >= 3:
            found.append(fit_power_law(x[pick], y[pick])[0])
    return tuple(map(tuple, np.percentile(found, [2.5, 97.5], axis=0).T))


def observed_order(spacings, values):
    """Order p of s = s0 + a h^p through three points; None outside 0.5 ... 4 or without monotony."""
    h3, h2, h1 = spacings
    d32, d21 = values[0] - values[1], values[1] - values[2]
    if d32 * d21 <= 0:
        return None

    def mismatch(p):
        return (h3**p - h2**p) / (h2**p - h1**p) - d32 / d21

    return brentq(mismatch, 0.5, 4.0) if mismatch(0.5) * mismatch(4.0) < 0 else None


def two_lattice_limit(spacings, values, order):
    """Limit at vanishing spacing through the two finest of values = limit + a spacing^order, coarse first."""
    return values[-1] + (values[-1] - values[-2]) / ((spacings[-2] / spacings[-1]) ** order - 1)


def first_order_limit(spacings, values):
    """(limit, observed order or None) of a length next to a pillar, coarse lattice first: of the order that
    three lattices show, else of first order."""
    order = observed_order(spacings[-3:], values[-3:]) if len(spacings) >= 3 else None
    return two_lattice_limit(spacings, values, order or 1.0), order


def refined_limit(spacings, values):
    """Limit of `values` at vanishing lattice spacing, as (limit, uncertainty, observed order or None).

    Three lattices: s = s0 + a h^p with the observed order p. Its uncertainty is the distance to the limit of
    the two finest lattices with p = 2. Where no order between 0.5 and 4 goes through the points (noise
    decides), and for two lattices, the limit is that of the two finest with p = 2 and its uncertainty the
    whole correction to the finest value. The smallest uncertainty stated is a tenth of that correction.
    """
    order = np.argsort(spacings)[::-1]
    h, s = np.asarray(spacings, float)[order], np.asarray(values, float)[order]
    if len(h) < 2:
        raise ValueError("a limit needs at least two lattices")
    second_order = two_lattice_limit(h, s, 2)
    correction = abs(second_order - s[-1])
    p = observed_order(h[-3:], s[-3:]) if len(h) >= 3 else None
    if p is None:
        return float(second_order), float(correction), None
    limit = two_lattice_limit(h, s, p)
    uncertainty = max(abs(limit - second_order), 0.1 * abs(limit - s[-1]))
    return float(limit), float(uncertainty), float(p)


def chi_squared(x, y, points):
    """Sum of ((curve - measurement) / error)^2; `points` are rows (x, value, error), the curve is y(x)."""
    curve = PchipInterpolator(x, y)
    return float(sum(((curve(at) - value) / error) ** 2 for at, value, error in points))


def parabola_minimum(x, y):
    """Position of the minimum of y(x) by a parabola in ln x through the lowest point and its neighbours.

    None if the lowest point is the first or the last: the minimum is then outside the range examined.
    """
    order = np.argsort(x)
    x, y = np.log(np.asarray(x, float)[order]), np.asarray(y, float)[order]
    lowest = int(np.argmin(y))
    if lowest in (0, len(x) - 1):
        return None
    a, b, _ = np.polyfit(x[lowest - 1 : lowest + 2], y[lowest - 1 : lowest + 2], 2)
    return float(np.exp(-b / (2 * a)))
