"""Depth-averaged flow through the pillar array: two dimensions and wall friction instead of three.

    -grad p + eta (laplace u - 12 u / H^2) + f = 0,  div u = 0       (Brinkman; Hele-Shaw with pillars)
    u = 0 on the pillars,  u(x + lambda, y) = u(x, y - d)

The parabola across the depth H is assumed everywhere, also next to the pillars: that is the error of the
model, and the grid's error comes on top. Marker-and-cell grid (Harlow and Welch 1965): u on the faces across
x, v on those across y, p in the cells. Next to a pillar the Laplacian uses the true distance of the wall
(Shortley and Weller 1938), the balance of volume the open share of every face: so the discrete flow has a
stream function.
"""

from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

DIRECTIONS = ((1, 0), (-1, 0), (0, 1), (0, -1))


@dataclass(frozen=True)
class Flow:
    """Flow of one unit cell, for unit viscosity; lengths in the units of the input.

    u, v: (n, n), mean velocity on the open part of the faces at (i h, (j + 1/2) h) and ((i + 1/2) h, j h);
    flux_u, flux_v: (n, n), volume per time through them; work: multiplications and additions of the solution.
    """

    u: np.ndarray
    v: np.ndarray
    flux_u: np.ndarray
    flux_v: np.ndarray
    spacing: float
    shift: int
    pressure_gradient: float
    open_area: float
    work: float

    @property
    def resistance(self):
        """Driving force over the mean velocity along it, mean over the fluid; times the viscosity."""
        n = len(self.u)
        superficial = self.flux_u.sum() / (n * n * self.spacing)
        return self.pressure_gradient / (superficial / self.open_area)


class Grid:
    """Places of the unit cell, and their neighbours in the row-shifted periodic array."""

    def __init__(self, pitch, row_shift, count):
        self.n, self.h = count, pitch / count
        self.shift = round(row_shift / self.h)
        if abs(self.shift * self.h - row_shift) > 1e-9 * pitch:
            raise ValueError(f"the row shift {row_shift} is not a multiple of the spacing {self.h}")
        self.i, self.j = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")

    def points(self, di, dj):
        """Coordinates (n, n) of the places (i + di, j + dj) h, with the pillar in the middle of the cell."""
        half = 0.5 * self.n * self.h
        return (self.i + di) * self.h - half, (self.j + dj) * self.h - half

    def neighbour(self, di, dj):
        """Flat indices (n, n) of the places (i + di, j + dj): phi(x + lambda, y) = phi(x, y - d)."""
        turns, i = np.divmod(self.i + di, self.n)
        return i * self.n + (self.j + dj - turns * self.shift) % self.n


def _wall_share(distance, x, y, dx, dy):
    """Share of the way (dx, dy) at which the wall is met (bisection); only where the far end is solid."""
    low, high = np.zeros_like(x), np.ones_like(x)
    for _ in range(40):
        middle = 0.5 * (low + high)
        free = distance(x + middle * dx, y + middle * dy) > 0
        low, high = np.where(free, middle, low), np.where(free, high, middle)
    return np.maximum(0.5 * (low + high), 1e-3)


def _open_share(distance, x, y, dx, dy):
    """Share of the segment from (x, y) to (x + dx, y + dy) that is fluid; one wall at most on it."""
    first, last = distance(x, y) > 0, distance(x + dx, y + dy) > 0
    met = _wall_share(lambda a, b: np.where(first, 1, -1) * distance(a, b), x, y, dx, dy)
    return np.where(first & last, 1.0, np.where(first, met, np.where(last, 1.0 - met, 0.0)))


