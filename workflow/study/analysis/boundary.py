"""The boundary of the phase space from brackets: the law d = a + b exp(-c Ca)."""

import math

import numpy as np
from scipy.optimize import minimize
from scipy.special import ndtr

#: Columns of the table of the boundary that a fit goes through, see undisputed.
UNDISPUTED = ["ca_undisputed_displaced", "ca_undisputed_zigzag"]
PARAMETERS = ("offset_um", "amplitude_um", "rate")
#: Smallest scatter of row shifts about the law that is believed, um: a twentieth of the paper's lattice.
SMALLEST_SCATTER_UM = 0.02
SEED, SAMPLES = 20141, 200
SAME = 1e-6  # capillary numbers and row shifts (um) closer than this are one


def law(parameters, capillary):
    """Row shift of the boundary, um: a + b exp(-c Ca)."""
    offset, amplitude, rate = parameters
    return offset + amplitude * np.exp(-rate * capillary)


def critical_capillary_number(row_shift_um, parameters):
    """Capillary number at which the law passes through a row shift (um); None where it does not."""
    offset, amplitude, rate = parameters
    part = (row_shift_um - offset) / amplitude
    return -math.log(part) / rate if 0 < part <= 1 else None


def printed_class(statements, row_shift_um, capillary):
    """The class that the text of the paper states for a cell; None where it is silent. A statement says up to
    which capillary number the cells of a row shift are displaced, and from which on they zigzag."""
    for said in statements:
        if abs(said["row_shift_um"] - row_shift_um) < SAME:
            if said["displaced_to"] is not None and capillary <= said["displaced_to"] + SAME:
                return "displaced"
            if said["zigzag_from"] is not None and capillary >= said["zigzag_from"] - SAME:
                return "zigzag"
    return None


def _negative_log_likelihood(vector, shifts, low, high):
    """-ln L of the brackets.

    The row shift at which a cell changes its class is law(Ca) + noise, normal with the scatter sigma; at row
    shift d it was displaced at Ca = low and zigzag at Ca = high (NaN: never seen).
    """
    offset, amplitude, rate = vector[0], math.exp(vector[1]), math.exp(vector[2])
    sigma = SMALLEST_SCATTER_UM + math.exp(vector[3])
    parameters = (offset, amplitude, rate)
    upper = np.where(np.isnan(low), np.inf, (law(parameters, np.nan_to_num(low)) - shifts) / sigma)
    lower = np.where(np.isnan(high), -np.inf, (law(parameters, np.nan_to_num(high)) - shifts) / sigma)
    # The probability between two points of the normal distribution, from the tail where it is not cancelled.
    flip = lower > 0
    a, b = np.where(flip, -upper, lower), np.where(flip, -lower, upper)
    chance = ndtr(b) - ndtr(a)
    far = 0.5 * np.minimum(np.abs(upper), np.abs(lower)) ** 2  # keeps a slope where the chance underflows
    return float(np.sum(np.where(chance > 1e-300, -np.log(np.maximum(chance, 1e-300)), 690 + far)))


def _maximum_likelihood(shifts, low, high, start):
    """(offset, ln amplitude, ln rate, ln(scatter - smallest)) of the largest likelihood, from a start."""
    options = {"xatol": 1e-5, "fatol": 1e-7, "maxiter": 4000, "maxfev": 4000}
    given = (shifts, low, high)
    return minimize(_negative_log_likelihood, start, given, method="Nelder-Mead", options=options).x


def undisputed(points):
    """(low, high): the largest value up to which no point is zigzag and the smallest from which none is
    displaced, None without one. The ends of a bracket, or further apart where points contradict its cut: a
    class that flips back and forth leaves the boundary anywhere between."""
    zigzag = [point["value"] for point in points if point["class"] == "zigzag"]
    displaced = [point["value"] for point in points if point["class"] == "displaced"]
    below = [value for value in displaced if not zigzag or value < min(zigzag)]
    above = [value for value in zigzag if not displaced or value > max(displaced)]
    return max(below, default=None), min(above, default=None)


def brackets_of(table, series):
    """(row shifts, displaced up to, zigzag from) of a series of the table of the boundary, for a fit: um and
    undisputed capillary numbers, NaN where there is none."""
    rows = table[(table.series == series) & table[UNDISPUTED].notna().any(axis=1)]
    return tuple(rows[["row_shift_um", *UNDISPUTED]].to_numpy(float).T)


def brackets_in(tables, series):
    """The same from the first of some tables that has the series; a row shift that stands there for several
    causes counts once."""
    for table in tables:
        if (table.series == series).any():
            return brackets_of(table.drop_duplicates(["series", "row_shift_um"]), series)
    return brackets_of(tables[-1], series)


def _closed(low, high):
    return ~np.isnan(low) & ~np.isnan(high)


def _placed(random, low, high):
    """Brackets shrunk to one value each, drawn inside (evenly in ln Ca); one-sided ones stay as they are."""
    closed = _closed(low, high)
    value = np.exp(random.uniform(np.log(low[closed]), np.log(high[closed])))
    low, high = low.copy(), high.copy()
    low[closed] = high[closed] = value
    return low, high * (1 + 1e-6)  # an interval of no width would have no chance at all


def bootstrap_boundary(shifts, low, high):
    """Most likely (offset, amplitude, rate, scatter) of d = a + b exp(-c Ca) through brackets [low, high] of
    Ca at row shifts d (um), NaN: no displaced (zigzag) point; and (offset, amplitude, rate) of brackets made
    anew, (SAMPLES, 3): the critical value drawn anywhere inside each, the row shift with the scatter of the
    fit, corrected for its degrees of freedom. A handful of brackets cannot be resampled: most draws would not
    fix three parameters, and those that do would all have the same brackets.

    None with fewer than four closed brackets.
    """
    shifts, low, high = (np.asarray(array, float) for array in (shifts, low, high))
    if _closed(low, high).sum() < 4:
        return None
    start = np.array([shifts.min() - 0.5, math.log(5.0), math.log(1.5), math.log(0.2)])
    best = _maximum_likelihood(shifts, low, high, start)
    best = _maximum_likelihood(shifts, low, high, best)  # a fresh simplex leaves a stalled one

    def values(vector):
        return np.array([vector[0], math.exp(vector[1]), math.exp(vector[2])])

    random, samples = np.random.default_rng(SEED), []
    scatter, closed = SMALLEST_SCATTER_UM + math.exp(best[3]), _closed(low, high).sum()
    spread = scatter * math.sqrt(closed / (closed - len(PARAMETERS)))
    for _ in range(SAMPLES):
        moved = shifts + spread * random.standard_normal(len(shifts))
        samples.append(values(_maximum_likelihood(moved, *_placed(random, low, high), best)))
    return np.append(values(best), scatter), np.array(samples)


def fit_boundary(shifts, low, high):
    """Interval-censored maximum likelihood of d = a + b exp(-c Ca) through brackets, see bootstrap_boundary.
    Returns (values, 2.5 %, 97.5 %, scatter).

    The uncertainty is a parametric bootstrap; its tails are too long for a standard error to mean anything.
    None with fewer than four closed brackets.
    """
    found = bootstrap_boundary(shifts, low, high)
    if found is None:
        return None
    best, samples = found
    ends = np.percentile(samples, [2.5, 97.5], axis=0)
    return best[:3], ends[0], ends[1], best[3]
