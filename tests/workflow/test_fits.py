"""Fits find again what synthetic data were made with."""

import numpy as np
import pytest
from study.numerics import fits

EPSILON = np.array([5, 8, 11, 13, 15, 17, 20, 22]) / 80


def test_power_law_is_recovered():
    (a, b), errors = fits.fit_power_law(EPSILON, 19.2 * EPSILON**0.76)
    assert (a, b) == pytest.approx((19.2, 0.76), rel=1e-9)
    assert max(errors) < 1e-6


def test_power_law_uncertainty_covers_noise():
    noise = 0.05 * np.random.default_rng(1).standard_normal(len(EPSILON))
    (a, b), (error_a, error_b) = fits.fit_power_law(EPSILON, 19.2 * EPSILON**0.76 + noise)
    assert abs(a - 19.2) < 3 * error_a
    assert abs(b - 0.76) < 3 * error_b


def test_power_law_needs_three_points():
    with pytest.raises(ValueError, match="three points"):
        fits.fit_power_law([0.1, 0.2], [1.0, 2.0])


@pytest.mark.parametrize("order", [1.0, 1.6, 2.0, 3.0])
def test_limit_of_three_lattices_is_exact_for_any_order(order):
    h = np.array([0.4, 0.2, 0.4 / 3])
    limit, uncertainty, observed = fits.refined_limit(h, 2.5 + 0.7 * h**order)
    assert limit == pytest.approx(2.5, abs=1e-9)
    assert observed == pytest.approx(order, rel=1e-6)
    assert uncertainty > 0


def test_limit_does_not_depend_on_the_order_of_the_lattices():
    h = np.array([0.2, 0.4 / 3, 0.4])
    assert fits.refined_limit(h, 1 + h)[0] == pytest.approx(1, abs=1e-9)


def test_limit_of_two_lattices_assumes_second_order():
    h = np.array([0.8, 0.4])
    limit, uncertainty, observed = fits.refined_limit(h, 3 - 0.5 * h**2)
    assert limit == pytest.approx(3)
    assert uncertainty == pytest.approx(0.5 * 0.4**2)
    assert observed is None


def test_limit_without_monotony_states_no_order():
    limit, uncertainty, observed = fits.refined_limit([0.4, 0.2, 0.1], [1.00, 1.02, 1.01])
    assert observed is None
    assert abs(limit - 1.01) <= uncertainty + 1e-12


def test_chi_squared_counts_error_bars():
    x = np.array([0.0, 1.0, 2.0])
    assert fits.chi_squared(x, x, [(0.5, 0.7, 0.1), (1.5, 1.5, 0.1)]) == pytest.approx(4.0)


def test_parabola_minimum():
    x = np.array([2.0, 4.0, 8.0, 16.0])
    assert fits.parabola_minimum(x, np.log(x / 6) ** 2) == pytest.approx(6.0)
    assert fits.parabola_minimum(x, x) is None
