"""Sections and views of triangulated cells, on a sphere whose answers are known."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from fake_solver import sphere
from study.analysis.surface import draw_from_above, outline, section

CENTRE = np.array([1.0, 2.0, 0.5])


@pytest.fixture(scope="module")
def ball():
    """Vertices (um) and faces of a sphere of radius 3 around CENTRE, wound so that normals point outwards."""
    vertices, faces = sphere(12)
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inwards = np.einsum("ij,ij->i", normals, corners.mean(axis=1)) < 0
    faces[inwards] = faces[inwards][:, ::-1]
    return 3.0 * vertices + CENTRE, faces


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_section_off_the_centre_is_the_smaller_circle(ball, axis):
    cut = section(*ball, axis, CENTRE[axis] + 1.8)
    others = [k for k in range(3) if k != axis]
    distance = np.linalg.norm((cut - CENTRE)[..., others], axis=-1)
    assert distance == pytest.approx(2.4, abs=0.03)
    assert np.allclose(cut[..., axis], CENTRE[axis] + 1.8, atol=1e-5)


def test_section_beside_the_cell_is_empty(ball):
    assert section(*ball, 0, 9.0).shape == (0, 2, 3)
    assert len(outline(*ball, 0, 9.0)) == 0


def test_outline_closes_and_has_the_length_of_the_circle(ball):
    line = outline(*ball, 2, CENTRE[2])
    assert np.allclose(line[0], line[-1], atol=1e-6)
    assert np.linalg.norm(np.diff(line, axis=0), axis=1).sum() == pytest.approx(6 * np.pi, rel=0.01)


def test_from_above_shows_the_upper_half_with_the_top_drawn_last(ball):
    figure, axes = plt.subplots()
    draw_from_above(axes, *ball)
    shown = [path.vertices[:3] for path in axes.collections[0].get_paths()]
    plt.close(figure)
    distance = [np.linalg.norm(corners.mean(axis=0) - CENTRE[:2]) for corners in shown]
    poles = 2 * 48  # faces that the mesh of latitudes squeezes to lines
    assert abs(len(shown) - len(ball[1]) / 2) <= poles
    assert distance[0] > 2.8
    assert distance[-1] < 0.5
