"""The files that a run leaves, as others read them: XDMF by VTK and meshio, HDF5 against docs/output.md."""

import json
import re
import subprocess
from pathlib import Path

import h5py
import meshio
import numpy as np
import pytest
import vtk
from meshio.xdmf import TimeSeriesReader
from short_passage import DLD, PASSAGE, needs_solver
from vtk.util.numpy_support import vtk_to_numpy

ROOT = Path(__file__).resolve().parents[2]
pytestmark = needs_solver

COARSE = {"geometry": {"row_shift_um": 6.4}, "fluid": PASSAGE["fluid"]}
CAPSULE = {"shape": "sphere", "radius_um": 4, "mesh_frequency": 4, "local_area_modulus": 1}
CASES = {
    "passage": PASSAGE | {"output": {"snapshots_per_row": 2}},
    "streamlines": COARSE | {"scene": "streamlines"},
    "stretching": {
        "scene": "stretching",
        "cell": {"mesh_frequency": 4},
        "stretching": {"forces_pN": [0, 50]},
    },
    "shear": {
        "scene": "shear",
        "fluid": {"lattice_spacing_um": 1},
        "cell": CAPSULE,
        "shear": {"box_um": 16, "duration": 0.2},
    },
    "channel": {"scene": "channel", "fluid": {"lattice_spacing_um": 0.8}},
}
#: A name of which every character but the colon could be taken for XML or for the end of the name.
NAME = "a run & <1> \"of\" 'many'"


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Output file of a short run of every scene."""
    made = {}
    for scene, case in CASES.items():
        folder = tmp_path_factory.mktemp(scene)
        (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")
        made[scene] = folder / f"{NAME}.h5"
        command = [DLD, "run", folder / "case.json", made[scene], "--summary", folder / "summary.json"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    return made


def vtk_blocks(path, time=None):
    """Leaves of what VTK reads, by name ('' if the file has one grid), and the times of the file."""
    messages = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(messages)
    reader = vtk.vtkXdmfReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    steps, information = vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS(), reader.GetOutputInformation(0)
    times = [information.Get(steps, i) for i in range(information.Length(steps))]
    reader.Update() if time is None else reader.UpdateTimeStep(time)
    assert messages.GetOutput() == ""
    leaves = {}

    def collect(data, name):
        if not data.IsA("vtkMultiBlockDataSet"):
            leaves[name] = data
            return
        for i in range(data.GetNumberOfBlocks()):
            collect(data.GetBlock(i), data.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()))

    collect(reader.GetOutputDataObject(0), "")
    return leaves, times


def vtk_arrays(data):
    """All values of a VTK grid by name, its points and its cells (n, corners) among them."""
    arrays = {
        attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i))
        for attributes in (data.GetPointData(), data.GetCellData())
        for i in range(attributes.GetNumberOfArrays())
    }
    corners = data.GetCell(0).GetNumberOfPoints()
    cells = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, corners)
    return arrays | {"points": vtk_to_numpy(data.GetPoints().GetData()), "cells": cells}


def meshio_arrays(mesh):
    """The same for a mesh that meshio has read."""
    cell_data = {name: values[0] for name, values in mesh.cell_data.items()}
    return mesh.point_data | cell_data | {"points": mesh.points, "cells": mesh.cells[0].data}


def in_file(file, names):
    return {name: file[dataset][()] for name, dataset in names.items()}


def same(read, wanted):
    """Every array of the file, bit for bit and of the same shape."""
    assert set(read) == set(wanted)
    for name, values in wanted.items():
        assert read[name].shape == values.shape, name
        assert np.array_equal(read[name], values), name


FLOW = {
    "points": "flow/around/points_um",
    "cells": "flow/around/quads",
    "velocity_mm_per_s": "flow/around/velocity_mm_per_s",
    "solid": "flow/around/solid",
}
PILLARS = {"points": "pillars/points_um", "cells": "pillars/triangles"}


def shapes_of(file):
    """Groups of the membrane's shapes in the order of time, one for each time."""
    groups = [group for group in file["membrane"].values() if isinstance(group, h5py.Group)]
    by_time = {group.attrs.get("time_s", group.attrs.get("force_pN")): group for group in groups}
    return dict(sorted(by_time.items()))


