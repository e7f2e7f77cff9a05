"""What a run of the scene `stretching` says: the diameters of the cell at every force."""

import numpy as np

from study.planning.meshes import radius_um


def reference_area(run):
    """Area of the undeformed mesh in units of the cell's radius squared; None without a mesh or a radius."""
    vertices, faces = run.data("membrane/reference"), run.data("membrane/faces")
    radius = radius_um(run.case["cell"])
    if vertices is None or faces is None or radius is None:
        return None
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    return float(area / radius**2)


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
            "mesh_frequency": run.case["cell"].get("mesh_frequency"),
            "area_over_radius_squared": area,
            "status": summary["status"],
            "run": run.id,
        }
