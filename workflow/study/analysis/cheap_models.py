"""Models of the cell-free array that cost next to nothing: closed formulas, and the depth-averaged flow.

Each gives the separation distance s (half the critical diameter), most of them also the flow resistance.
Lengths in um, viscosity of water (1 mPa s), resistance p' / u_mean in Pa s/m^2 with the mean over the fluid.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from study.numerics import brinkman

VISCOSITY_PA_S = 1e-3
METRES_PER_UM = 1e-6


@dataclass(frozen=True)
class Array:
    """Circular pillars in a row-shifted array."""

    radius: float
    pitch: float
    depth: float
    row_shift: float

    @property
    def gap(self):
        return self.pitch - 2.0 * self.radius

    @property
    def epsilon(self):
        return self.row_shift / self.pitch

    def distance(self, x, y):
        """Signed distance from the pillar at the origin and its neighbours, negative inside."""
        found = np.full(np.shape(x), np.inf)
        for n in (-1, 0, 1):
            for m in (-1, 0, 1):
                centre = (n * self.pitch, m * self.pitch + n * self.row_shift)
                found = np.minimum(found, np.hypot(x - centre[0], y - centre[1]) - self.radius)
        return found


def plug(array):
    """s of a uniform profile: the share epsilon of the gap carries the share epsilon of the flow."""
    return array.epsilon * array.gap


def parabola(array):
    """s of a parabolic profile in the gap (Inglis et al. 2006): the share t = s/G of the gap next to a wall
    carries 3 t^2 - 2 t^3 = epsilon of the flow; t is the root in (0, 1/2)."""
    return array.gap * (0.5 - math.sin(math.asin(1.0 - 2.0 * array.epsilon) / 3.0))


def davis(array):
    """Half of Davis' (2008) empirical critical diameter 1.4 G epsilon^0.48."""
    return 0.7 * array.gap * array.epsilon**0.48


def slit_resistance(array):
    """12 eta / H^2: the slit without pillars."""
    return 12.0 * VISCOSITY_PA_S / (array.depth * METRES_PER_UM) ** 2


def hele_shaw_resistance(array):
    """Potential flow round the pillars in a slit: the conductivity of a square array of insulating cylinders
    of area fraction phi is 1 - 2 phi / (1 + phi - 0.3058 phi^4) (Rayleigh 1892)."""
    phi = math.pi * (array.radius / array.pitch) ** 2
    conductivity = 1.0 - 2.0 * phi / (1.0 + phi - 0.3058 * phi**4)
    return slit_resistance(array) * (1.0 - phi) / conductivity


def stream_separation(flow, radius):
    """s of a `brinkman.Flow`: height above the pillar, on the gap line, of the stream that ends on the next
    pillar downstream. What flows between the two pillars passes above the first and below the other: it comes
    through the line from the first pillar at (0, 0) up to (0, d), less what leaves through the line from
    there to the other at (lambda, d)."""
    n, middle = len(flow.u), len(flow.u) // 2
    upwards = np.roll(flow.flux_u[middle], -middle)  # on x = 0, from the centre of the pillar
    stream = np.concatenate([[0.0], np.cumsum(upwards)])
    height = (middle + flow.shift) % n
    leaving = flow.flux_v[middle:, height].sum() + flow.flux_v[:middle, middle].sum()
    heights = flow.spacing * np.arange(n + 1)
    # A face at which the wall lies in the upper half carries nothing: the profile starts above it.
    free = (heights > radius) & (np.diff(stream, prepend=0.0) > 0)
    profile = PchipInterpolator(np.append(0.0, stream[free]), np.append(radius, heights[free]))
    return float(profile(stream[flow.shift] - leaving) - radius)


def depth_averaged(array, count):
    """s, resistance and operations of the depth-averaged flow on count x count cells."""
    flow = brinkman.solve(array.distance, array.pitch, array.row_shift, array.depth, count)
    resistance = flow.resistance * VISCOSITY_PA_S / METRES_PER_UM**2
    return stream_separation(flow, array.radius), resistance, flow.work
