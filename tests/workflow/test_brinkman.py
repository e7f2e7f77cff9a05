"""The depth-averaged flow: exact channel, order of convergence, symmetries, limits; the closed formulas."""

import cmath
import math
from itertools import pairwise

import numpy as np
import pytest
from study.analysis import cheap_models as models
from study.numerics import brinkman

ARRAY = models.Array(radius=10.0, pitch=32.0, depth=4.8, row_shift=8.0)


def channel(half_width):
    """Signed distance of walls at +- half_width, with fluid between them."""
    return lambda x, y: half_width - np.abs(y)


def channel_error(count, half_width=5.3, depth=4.8, pitch=16.0):
    """Largest deviation from the profile (1 - cosh(k y)/cosh(k b))/k^2, k^2 = 12/H^2, over the centre."""
    flow = brinkman.solve(channel(half_width), pitch, 0.0, depth, count)
    y = (np.arange(count) + 0.5) * flow.spacing - 0.5 * pitch
    k = math.sqrt(12.0) / depth
    exact = np.where(np.abs(y) < half_width, 1 - np.cosh(k * y) / np.cosh(k * half_width), 0.0) / k**2
    assert np.abs(flow.v).max() < 1e-10
    return np.abs(flow.u - exact[None, :]).max() / exact.max()


def test_plane_channel_converges_with_second_order_to_the_exact_profile():
    errors = [channel_error(count) for count in (12, 24, 48)]  # the walls lie between the nodes
    assert errors[-1] < 1e-3
    for coarse, fine in pairwise(errors):
        assert math.log2(coarse / fine) == pytest.approx(2.0, abs=0.25)


def test_deep_and_shallow_channel_limits():
    # H large: plane Poiseuille flow, mean b^2/3. H small: Darcy's law, mean H^2/12.
    for depth, mean in ((1e4, 5.0**2 / 3), (0.1, 0.1**2 / 12)):
        flow = brinkman.solve(channel(5.0), 16.0, 0.0, depth, 64)
        inside = 2 * 5.0 / 16.0
        found = flow.flux_u.sum() / (flow.spacing * 64 * 64) / inside
        assert found == pytest.approx(mean, rel=0.02), depth


def test_reversal_is_exact_and_the_flow_has_no_sources():
    forward = brinkman.solve(ARRAY.distance, 32.0, 8.0, 4.8, 20)
    backward = brinkman.solve(ARRAY.distance, 32.0, 8.0, 4.8, 20, force=(-1.0, 0.0))
    assert np.abs(forward.u + backward.u).max() < 1e-10 * np.abs(forward.u).max()
    # A point reflection about the pillar turns the array into itself and the flow round: u(-x) = u(x).
    turned = np.roll(forward.u[::-1, ::-1], 1, axis=0)[1:]
    assert np.abs(turned - forward.u[1:]).max() < 1e-9 * np.abs(forward.u).max()
    grid = brinkman.Grid(32.0, 8.0, 20)
    right = forward.flux_u.ravel()[grid.neighbour(1, 0)]
    upper = forward.flux_v.ravel()[grid.neighbour(0, 1)]
    assert np.abs(right - forward.flux_u + upper - forward.flux_v).max() < 1e-9 * forward.flux_u.max()


def test_coarse_grids_of_the_array_agree_with_a_fine_one_to_a_per_cent():
    finest = np.array(models.depth_averaged(ARRAY, 80)[:2])
    for count in (20, 40):
        assert models.depth_averaged(ARRAY, count)[:2] == pytest.approx(finest, rel=0.01), count


def test_shift_across_the_pitch_is_required_to_be_whole():
    with pytest.raises(ValueError, match="not a multiple"):
        brinkman.solve(ARRAY.distance, 32.0, 3.3, 4.8, 20)


def test_resistance_lies_above_that_of_potential_flow_and_of_the_empty_slit():
    # Without no-slip on the pillars the flow is potential; with it, the resistance can only rise.
    resistance = models.depth_averaged(ARRAY, 40)[1]
    assert resistance > models.hele_shaw_resistance(ARRAY) > models.slit_resistance(ARRAY)
    shallow = models.Array(10.0, 32.0, 0.2, 8.0)
    assert models.depth_averaged(shallow, 40)[1] == pytest.approx(
        models.hele_shaw_resistance(shallow), rel=0.03
    )


@pytest.mark.parametrize("epsilon", [0.01, 0.0625, 0.2, 0.275])
def test_parabola_is_the_formula_of_inglis_and_carries_its_share(epsilon):
    array = models.Array(10.0, 32.0, 4.8, 32.0 * epsilon)
    t = models.parabola(array) / array.gap
    assert 3 * t**2 - 2 * t**3 == pytest.approx(epsilon, rel=1e-12)
    w = (1 / 8 - epsilon / 4 + cmath.sqrt(epsilon / 16 * (epsilon - 1))) ** (1 / 3)
    root = complex(-0.5, -math.sqrt(3) / 2)  # the branch on which the diameter vanishes with epsilon
    diameter = 1 + 2 * root * w + 1 / (2 * root * w)
    assert 2 * t == pytest.approx(diameter.real, rel=1e-9)


def test_plug_and_davis():
    assert models.plug(ARRAY) == pytest.approx(3.0)
    assert 2 * models.davis(ARRAY) == pytest.approx(1.4 * 12 * 0.25**0.48)
