"""Cells from mesh files in a study. The study names a file in params/cells; the case of a run names it from
the run's folder, where the solver reads it; the run's identity has its content in place of its name."""

import hashlib
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[3]
CELLS = "params/cells"
#: From the folder of a run, results/runs/<identity>, to the root.
TO_ROOT = "../../../"


def _mesh_of(case):
    """The mesh file that a case or a part of one names; None for another shape."""
    cell = case.get("cell", {})
    return cell.get("mesh_file") if cell.get("shape") == "mesh" else None


def _with_mesh(case, name):
    return case | {"cell": case["cell"] | {"mesh_file": name}}


def placed(case):
    """The case as a run's folder has it; a ValueError where the file is not one of params/cells."""
    name = _mesh_of(case)
    if name is None or name.startswith(TO_ROOT):
        return case
    path = PurePosixPath(CELLS) / name
    if PurePosixPath(name).is_absolute() or ".." in path.parts:
        raise ValueError(f"/cell/mesh_file = {name}: allowed is a file below {CELLS}; copy the mesh to there")
    if not (ROOT / path).is_file():
        raise ValueError(f"/cell/mesh_file = {name}: there is no such file in {CELLS}")
    return _with_mesh(case, f"{TO_ROOT}{path}")


def _file(name):
    """The file of a placed case."""
    return ROOT / name.removeprefix(TO_ROOT)


def anywhere(case):
    """The case for a solver that reads it from any folder."""
    name = _mesh_of(case)
    if name is None or not name.startswith(TO_ROOT):
        return case
    return _with_mesh(case, str(_file(name)))


def identified(case):
    """The case with the checksum of its mesh in place of the file's name."""
    name = _mesh_of(case)
    if name is None:
        return case
    return _with_mesh(case, f"sha256:{hashlib.sha256(_file(name).read_bytes()).hexdigest()}")


def radius_um(cell):
    """Radius r that scales Ca, um: that of the cell's values, or of its own size; None for a mesh, of which
    the solver takes it from the file."""
    if "radius_um" in cell:
        return cell["radius_um"]
    return max(cell["semi_axes_um"][:2]) if cell["shape"] == "ellipsoid" else None
