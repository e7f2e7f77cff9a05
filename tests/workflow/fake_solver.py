"""A stand-in for the solver's `run` command: writes files of the documented format with made-up, smooth data.

The pipeline's tests run the scripts on it; nothing here is physics. As a program it takes the arguments of
`dld run`, so that the whole pipeline can be tried without the solver (--config dld=...).
"""

import json
import math
import sys
from pathlib import Path

import h5py
import numpy as np


def separation_um(epsilon):
    """A separation law to be found again by the fits: 2 s = 19 eps^0.75."""
    return 9.5 * epsilon**0.75


def sphere(frequency):
    """Vertices and faces of a coarse latitude-longitude sphere of unit radius."""
    rings, sectors = 2 * frequency, 4 * frequency
    theta, phi = np.linspace(0, math.pi, rings + 1), 2 * math.pi * np.arange(sectors) / sectors
    ring = [
        np.stack([np.sin(t) * np.cos(phi), np.sin(t) * np.sin(phi), np.full(sectors, np.cos(t))], 1)
        for t in theta
    ]
    faces = []
    for i in range(rings):
        for j in range(sectors):
            a, b = i * sectors + j, i * sectors + (j + 1) % sectors
            faces += [(a, a + sectors, b), (b, a + sectors, b + sectors)]
    return np.concatenate(ring), np.array(faces, dtype=np.int32)


def put(file, name, values):
    """A dataset with the attributes that every dataset of the solver has."""
    dataset = file.create_dataset(name, data=np.asarray(values))
    dataset.attrs.update({"unit": "1", "description": "made up"})