def shape_arrays(group):
    """What a reader has to find of one shape, under the names of the file."""
    values = {name: dataset[()] for name, dataset in group.items() if name != "vertices"}
    vertices = group["vertices"][()]
    return values | {"position_um": vertices, "points": vertices, "cells": group.parent["faces"][()]}


@pytest.mark.parametrize("scene", ["passage", "streamlines"])
def test_vtk_and_meshio_read_flow_and_pillars(files, scene):
    path = files[scene]
    leaves, _ = vtk_blocks(path.with_suffix(".xdmf"))
    with h5py.File(path) as file:
        for name, datasets in (("flow", FLOW), ("pillars", PILLARS)):
            alone = path.with_suffix(f".{name}.xdmf")
            wanted = in_file(file, datasets)
            same(vtk_arrays(leaves[name]), wanted)
            same(vtk_arrays(vtk_blocks(alone)[0][""]), wanted)
            same(meshio_arrays(meshio.read(alone)), wanted)


@pytest.mark.parametrize("scene", ["passage", "stretching"])
def test_vtk_and_meshio_read_every_shape_of_the_membrane(files, scene):
    path = files[scene].with_suffix(".xdmf")
    with h5py.File(files[scene]) as file, TimeSeriesReader(path) as series:
        shapes = shapes_of(file)
        _, times = vtk_blocks(path)
        assert times == pytest.approx(list(shapes), rel=1e-11)
        points, cells = series.read_points_cells()
        assert len(shapes) == series.num_steps > 1
        for number, (time, group) in enumerate(zip(times, shapes.values(), strict=True)):
            wanted = shape_arrays(group)
            assert {"mean_tension_uN_per_m", "shear_tension_uN_per_m", "area_strain"} < set(wanted)
            leaves, _ = vtk_blocks(path, time)
            same(vtk_arrays(leaves["membrane" if scene == "passage" else ""]), wanted)
            at, on_nodes, on_cells = series.read_data(number)
            assert at == time
            mesh = meshio.Mesh(points, cells, on_nodes, on_cells)
            mesh.points = on_nodes["position_um"]
            same(meshio_arrays(mesh), wanted)


def test_times_are_steps_in_seconds(files):
    with h5py.File(files["passage"]) as file:
        step_s = json.loads(file.attrs["physical"])["time_step_s"]
        for time, group in shapes_of(file).items():
            assert time == pytest.approx(group.attrs["step"] * step_s, rel=1e-12)
        trajectory = file["trajectory/step"]
        assert trajectory.attrs["physical_per_unit"] == step_s
        assert trajectory.attrs["physical_unit"] == "s"


def test_the_flow_is_where_the_cell_is_and_the_pillars_are_where_it_is_solid(files):
    with h5py.File(files["passage"]) as file:
        case, shape = json.loads(file.attrs["case"]), file["membrane/final/vertices"][()]
        pitch, shift = case["geometry"]["pitch_um"], case["geometry"]["row_shift_um"]
        radius, spacing = case["geometry"]["pillar_radius_um"], case["fluid"]["lattice_spacing_um"]
        points, around = file["flow/around/points_um"][()], file["flow/around/velocity_mm_per_s"][()]
        assert shape[:, 0].mean() > 1.5 * pitch, "the cell is rows away from the pillar of the unit cell"
        assert (np.abs(points - shape.mean(0))[:, :2].max(0) < 0.55 * pitch).all()
        # Every node shows the velocity of the node of the unit cell that it repeats.
        column = np.floor((points[:, 0] - file["flow/x_um"][0]) / pitch + 1e-9)
        i = np.rint((points[:, 0] - column * pitch - file["flow/x_um"][0]) / spacing).astype(int)
        y = (points[:, 1] - column * shift - file["flow/y_um"][0]) / spacing
        j = np.rint(y).astype(int) % file["flow/y_um"].size
        velocity = file["flow/velocity"]
        assert velocity.attrs["physical_unit"] == "mm/s"
        expected = velocity[()][i, j] * velocity.attrs["physical_per_unit"]
        assert around[:, :2] == pytest.approx(expected, rel=1e-12)
        assert not around[:, 2].any()
        # The walls that are drawn stand around the solid nodes.
        centres, walls = file["pillars/centres_um"][()], file["pillars/points_um"][()]

        def distance(xy):
            return np.sqrt(((xy[:, None] - centres[None]) ** 2).sum(-1)).min(1) - radius

        assert np.abs(distance(walls[:, :2])).max() < 1e-6
        solid = file["flow/around/solid"][()] > 0
        assert solid.any() and distance(points[solid, :2]).max() < 1e-6
        drawn = np.abs(shape[:, :2].mean(0) - centres).max(1).min()
        assert drawn < pitch


