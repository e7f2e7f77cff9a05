"""Which settings are worth their cost: Pareto frontiers, and limits to measure errors against."""

import numpy as np

from study.numerics.fits import refined_limit


def on_frontier(costs, errors):
    """For every point whether no other is at least as cheap and as accurate and better in one of the two.

    Points without a cost or an error are never on the frontier; points that agree in both are so together.
    """
    costs, errors = np.asarray(costs, float), np.asarray(errors, float)
    usable = np.isfinite(costs) & np.isfinite(errors)
    kept = np.zeros(len(costs), bool)
    best, best_cost = np.inf, np.inf
    for index in sorted(np.flatnonzero(usable), key=lambda i: (costs[i], errors[i])):
        tie = errors[index] == best and costs[index] == best_cost
        if errors[index] < best or tie:
            kept[index], best, best_cost = True, errors[index], costs[index]
    return kept


def step_line(costs, errors):
    """Corners (x, y) of the frontier as a step line: the smallest error to be had for at most that cost."""
    order = np.argsort(costs)
    x, y = np.asarray(costs, float)[order], np.asarray(errors, float)[order]
    return np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1]


def straight_limit(spacings, values, order):
    """Limit and its standard error of values = limit + a spacing^order, by least squares over all points.

    For schemes whose error scatters about its trend, such as a staircase wall. Needs three points or more.
    """
    x, y = np.asarray(spacings, float) ** order, np.asarray(values, float)
    if len(x) < 3:
        raise ValueError("a limit with a standard error needs at least three points")
    matrix = np.stack([np.ones_like(x), x], 1)
    solution, *_ = np.linalg.lstsq(matrix, y, rcond=None)
    variance = np.sum((y - matrix @ solution) ** 2) / (len(x) - 2)
    return float(solution[0]), float(np.sqrt(variance * np.linalg.inv(matrix.T @ matrix)[0, 0]))


def limit(spacings, values, order):
    """(limit, uncertainty) of a ladder, with a given order or the one `observed` on its finest lattices."""
    if order == "observed":
        return refined_limit(spacings, values)[:2]
    return straight_limit(spacings, values, order)
