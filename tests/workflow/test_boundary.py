"""The law of the boundary is found again from synthetic brackets."""

import math

import numpy as np
import pytest
from study.analysis.boundary import fit_boundary, law, undisputed

TRUE = (2.9, 5.4, 1.72)
SHIFTS = np.array([2.0, 3.2, 3.6, 4.4, 5.2, 6.0, 6.8, 7.2, 8.0, 8.8])


def made_brackets(width, range_=(0.1, 2.4), scatter=0.0):
    """Brackets of relative width at every row shift; NaN where the boundary is outside the range."""
    noise = scatter * np.random.default_rng(3).standard_normal(len(SHIFTS))
    low, high = np.full(len(SHIFTS), np.nan), np.full(len(SHIFTS), np.nan)
    for k, shift in enumerate(SHIFTS + noise):
        ratio = (shift - TRUE[0]) / TRUE[1]
        critical = -math.log(ratio) / TRUE[2] if ratio > 0 else math.inf
        if critical >= range_[1]:
            low[k] = range_[1]
        elif critical <= range_[0]:
            high[k] = range_[0]
        else:
            low[k], high[k] = critical * (1 - 0.4 * width), critical * (1 + 0.6 * width)
    return low, high


def test_the_law_is_recovered_from_narrow_brackets():
    values, low, high, scatter = fit_boundary(SHIFTS, *made_brackets(0.02))
    assert values == pytest.approx(TRUE, rel=0.03)
    assert np.all(high - low < 0.4 * np.array(TRUE))
    assert np.all(low <= values) and np.all(values <= high)
    assert scatter < 0.05


def test_wide_brackets_keep_the_law_within_them():
    low, high = made_brackets(0.3)
    values, *_ = fit_boundary(SHIFTS, low, high)
    closed = ~np.isnan(low) & ~np.isnan(high)
    assert np.all(law(values, low[closed]) > SHIFTS[closed] - 0.05)
    assert np.all(law(values, high[closed]) < SHIFTS[closed] + 0.05)


def test_scatter_is_found_and_widens_the_intervals():
    exact = fit_boundary(SHIFTS, *made_brackets(0.02))
    noisy = fit_boundary(SHIFTS, *made_brackets(0.02, scatter=0.15))
    assert noisy[3] == pytest.approx(0.15, rel=0.6)
    assert np.all(noisy[2] - noisy[1] > exact[2] - exact[1])


def test_the_fit_is_the_same_every_time():
    first, second = (fit_boundary(SHIFTS, *made_brackets(0.05)) for _ in range(2))
    assert all(np.array_equal(a, b) for a, b in zip(first, second, strict=True))


def test_four_wide_brackets_leave_an_uncertainty_that_holds_the_law():
    """Nothing can be left out of four brackets, yet the law is not known exactly."""
    shifts, low, high = SHIFTS[3:7], *(ends[3:7] for ends in made_brackets(0.3))
    values, below, above, _ = fit_boundary(shifts, low, high)
    assert (below < values).all() and (values < above).all()
    capillary = np.sqrt(low * high)
    assert (np.abs(law(values, capillary) - shifts) < 0.4).all()


def test_too_few_brackets_give_no_fit():
    assert fit_boundary([4.4, 6.0, 6.8], [0.7, 0.3, 0.2], [0.8, 0.4, 0.3]) is None


def test_points_that_contradict_the_cut_leave_the_boundary_open_between_them():
    def points(classes):
        return [{"value": 0.1 * (k + 1), "class": name} for k, name in enumerate(classes)]

    clear = points(["displaced", "undecided", "zigzag"])
    flipping = points(["displaced", "zigzag", "displaced", "zigzag"])
    assert undisputed(clear) == (pytest.approx(0.1), pytest.approx(0.3))
    assert undisputed(flipping) == (pytest.approx(0.1), pytest.approx(0.4))
    assert undisputed(points(["zigzag", "displaced"])) == (None, None)
    assert undisputed(points(["displaced", "displaced"])) == (pytest.approx(0.2), None)