def test_distance_and_strain_are_those_of_the_vertices(files):
    with h5py.File(files["passage"]) as file:
        faces, centres = file["membrane/faces"][()], file["pillars/centres_um"][()]

        def areas(x):
            return np.linalg.norm(np.cross(*(x[faces[:, k]] - x[faces[:, 0]] for k in (1, 2))), axis=1)

        rest = areas(file["membrane/reference"][()])
        for group in shapes_of(file).values():
            x = group["vertices"][()]
            assert group["area_strain"][()] == pytest.approx(areas(x) / rest - 1, abs=1e-6)
            nearest = np.sqrt(((x[:, None, :2] - centres[None]) ** 2).sum(-1)).min(1) - 10
            assert group["pillar_distance_um"][()] == pytest.approx(nearest, abs=1e-4)


def test_a_passage_has_s_and_its_line(files):
    with h5py.File(files["passage"]) as file:
        s, line = json.loads(file.attrs["summary"])["separation_um"], file["separatrix/downstream"]
        assert 0 < s < 12
        assert line.attrs["separation_um"] == s
        x, y = line[()].T
        assert np.interp(0.0, x, y) == pytest.approx(10 + s, abs=1e-3)


def test_a_summary_has_physical_values_beside_those_in_lattice_units(files):
    for scene in ("passage", "streamlines", "channel"):
        with h5py.File(files[scene]) as file:
            summary, scale = (json.loads(file.attrs[name]) for name in ("summary", "physical"))
        physical = summary["si"]
        for name in ("mean_velocity", "superficial_velocity", "max_speed"):
            if name in summary:
                factor = scale["velocity_mm_per_s_per_lu"]
                assert physical[f"{name}_mm_per_s"] == pytest.approx(summary[name] * factor, rel=1e-12)
        assert physical["time_step_s"] == scale["time_step_s"]


def documented():
    """Rows of the tables of data sets: {name: (shape, unit, physical unit)}."""
    text = (ROOT / "docs/output.md").read_text(encoding="utf-8")
    row = re.compile(r"^\| `(/\S+)` \| \((.*?)\) \| (\S+) \| (\S*) ?\| .+ \|$", re.MULTILINE)
    return {name: (shape, unit, physical) for name, shape, unit, physical in row.findall(text)}


def pattern(name):
    return re.compile(re.escape(name).replace("<shape>", "(crossing_|snapshot_|force_)?[a-z0-9_]+") + "$")


def check_shape(symbols, shape, sizes, name):
    """Numbers are as they are; a symbol has one value in a file."""
    symbols = [symbol for symbol in symbols.replace(" ", "").split(",") if symbol]
    assert len(symbols) == len(shape), name
    for symbol, size in zip(symbols, shape, strict=True):
        wanted = int(symbol) if symbol.isdigit() else sizes.setdefault(symbol, size)
        assert size == wanted, (name, symbol)


def datasets_of(file):
    """Every data set of a file by its full name."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset):
            found[f"/{name}"] = item

    file.visititems(visit)
    return found


def test_every_data_set_is_documented_and_every_documented_one_is_there(files):
    rows, seen = documented(), set()
    assert len(rows) > 40
    for path in files.values():
        sizes = {}
        with h5py.File(path) as file:
            for name, dataset in datasets_of(file).items():
                match = [row for row in rows if pattern(row).match(name)]
                assert len(match) == 1, f"{name}: rows {match} of docs/output.md"
                shape, unit, physical = rows[match[0]]
                check_shape(shape, dataset.shape, sizes, name)
                assert dataset.attrs["unit"] == unit, name
                assert dataset.attrs.get("physical_unit", "") == physical, name
                assert dataset.attrs["description"], name
                seen.add(match[0])
    assert seen == set(rows)


def test_attributes_of_the_root_are_documented(files):
    text = (ROOT / "docs/output.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE))
    for path in files.values():
        with h5py.File(path) as file:
            assert set(file.attrs) == listed
