"""Extracts the cell shapes of Figure 3 (undeformed, at a pillar line) and Figure 5 (relaxed, stretched)."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["shape", "vertex", "x_um", "y_um", "z_um"]


def passage_shapes(run):
    """Undeformed shape and the shape at the crossing that defines D_perp (else the last one recorded)."""
    with run.open() as file:
        names = sorted(name for name in file["membrane"] if name.startswith("crossing_"))
        wanted = f"crossing_{run.summary.get('defining_crossing', -1):03d}"
        chosen = f"{wanted if wanted in names else names[-1]}/vertices" if names else "reference"
        shapes = {"undeformed": file["membrane/reference"][:], "deformed": file[f"membrane/{chosen}"][:]}
        return shapes, file["membrane/faces"][:]


def stretched_shapes(run, force_pN):
    """Relaxed shape and the shape at the force nearest to the given one."""
    with run.open() as file:
        nearest = int(np.argmin(np.abs(file["stretching/force_pN"][:] - force_pN)))
        stretched = file[f"membrane/force_{nearest:03d}/vertices"][:]
        return {"relaxed": file["membrane/reference"][:], "stretched": stretched}, file["membrane/faces"][:]


def vertex_rows(shapes):
    """Table rows of named vertex arrays."""
    for shape, vertices in shapes.items():
        for number, (x, y, z) in enumerate(vertices):
            yield {"shape": shape, "vertex": number, "x_um": float(x), "y_um": float(y), "z_um": float(z)}


def main():
    arguments = required_arguments(__doc__, "plan", "runs", "fig03", "fig05", "faces")
    figures = read_json(arguments.plan)["figures"]
    wanted = figures["deformed_cell"]
    passage = next(
        run
        for run in load_runs(arguments.plan, arguments.runs, "passages")
        if run.labels["sweep"] == wanted["sweep"]
        and run.row_shift_um == wanted["row_shift_um"]
        and run.case["cell"]["capillary_number"] == wanted["capillary_number"]
    )
    tweezer = next(
        run
        for run in load_runs(arguments.plan, arguments.runs, "stretching")
        if run.case["stretching"]["method"] == "static"
        and run.case["cell"]["skalak_denominator"] == figures["tweezer_denominators"][-1]
    )
    styles = dict.fromkeys(["x_um", "y_um", "z_um"], ".4f")
    shapes, faces = passage_shapes(passage)
    write_table(vertex_rows(shapes), COLUMNS, arguments.fig03, styles=styles)
    face_sets = {"fig03": faces}
    shapes, face_sets["fig05"] = stretched_shapes(tweezer, figures["tweezer_force_pN"])
    write_table(vertex_rows(shapes), COLUMNS, arguments.fig05, styles=styles)
    rows = [
        {"figure": name, "a": int(a), "b": int(b), "c": int(c)}
        for name, array in face_sets.items()
        for a, b, c in array
    ]
    write_table(rows, ["figure", "a", "b", "c"], arguments.faces)


main()
