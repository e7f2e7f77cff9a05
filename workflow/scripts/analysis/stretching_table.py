"""Diameters of the stretched cell against the force, for every series and Skalak denominator."""

import numpy as np
from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table

COLUMNS = [
    "method",
    "skalak_denominator",
    "force_pN",
    "axial_um",
    "transverse_um",
    "mesh_frequency",
    "area_over_radius_squared",
    "status",
    "run",
]


def reference_area(run):
    """Area of the undeformed mesh in units of the cell's radius squared, or None without the mesh."""
    vertices, faces = run.data("membrane/reference"), run.data("membrane/faces")
    if vertices is None or faces is None:
        return None
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    return float(area / run.case["cell"]["radius_um"] ** 2)


def rows_of(run):
    """Table rows of one run, one for each force."""
    summary = run.summary
    area = reference_area(run)
    for force, axial, transverse in zip(
        summary.get("force_pN", []),
        summary.get("axial_um", []),
        summary.get("transverse_um", []),
        strict=True,
    ):
        yield {
            "method": run.case["stretching"]["method"],
            "skalak_denominator": run.case["cell"]["skalak_denominator"],
            "force_pN": float(force),
            "axial_um": axial,
            "transverse_um": transverse,
            "mesh_frequency": run.case["cell"]["mesh_frequency"],
            "area_over_radius_squared": area,
            "status": summary["status"],
            "run": run.id,
        }


def main():
    arguments = table_arguments(__doc__)
    runs = load_runs(arguments.plan, arguments.runs, "stretching")
    rows = [row for run in runs for row in rows_of(run)]
    styles = {"axial_um": ".4f", "transverse_um": ".4f", "area_over_radius_squared": ".4f", "force_pN": ".1f"}
    write_table(rows, COLUMNS, arguments.output, ["method", "skalak_denominator", "force_pN"], styles)


main()
