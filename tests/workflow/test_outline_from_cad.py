"""Pillars from drawings: unit, orientation, origin and curves of DXF and GDSII, and what is refused."""

import json
import math
import subprocess
import sys
from pathlib import Path

import ezdxf
import gdstk
import pytest
from ezdxf import units
from study.planning.validation import violations

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "workflow/scripts/planning/outline_from_cad.py"
CORNERS = [(0, 0), (12, 0), (12, 4), (4, 4), (4, 10), (0, 10)]
CENTRED = [[x - 6, y - 5] for x, y in CORNERS]


def convert(drawing, *options):
    """The pillar of a drawing, and what was printed if there is none."""
    output = drawing.with_suffix(".json")
    done = subprocess.run(
        [sys.executable, SCRIPT, drawing, "--output", output, *options], capture_output=True, text=True
    )
    return (json.loads(output.read_text()) if done.returncode == 0 else None), done.stderr


def dxf(path, unit, draw):
    drawing = ezdxf.new(units=unit)
    draw(drawing.modelspace())
    drawing.saveas(path)
    return path


def same_polygon(points, expected):
    """The points, whichever comes first."""
    start = min(range(len(points)), key=lambda k: math.dist(points[k], expected[0]))
    turned = points[start:] + points[:start]
    return len(points) == len(expected) and all(
        math.dist(a, b) < 1e-5 for a, b in zip(turned, expected, strict=True)
    )


@pytest.mark.parametrize(
    ("unit", "per_um"), [(13, 1), (units.MM, 1e-3), (units.M, 1e-6), (units.IN, 1 / 25400)]
)
def test_the_unit_of_a_dxf_drawing_is_its_own(tmp_path, unit, per_um):
    corners = [(x * per_um, y * per_um) for x, y in CORNERS]
    pillar, _ = convert(dxf(tmp_path / "a.dxf", unit, lambda m: m.add_lwpolyline(corners, close=True)))
    assert same_polygon(pillar["points_um"], CENTRED)


def test_loops_of_lines_are_outlines_and_clockwise_ones_are_turned(tmp_path):
    def draw(model):
        for a, b in zip(CORNERS[::-1], CORNERS[::-1][1:] + CORNERS[-1:], strict=True):
            model.add_line(a, b)

    pillar, _ = convert(dxf(tmp_path / "a.dxf", 13, draw))
    assert same_polygon(pillar["points_um"], CENTRED)


def test_curves_keep_to_the_tolerance(tmp_path):
    drawing = dxf(tmp_path / "a.dxf", units.MM, lambda m: m.add_circle((3, 2), 0.008))
    for tolerance in (0.2, 0.02):
        pillar, _ = convert(drawing, "--tolerance-um", str(tolerance))
        points = pillar["points_um"]
        # Arcs are read as cubic Bezier curves, which leave a circle by 2.7e-4 of its radius.
        assert all(abs(math.hypot(x, y) - 8) < 3e-3 for x, y in points)
        middles = [math.dist(a, b) / 2 for a, b in zip(points, points[1:] + points[:1], strict=True)]
        assert 8 - math.sqrt(64 - max(middles) ** 2) <= tolerance
    assert len(points) < 120


def test_gdsii_has_its_unit_and_its_layers(tmp_path):
    library = gdstk.Library(unit=1e-9, precision=1e-12)
    cell = library.new_cell("POST")
    cell.add(gdstk.Polygon([(1000 * x, 1000 * y) for x, y in CORNERS], layer=3))
    cell.add(gdstk.rectangle((0, 0), (90000, 90000), layer=4))
    library.write_gds(tmp_path / "a.gds")
    pillar, _ = convert(tmp_path / "a.gds", "--layer", "3", "--corner-radius-um", "0.5")
    assert same_polygon(pillar["points_um"], CENTRED)
    assert pillar["corner_radius_um"] == 0.5
    pillar, said = convert(tmp_path / "a.gds")
    assert pillar is None
    assert "2 closed outlines" in said and "--layer" in said and "90 um wide" in said


@pytest.mark.parametrize(("origin", "first"), [("drawing", (0, 0)), ("centroid", (-14 / 3, -11 / 3))])
def test_the_origin_can_be_chosen(tmp_path, origin, first):
    drawing = dxf(tmp_path / "a.dxf", 13, lambda m: m.add_lwpolyline(CORNERS, close=True))
    pillar, _ = convert(drawing, "--origin", origin)
    assert min(math.dist(p, first) for p in pillar["points_um"]) < 1e-5


def test_what_is_no_outline_is_refused_with_advice(tmp_path):
    unitless = dxf(tmp_path / "a.dxf", 0, lambda m: m.add_circle((0, 0), 8))
    assert "--unit" in convert(unitless)[1]
    assert convert(unitless, "--unit", "um")[0] is not None
    empty = dxf(tmp_path / "b.dxf", 13, lambda m: m.add_line((0, 0), (1, 0)))
    assert "0 closed outlines" in convert(empty)[1]
    (tmp_path / "c.dxf").write_text("nothing")
    assert "no DXF drawing" in convert(tmp_path / "c.dxf")[1]
    assert "--cell" in convert_empty_gds(tmp_path)
    assert "has to end in" in convert(tmp_path / "d.svg")[1]


def convert_empty_gds(folder):
    gdstk.Library().write_gds(folder / "e.gds")
    return convert(folder / "e.gds")[1]


def test_the_pillar_is_one_of_the_case_schema(tmp_path):
    drawing = dxf(tmp_path / "a.dxf", 13, lambda m: m.add_lwpolyline(CORNERS, close=True))
    schema = json.loads((ROOT / "workflow/schemas/case.schema.json").read_text())
    case = {"scene": "streamlines", "geometry": {"pillar": convert(drawing)[0]}}
    assert list(violations(case, schema)) == []