def _friction(grid, distance, offset, depth):
    """Matrix of 12 u / H^2 - laplace u for a velocity at (i, j) + offset, and where it is fluid (n, n)."""
    h, size = grid.h, grid.n * grid.n
    x, y = grid.points(*offset)
    fluid = distance(x, y) > 0
    row = grid.neighbour(0, 0)
    share, inside = {}, {}
    for way in DIRECTIONS:
        inside[way] = distance(x + h * way[0], y + h * way[1]) > 0
        met = _wall_share(distance, x, y, h * way[0], h * way[1])
        share[way] = np.where(inside[way], 1.0, met)
    diagonal = np.full((grid.n, grid.n), 12.0 / depth**2)
    entries = []
    for way in DIRECTIONS:
        total = share[way] + share[(-way[0], -way[1])]
        weight = 2.0 / (h * h * share[way] * total)
        diagonal += weight
        used = fluid & inside[way]
        entries.append((-weight[used], row[used], grid.neighbour(*way)[used]))
    diagonal[~fluid] = 1.0
    entries.append((diagonal.ravel(), row.ravel(), row.ravel()))
    values, rows, columns = (np.concatenate(part) for part in zip(*entries, strict=True))
    return sparse.csr_matrix((values, (rows, columns)), (size, size)), fluid


def _differences(grid, fluid, way):
    """Matrix of the pressure difference over a face: p of its cell minus p of the cell before it, over h."""
    size = grid.n * grid.n
    here, before = grid.neighbour(0, 0)[fluid], grid.neighbour(-way[0], -way[1])[fluid]
    ones = np.ones(len(here)) / grid.h
    entries = (np.concatenate([ones, -ones]), (np.tile(here, 2), np.concatenate([here, before])))
    return sparse.csr_matrix(entries, (size, size))


def _solved(matrix, right_side):
    """Solution of a sparse system and the operations that it took (counted on the factors)."""
    factors = splu(sparse.csc_matrix(matrix))
    below = np.diff(factors.L.tocsc().indptr) - 1
    right = np.diff(factors.U.tocsr().indptr)
    operations = 2.0 * float(below.astype(float) @ right) + 2.0 * (factors.L.nnz + factors.U.nnz)
    return factors.solve(right_side), operations


def solve(distance, pitch, row_shift, depth, count, force=(1.0, 0.0)):
    """The flow of the array driven by a force per volume, on count x count cells, as a `Flow`.

    `distance(x, y)` is the signed distance from the pillar in the middle of the unit cell, negative inside.
    """
    grid = Grid(pitch, row_shift, count)
    size, h = count * count, grid.h
    friction_u, fluid_u = _friction(grid, distance, (0.0, 0.5), depth)
    friction_v, fluid_v = _friction(grid, distance, (0.5, 0.0), depth)
    open_u = np.where(fluid_u, _open_share(distance, *grid.points(0, 0), 0 * grid.i, h), 0.0)
    open_v = np.where(fluid_v, _open_share(distance, *grid.points(0, 0), h, 0 * grid.i), 0.0)
    gradient = [_differences(grid, fluid_u, (1, 0)), _differences(grid, fluid_v, (0, 1))]
    shares = [sparse.diags(share.ravel()) for share in (open_u, open_v)]
    divergence = [-(part.T @ share) for part, share in zip(gradient, shares, strict=True)]
    matrix = sparse.bmat(
        [[friction_u, None, gradient[0]], [None, friction_v, gradient[1]], [*divergence, None]]
    ).tocsr()
    # Cells without an open face have no pressure, and one of the others is the level of the pressure.
    used = np.flatnonzero((abs(divergence[0]) + abs(divergence[1])).sum(axis=1).A1)[1:] + 2 * size
    kept = np.concatenate([np.arange(2 * size), used])
    right_side = np.concatenate([force[0] * fluid_u.ravel(), force[1] * fluid_v.ravel(), np.zeros(size)])
    solution, operations = _solved(matrix[kept][:, kept], right_side[kept])
    u, v = (solution[part * size : (part + 1) * size].reshape(count, count) for part in (0, 1))
    x, y = grid.points(0.5, 0.5)
    open_area = float(np.mean(np.clip(0.5 + distance(x, y) / h, 0.0, 1.0)))
    flux_u, flux_v = u * open_u * h, v * open_v * h
    return Flow(u, v, flux_u, flux_v, h, grid.shift, float(np.hypot(*force)), open_area, operations)
