"""The pillar of a case from the outline in a drawing: DXF (read by ezdxf) or GDSII (read by gdstk).

Lengths are converted to um by the unit that the file states. The drawing may hold one closed outline on the
layer (DXF) or in the cell and layer (GDSII) that is read; curves become polygons that leave them by at most
the tolerance. The origin of the outline is the pillar's centre.

Try: python outline_from_cad.py pillar.dxf --output pillar.json
"""

import argparse
import json
import math
import sys
from pathlib import Path

UM_PER_METRE = 1e6
MICRON = 13  # code of the unit in the header of a DXF file
DXF_UNITS_UM = {"um": 1.0, "mm": 1e3, "m": 1e6, "inch": 25400.0}
ORIGINS = ("box", "centroid", "drawing")


def area(points):
    """Area of a polygon, positive if it is counter-clockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1], strict=True)) / 2


def centroid(points):
    """Centre of mass of a polygon's area."""
    x = y = 0.0
    for a, b in zip(points, points[1:] + points[:1], strict=True):
        cross = a[0] * b[1] - b[0] * a[1]
        x += (a[0] + b[0]) * cross
        y += (a[1] + b[1]) * cross
    return x / (6 * area(points)), y / (6 * area(points))


def dxf_outlines(path, layer, unit, tolerance_um):
    """Closed outlines of a DXF drawing by layer, in um: closed entities, and loops of lines and arcs."""
    import ezdxf
    from ezdxf import edgeminer, edgesmith, units
    from ezdxf.path import make_path

    try:
        drawing = ezdxf.readfile(path)
    except (OSError, ezdxf.DXFError) as error:
        raise ValueError(f"{path}: no DXF drawing: {error}") from None
    if unit is None and drawing.units == 0:
        raise ValueError(f"{path}: the drawing states no unit; give --unit {' or '.join(DXF_UNITS_UM)}")
    um = DXF_UNITS_UM[unit] if unit else units.conversion_factor(drawing.units, MICRON)
    by_layer = {}
    for entity in drawing.modelspace():
        if layer is None or entity.dxf.layer == layer:
            by_layer.setdefault(entity.dxf.layer, []).append(entity)
    outlines = {}
    for name, entities in by_layer.items():
        closed = [entity for entity in entities if edgesmith.is_closed_entity(entity)]
        edges = list(edgesmith.edges_from_entities_2d(e for e in entities if e not in closed))
        loops = edgeminer.find_all_loops(edgeminer.Deposit(edges)) if edges else []
        paths = [make_path(entity) for entity in closed] + [
            edgesmith.path2d_from_chain(loop) for loop in loops
        ]
        outlines[name] = [
            [(p.x * um, p.y * um) for p in curve.flattening(tolerance_um / um, segments=4)] for curve in paths
        ]
    return outlines


def gds_outlines(path, layer, cell_name):
    """Polygons of a GDSII file by layer, in um; of the only top cell or of the one of that name."""
    import gdstk

    try:
        library = gdstk.read_gds(path)
    except (OSError, RuntimeError) as error:
        raise ValueError(f"{path}: no GDSII file: {error}") from None
    cells = library.cells if cell_name else library.top_level()
    chosen = [cell for cell in cells if isinstance(cell, gdstk.Cell) and cell_name in (None, cell.name)]
    if len(chosen) != 1:
        names = ", ".join(sorted(cell.name for cell in library.cells)) or "no cell"
        raise ValueError(f"{path}: --cell has to name one cell; the file holds {names}")
    um = library.unit * UM_PER_METRE
    outlines = {}
    for polygon in chosen[0].get_polygons():
        if layer is None or str(polygon.layer) == layer:
            points = [(float(x) * um, float(y) * um) for x, y in polygon.points]
            outlines.setdefault(str(polygon.layer), []).append(points)
    return outlines


def only_one(outlines, path):
    """The one outline of the drawing; a ValueError that lists what there is otherwise."""
    found = [(layer, points) for layer, group in outlines.items() for points in group]
    if len(found) == 1:
        return found[0][1]

    def width(points):
        return max(x for x, _ in points) - min(x for x, _ in points)

    listed = "; ".join(
        f"layer {layer}: {len(points)} points, {width(points):.4g} um wide" for layer, points in found
    )
    raise ValueError(
        f"{path}: {len(found)} closed outlines, one is needed"
        + (f" ({listed}); choose a layer with --layer, or leave one pillar in the drawing" if found else "")
    )


def tidy(points, origin):
    """Counter-clockwise points about the centre, each once, in um to six decimals."""
    if area(points) < 0:
        points = points[::-1]
    if origin == "centroid":
        x0, y0 = centroid(points)
    elif origin == "box":
        x0, y0 = (0.5 * (min(p[k] for p in points) + max(p[k] for p in points)) for k in (0, 1))
    else:
        x0 = y0 = 0.0
    # A zero is added so that no -0.0 is left.
    moved = [[round(x - x0, 6) + 0.0, round(y - y0, 6) + 0.0] for x, y in points]
    return [p for k, p in enumerate(moved) if p != moved[k - 1]]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("drawing", type=Path, help="file that ends in .dxf, .gds or .gds2")
    parser.add_argument("--output", type=Path, required=True, help="JSON file of the pillar")
    parser.add_argument("--layer", help="layer that holds the outline")
    parser.add_argument("--cell", help="cell of a GDSII file, when it has several")
    parser.add_argument("--unit", choices=DXF_UNITS_UM, help="unit of a DXF drawing that states none")
    parser.add_argument(
        "--origin",
        choices=ORIGINS,
        default="box",
        help="what is the pillar's centre: the middle of "
        "the box around it, its centre of mass, or the origin of the drawing",
    )
    parser.add_argument("--tolerance-um", type=float, default=0.02, help="of the polygon of a curve")
    parser.add_argument("--corner-radius-um", type=float, default=0.0, help="by which corners are rounded")
    arguments = parser.parse_args()
    if not (arguments.tolerance_um > 0 and math.isfinite(arguments.tolerance_um)):
        parser.error("--tolerance-um has to be above 0")
    try:
        kind = arguments.drawing.suffix.lower()
        if kind == ".dxf":
            outlines = dxf_outlines(
                arguments.drawing, arguments.layer, arguments.unit, arguments.tolerance_um
            )
        elif kind in (".gds", ".gds2"):
            outlines = gds_outlines(arguments.drawing, arguments.layer, arguments.cell)
        else:
            raise ValueError(f"{arguments.drawing}: the name has to end in .dxf, .gds or .gds2")
        points = tidy(only_one(outlines, arguments.drawing), arguments.origin)
    except ValueError as error:
        sys.exit(str(error))
    pillar = {"shape": "outline", "points_um": points, "corner_radius_um": arguments.corner_radius_um}
    arguments.output.write_text(json.dumps(pillar) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
