"""Streamlines of the mid-plane flow through the array, from the field of one unit cell."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import RegularGridInterpolator


class MidPlaneFlow:
    """Velocity of the row-shifted array: u(x + pitch, y + shift) = u(x, y) = u(x, y + pitch).
    Lengths in um.
    """

    def __init__(self, x, y, velocity, pitch, shift):
        self.x0, self.y0, self.pitch, self.shift = x[0], y[0], pitch, shift
        step, lower = x[1] - x[0], round(shift / (x[1] - x[0]))
        right = np.roll(velocity[:1], lower, axis=1)  # the next cell's first column, moved up by the shift
        field = np.concatenate([velocity, right], axis=0)
        field = np.concatenate([field, field[:, :1]], axis=1)
        axes = (np.append(x, x[-1] + step), np.append(y, y[-1] + step))
        self._field = RegularGridInterpolator(axes, field, bounds_error=False, fill_value=None)

    def __call__(self, points):
        """Velocities (n, 2) at points (n, 2)."""
        column = np.floor((points[:, 0] - self.x0) / self.pitch)
        x = points[:, 0] - column * self.pitch
        y = self.y0 + np.mod(points[:, 1] - column * self.shift - self.y0, self.pitch)
        return self._field(np.column_stack([x, y]))

    def equal_flux_seeds(self, radius, streams):
        """Heights on the gap line x = 0 that part its flux into equal streams, (streams - 1)."""
        y = np.linspace(radius, self.pitch - radius, 400)
        u = self(np.column_stack([np.zeros_like(y), y]))[:, 0]
        flux = np.concatenate([[0], np.cumsum(0.5 * (u[1:] + u[:-1]) * np.diff(y))])
        return np.interp(flux[-1] * np.arange(1, streams) / streams, flux, y)

    def streamline(self, start, length, sign=1.0):
        """Points (n, 2) of the streamline through `start` of this length, down or up (sign -1) the flow."""

        def direction(_, point):
            velocity = self(point[None])[0]
            return sign * velocity / max(np.hypot(*velocity), 1e-30)

        at = np.arange(0.0, length, 0.5)
        return solve_ivp(direction, (0, length), start, t_eval=at, max_step=1.0, rtol=1e-5).y.T