def streamlines(case, file):
    """Flow field and numbers of the scene `streamlines`."""
    geometry, dx = case["geometry"], case["fluid"]["lattice_spacing_um"]
    nodes = round(geometry["pitch_um"] / dx)
    x = (np.arange(nodes) - nodes // 2) * dx
    gx, gy = np.meshgrid(x, x, indexing="ij")
    r2 = np.maximum(gx**2 + gy**2, 1e-9)
    inside = r2 <= geometry["pillar_radius_um"] ** 2
    u = 1 - 100 * (gx**2 - gy**2) / r2**2
    v = -200 * gx * gy / r2**2
    velocity = 1e-3 * np.where(inside[..., None], 0, np.stack([u, v], -1))
    epsilon = geometry["row_shift_um"] / geometry["pitch_um"]
    s = separation_um(epsilon) + 0.05 * dx**2
    put(file, "flow/x_um", x)
    put(file, "flow/y_um", x)
    put(file, "flow/velocity", velocity)
    put(file, "flow/solid", inside.astype(np.uint8))
    line = np.stack([np.linspace(0, 22, 30), 10 + s + np.linspace(0, 1, 30)], 1)
    put(file, "separatrix/downstream", line)
    put(file, "separatrix/upstream", -line)
    force = case["fluid"]["force_density"]
    return "converged", {
        "row_shift_um": geometry["row_shift_um"],
        "epsilon": epsilon,
        "dx_um": dx,
        "separation_um": s,
        "separation_upper_um": s + 0.001,
        "resistance_Pa_s_per_m2": 8.8e8 * (1 + 0.02 * dx**2),
        "lateral_velocity_ratio": 0.01,
        "mean_velocity": 40 * force * (1 + 0.1 * force),
        "superficial_velocity": 28 * force,
        "reynolds_number": 5000 * force,
        "reynolds_number_superficial": 3500 * force,
        "reynolds_number_slit": 8000 * force,
        "density_variation": 1e-3,
        "lateral_force_ratio": 0.0,
    }


def cell(case):
    """A flattened sphere of the cell's radius."""
    vertices, faces = sphere(case["cell"]["mesh_frequency"])
    return vertices * case["cell"]["radius_um"] * np.array([1, 1, 0.3]), faces


def stretching(case, file):
    """Ellipsoids for the scene `stretching`."""
    vertices, faces = cell(case)
    forces = np.array(case["stretching"]["forces_pN"], float)
    softness = case["cell"]["skalak_denominator"] / 12
    axial = 7.8 + 9 * (1 - np.exp(-forces * softness / 70))
    transverse = 7.8 - 3.5 * (1 - np.exp(-forces * softness / 50))
    put(file, "membrane/reference", vertices)
    put(file, "membrane/faces", faces)
    for name, values in (("force_pN", forces), ("axial_um", axial), ("transverse_um", transverse)):
        put(file, f"stretching/{name}", values)
    for number, scale in enumerate(np.stack([axial / 7.8, transverse / 7.8, np.ones_like(forces)], 1)):
        put(file, f"membrane/force_{number:03d}/vertices", vertices * scale)
    return "converged", {
        "skalak_denominator": case["cell"]["skalak_denominator"],
        "mesh_frequency": case["cell"]["mesh_frequency"],
        "method": case["stretching"]["method"],
        "force_pN": list(forces),
        "axial_um": list(axial),
        "transverse_um": list(transverse),
    }


#: Modulus that a fold feels over the stated one, by bending law.
FOLD_RATIOS = {"hinge_sphere": 3.0, "hinge_half": 1.5, "hinge_sheet": 1.0, "mean_curvature": 1.0}


def softness(case):
    """Capillary number with the stiffness of the conventions in it: the stated one by default."""
    cell = case["cell"]
    folds = FOLD_RATIOS["hinge_half"] / FOLD_RATIOS[cell["bending_law"]]
    return cell["capillary_number"] * cell["skalak_denominator"] / 12 * folds


def critical_row_shift_um(case):
    """The made-up boundary: the paper's law, lower on finer lattices and for stiffer conventions."""
    shift = 2.9 + 5.4 * math.exp(-1.72 * softness(case)) + 0.5 * case["fluid"]["lattice_spacing_um"]
    return shift + 0.3 * (case["fluid"]["lateral_flow"] == "blocked")


def label_of(case):
    """Class of the made-up trajectory; cells close to the boundary stay undecided, very soft ones fail."""
    capillary, shift = case["cell"]["capillary_number"], case["geometry"]["row_shift_um"]
    distance = critical_row_shift_um(case) - shift
    if capillary > 2.2 and shift > 8:
        return "diverged"
    if abs(distance) < 0.01:
        return "undecided"
    return "displaced" if distance > 0 else "zigzag"


def crossings(case, file, label, rows):
    """Crossings of the pillar lines: a creep to the fixed point, or falls at every third line."""
    capillary, number = case["cell"]["capillary_number"], np.arange(rows)
    bump = np.where((label == "zigzag") & (number % 3 == 2), 0, 1)
    extent = 7 - 2.5 * min(softness(case), 1.5) + 0.1 * np.exp(-number)
    columns = {
        "row": number,
        "step": number * (2000 + round(2000 * capillary)),
        "y_um": 13 + number * case["geometry"]["row_shift_um"] * bump.mean(),
        "gap_position_um": 3 + np.exp(-number) - 0.2 * (number % 3) * (label == "zigzag"),
        "lane": -np.cumsum(1 - bump),
        "bump": bump,
        "d_perp_um": extent,
        "d_perp_at_centre_um": extent - 0.1,
        "film_um": 0.5 + 0 * number,
        "min_face_ratio": 0.7 + 0 * number,
        "height_um": 3 + 0 * number,
        "speed_um_per_step": 32 / (2000 + round(2000 * capillary)) + 0 * number,
    }
    for name, values in columns.items():
        put(file, f"crossings/{name}", np.asarray(values, float))
    return extent[-1]


def passage(case, file):
    """A made-up trajectory: displaced below a line in the plane of row shift and capillary number."""
    label = label_of(case)
    if label == "diverged":
        return label, {"failing_quantity": "speed", "failing_value": 0.4, "failing_step": 17, "steps": 17}
    vertices, faces = cell(case)
    pitch, shift = case["geometry"]["pitch_um"], case["geometry"]["row_shift_um"]
    rows = case["stop"]["max_rows"] + 1 if case["stop"]["when"] == "rows" else 8
    x = np.linspace(-pitch / 2, (rows - 0.5) * pitch, rows * 50)
    slope = shift / pitch if label == "displaced" else 0.0
    y = 15 + slope * x + 1.5 * np.sin(2 * math.pi * x / pitch)
    extents = ["extent_x_um", "extent_y_um", "extent_z_um"]
    names = [*extents, "area_change", "volume_change", "min_face_ratio", "film_um"]
    columns = {"step": np.arange(len(x)) * 40, "x_um": x, "y_um": y, "z_um": 0 * x}
    for name, values in (columns | dict.fromkeys(names, 0 * x + 1)).items():
        put(file, f"trajectory/{name}", values)
    put(file, "membrane/faces", faces)
    put(file, "membrane/reference", vertices)
    for row in range(rows):
        put(file, f"membrane/crossing_{row:03d}/vertices", vertices * np.array([1.1, 0.8, 1.0]))
    for number in range(rows * case["output"]["snapshots_per_row"]):
        name = f"membrane/snapshot_{number:03d}"
        put(file, f"{name}/vertices", vertices + np.array([x[number], y[number], 0.0]))
        file[name].attrs["step"] = 40 * number
    extent = crossings(case, file, label, rows)
    summary = {"d_perp_um": extent, "d_perp_at_centre_um": extent - 0.1, "centre_um": 3.0, "film_um": 0.5}
    summary |= {"area_change": 0.002, "volume_change": 1e-6, "min_face_ratio": 0.7}
    summary |= {"max_local_area_strain": 0.05, "density_variation": 1e-3, "smallest_film_um": 0.4}
    summary |= {"tightest_margin": "made up", "used_share_of_margin": 1e3 * case["fluid"]["force_density"]}
    summary |= {"crossings": rows, "zigs": 2 * (label == "zigzag"), "defining_crossing": rows - 1}
    return label, summary | {"capillary_number": case["cell"]["capillary_number"]}


SCENES = {"streamlines": streamlines, "stretching": stretching, "passage": passage}


def run(case, out, summary_path):
    """Writes the HDF5 file and the summary of a case; returns the exit status."""
    with h5py.File(out, "w") as file:
        status, summary = SCENES[case["scene"]](case, file)
        file.attrs["status"] = status
        file.attrs["provenance"] = json.dumps({"git_commit": "made up"})
    spacing = case["fluid"]["lattice_spacing_um"]
    cost = {"steps": 1000, "node_updates": round(1e6 * (0.4 / spacing) ** 3), "membrane_updates": 10000}
    summary = {"scene": case["scene"], "status": status} | cost | summary
    Path(summary_path).write_text(json.dumps(summary), encoding="utf-8")
    return 3 if status == "diverged" else 0


def resolve(cases_path, answers_path):
    """Writes the answers to a list of cases: none is refused, each takes a second."""
    cases = json.loads(Path(cases_path).read_text(encoding="utf-8"))
    answer = {"problems": [], "expected_cost": {"seconds_on_one_core": 1.0}}
    Path(answers_path).write_text(json.dumps([answer] * len(cases)), encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1] == "resolve":
        sys.exit(resolve(*sys.argv[2:4]))
    _, case_path, out_path = sys.argv[1:4]
    case = json.loads(Path(case_path).read_text(encoding="utf-8"))
    sys.exit(run(case, out_path, sys.argv[sys.argv.index("--summary") + 1]))
