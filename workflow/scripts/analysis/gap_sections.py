"""Extracts the cells of Figure 8 at the crossing that defines D_perp: the membrane, its outline in the mid
plane, and their place in the array."""

from study.analysis.arguments import required_arguments
from study.analysis.runs import load_runs
from study.analysis.surface import outline
from study.analysis.tables import write_table
from study.planning.documents import read_json

SHAPES = ["capillary_number", "vertex", "x_um", "y_um", "z_um"]
LINES = ["capillary_number", "point", "x_um", "y_um"]
NUMBERS = ["capillary_number", "class", "row_shift_um", "d_perp_um", "film_um"]
FACES = ["a", "b", "c"]


def crossing(run):
    """Membrane (n, 3) at the defining crossing relative to the pillar below, um, its faces, and D_perp and
    film of that crossing; None without one."""
    with run.open() as file:
        index = run.summary.get("defining_crossing", -1)
        name = f"membrane/crossing_{index:03d}/vertices"
        if name not in file:
            return None
        table = {key: file[f"crossings/{key}"][index] for key in ("row", "lane", "d_perp_um", "film_um")}
        vertices, faces = file[name][:], file["membrane/faces"][:]
    pitch = run.case["geometry"]["pitch_um"]
    place = [table["row"] * pitch, table["lane"] * pitch + table["row"] * run.row_shift_um, 0.0]
    return vertices - place, faces, table


def main():
    arguments = required_arguments(__doc__, "plan", "runs", "shapes", "outlines", "faces", "numbers")
    wanted = read_json(arguments.plan)["figures"]["gap_cells"]
    shapes, lines, numbers, triangles = [], [], [], []
    for run in load_runs(arguments.plan, arguments.runs, "passages"):
        capillary = run.case["cell"]["capillary_number"]
        chosen = run.labels["sweep"] == wanted["sweep"] and run.row_shift_um == wanted["row_shift_um"]
        if not chosen or capillary not in wanted["capillary_numbers"]:
            continue
        found = crossing(run)
        if found is None:
            continue
        vertices, triangles, table = found
        label = {"capillary_number": capillary}
        for name, points, rows in (
            ("vertex", vertices, shapes),
            ("point", outline(vertices, triangles), lines),
        ):
            for number, point in enumerate(points):
                rows.append(
                    label
                    | {name: number}
                    | dict(zip(("x_um", "y_um", "z_um"), map(float, point), strict=True))
                )
        extent = {name: float(table[name]) for name in ("d_perp_um", "film_um")}
        numbers.append(label | {"class": run.summary["status"], "row_shift_um": run.row_shift_um} | extent)
    styles = dict.fromkeys(["x_um", "y_um", "z_um", "d_perp_um", "film_um"], ".4f")
    write_table(shapes, SHAPES, arguments.shapes, SHAPES[:2], styles)
    write_table(lines, LINES, arguments.outlines, LINES[:2], styles)
    write_table(numbers, NUMBERS, arguments.numbers, NUMBERS[:1], styles)
    faces = [dict(zip(FACES, map(int, face), strict=True)) for face in triangles]
    write_table(faces, FACES, arguments.faces)


main()
