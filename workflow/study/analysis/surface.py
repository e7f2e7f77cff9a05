"""Shaded pictures of triangulated cells and their sections with planes."""

import numpy as np
from matplotlib.collections import PolyCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

LIGHT = np.array([-0.45, -0.55, 0.7]) / np.linalg.norm([-0.45, -0.55, 0.7])
RED = (0.85, 0.22, 0.18)


def shaded_colours(normals, colour):
    """Colours (n, 4) of faces with the given unit normals: ambient and diffuse light and a soft highlight."""
    facing = np.clip(normals @ LIGHT, 0.0, 1.0)[:, None]
    base = np.asarray(colour)[None, :]
    tint = np.clip(base * (0.35 + 0.65 * facing) + 0.25 * facing**12, 0.0, 1.0)
    return np.hstack([tint, np.ones((len(tint), 1))])


def shaded_faces(vertices, faces, colour):
    """Corners (n, 3, 3), unit normals (n, 3), face colours and edge colours (n, 4) of a triangulated cell."""
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    colours = shaded_colours(normals, colour)
    return corners, normals, colours, colours * np.array([0.72, 0.72, 0.72, 1.0])


def draw_cell(axes, vertices, faces, half_width, colour=RED, elevation=32, azimuth=-62):
    """Draws a cell (vertices in um) around its centre in 3D axes of +- half_width um, without frame."""
    corners, _, colours, edges = shaded_faces(vertices - vertices.mean(axis=0), faces, colour)
    surface = Poly3DCollection(corners, facecolors=colours, edgecolors=edges, linewidths=0.25, clip_on=False)
    axes.add_collection3d(surface)
    axes.set_proj_type("ortho")
    axes.view_init(elev=elevation, azim=azimuth)
    axes.set(xlim=(-half_width, half_width), ylim=(-half_width, half_width), zlim=(-half_width, half_width))
    axes.set_box_aspect((1, 1, 1), zoom=1.8)
    axes.set_axis_off()


def draw_from_above(axes, vertices, faces, colour=RED):
    """Draws a cell (vertices in um) in plane axes seen along -z: the faces that look up, low ones first."""
    corners, normals, colours, edges = shaded_faces(vertices, faces, colour)
    seen = np.flatnonzero(normals[:, 2] > 0)
    seen = seen[np.argsort(corners[seen, :, 2].mean(axis=1), kind="stable")]
    look = {"facecolors": colours[seen], "edgecolors": edges[seen], "linewidths": 0.2}
    axes.add_collection(PolyCollection(corners[seen, :, :2], **look))


def section(vertices, faces, axis, value):
    """Segments (n, 2, 3) in which the plane `axis` = value (um) cuts the triangles.

    The plane is moved by a millionth of a um so that it meets no vertex.
    """
    height = vertices[:, axis] - (value + 1e-6)
    starts, ends = vertices[faces], vertices[np.roll(faces, -1, axis=1)]
    low, high = height[faces], height[np.roll(faces, -1, axis=1)]
    cut = low * high < 0
    share = low / np.where(cut, low - high, 1.0)
    points = starts + share[..., None] * (ends - starts)
    return points[cut].reshape(-1, 2, 3)  # a plane cuts no or two edges of a triangle


def outline(vertices, faces, axis=2, value=0.0):
    """The section with a plane as a closed line (n + 1, 3); the longest, should there be several."""
    segments = section(vertices, faces, axis, value)
    links = {}
    for index, ends in enumerate(np.round(segments, 9)):
        for end in map(tuple, ends):
            links.setdefault(end, []).append(index)
    left, lines = set(range(len(segments))), []
    while left:
        index = min(left)
        here, line = tuple(np.round(segments[index, 0], 9)), []
        while index is not None:
            left.discard(index)
            line.append(here)
            ends = list(map(tuple, np.round(segments[index], 9)))
            here = ends[1] if ends[0] == here else ends[0]
            index = next((other for other in links[here] if other in left), None)
        lines.append([*line, here])
    return np.array(max(lines, key=len)) if lines else np.empty((0, 3))
