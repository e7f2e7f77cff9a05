"""Cases that mean nothing, or too much for the machine: refused with what to change, or labelled as what they
prove. Where the solver is built."""

import json
import os
import re
import resource
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from short_passage import DLD, PASSAGE, needs_solver
from study.planning.points import merged

pytestmark = needs_solver

SHEAR = {
    "scene": "shear",
    "fluid": {"lattice_spacing_um": 1, "relaxation_time": 1},
    "cell": {"shape": "sphere", "radius_um": 3, "mesh_frequency": 3, "local_area_modulus": 1},
    "shear": {"box_um": 20, "reynolds_number": 0.2, "duration": 3},
}
REFUSED = {
    "a Reynolds number of nothing": (
        {"scene": "shear", "shear": {"reynolds_number": 1e-30}},
        "/shear/reynolds_number",
    ),
    "walls faster than sound": ({"scene": "shear", "shear": {"reynolds_number": 100}}, "speed of the walls"),
    "a duration of no step": ({"scene": "shear", "shear": {"duration": 1e-9}}, "at least 20 time steps"),
    "a duration without end": ({"scene": "shear", "shear": {"duration": 1e6}}, "raise /stop/max_steps"),
    "a force that rounds to none": (
        {"scene": "streamlines", "fluid": {"force_density": 1e-300}},
        "at least 1e-12",
    ),
    "a membrane of steel": (
        {"scene": "stretching", "stretching": {"shear_modulus_uN_per_m": 1e9}},
        "times shear modulus times radius",
    ),
    "a force that tears": (
        {"scene": "stretching", "stretching": {"forces_pN": [1e6]}},
        "/stretching/forces_pN",
    ),
    "too many forces": (
        {"scene": "stretching", "stretching": {"forces_pN": [20] * 1001}},
        "at most 1000 forces",
    ),
    "a start out of the world": (
        {"scene": "passage", "cell": {"start": {"gap_position_um": 1e9}}},
        "/cell/start/gap_position_um",
    ),
    "too many nodes of a channel": (
        {"scene": "channel", "fluid": {"lattice_spacing_um": 1e-4}, "channel": {"width_um": 100}},
        "nodes in the box",
    ),
    "too many nodes of a sheared box": (
        {"scene": "shear", "fluid": {"lattice_spacing_um": 0.02}},
        "nodes in the box",
    ),
    "too many nodes around a stretched cell": (
        {"scene": "stretching", "stretching": {"method": "coupled"}, "fluid": {"lattice_spacing_um": 0.005}},
        "nodes in the box",
    ),
}


def solver(folder, case, *words, command="run", **options):
    (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")
    files = ["case.json", "run.h5", "--summary", "summary.json"] if command == "run" else ["case.json"]
    words = [DLD, command, *files, *words]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, **options)


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


@pytest.mark.parametrize(("case", "words"), REFUSED.values(), ids=REFUSED)
def test_nonsense_is_refused(tmp_path, case, words):
    done = solver(tmp_path, case)
    assert done.returncode == 2 and words in done.stderr
    assert not (tmp_path / "run.h5").exists()


def test_the_slip_of_a_magic_parameter_is_said(tmp_path):
    case = {"scene": "streamlines", "fluid": {"magic_parameter": 100}}
    done = solver(tmp_path, case, command="check")
    assert done.returncode == 0 and "slip at the bottom and the top wall" in done.stderr
    assert "use 0.1875 for /fluid/magic_parameter" in done.stderr
    assert "slip" not in solver(tmp_path, {"scene": "streamlines"}, command="check").stderr


def test_the_slip_is_that_of_the_channel(tmp_path):
    case = {"scene": "channel", "fluid": {"magic_parameter": 2, "precision": "double", "force_density": 1e-5}}
    done = solver(tmp_path, case)
    assert done.returncode == 0, done.stderr
    margins = json.loads(solver(tmp_path, case, "--json", command="check").stdout)["margins"]
    (slip,) = (margin["value"] for margin in margins if margin["name"].startswith("slip"))
    # The summary's slip is over the speed in the middle, 3/2 of the mean.
    assert summary_of(tmp_path)["slip"] * 1.5 == pytest.approx(slip, rel=0.02)


@pytest.mark.parametrize(("duration", "status"), [(0.2, "undecided"), (3, "converged")])
def test_a_sheared_capsule_is_converged_when_its_deformation_is_steady(tmp_path, duration, status):
    assert solver(tmp_path, merged(SHEAR, {"shear": {"duration": duration}}), "--force").returncode == 0
    summary = summary_of(tmp_path)
    assert summary["status"] == status
    assert (summary["deformation_change"] < 0.01) == (status == "converged")


def test_a_cell_that_had_no_time_to_deform_is_not_converged(tmp_path):
    # The discocyte is deformed at rest, and keeps its shape for a while.
    case = {**merged(SHEAR, {"shear": {"duration": 0.2}}), "cell": {"mesh_frequency": 5}}
    assert solver(tmp_path, case, "--force").returncode == 0
    summary = summary_of(tmp_path)
    assert summary["deformation_change"] < 0.01 and summary["status"] == "undecided"


def test_a_shear_ends_at_its_last_step(tmp_path):
    case = merged(SHEAR, {"shear": {"duration": 3}, "stop": {"max_steps": 400}})
    done = solver(tmp_path, case)
    assert done.returncode == 2 and "/stop/max_steps" in done.stderr


def test_an_empty_slit_has_no_film(tmp_path):
    case = merged(PASSAGE, {"geometry": {"pillar_shape": "none", "row_shift_um": 0}, "stop": {"max_rows": 1}})
    assert solver(tmp_path, case, "--force").returncode == 0
    summary = summary_of(tmp_path)
    assert summary["film_um"] is None and summary["smallest_film_um"] is None
    with h5py.File(tmp_path / "run.h5") as file:
        assert np.isnan(file["crossings/film_um"][()]).all()
        sizes = [
            np.nanmax(np.abs(column[()]))
            for column in file["crossings"].values()
            if "film" not in column.name
        ]
    assert max(sizes) < 1e9 and "e+29" not in (tmp_path / "summary.json").read_text()


@pytest.mark.parametrize("fluid", [{"force_density": 0.3}, {"force_density": 0.01}])
def test_a_shape_that_a_message_names_is_in_the_file(tmp_path, fluid):
    done = solver(tmp_path, merged(PASSAGE, {"fluid": fluid}), "--force")
    assert done.returncode == 3
    with h5py.File(tmp_path / "run.h5") as file:
        assert ("/membrane/last_good" in done.stderr) == ("membrane/last_good" in file)
        assert ("last_good_step" in summary_of(tmp_path)) == ("membrane/last_good" in file)


def limited(megabytes):
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))


BIG = {
    "streamlines": {"scene": "streamlines", "fluid": {"lattice_spacing_um": 0.1, "force_density": 1e-6}},
    "channel": {
        "scene": "channel",
        "fluid": {"lattice_spacing_um": 0.02},
        "geometry": {"depth_um": 20},
        "channel": {"width_um": 40},
    },
    "shear": {"scene": "shear", "fluid": {"lattice_spacing_um": 0.2}},
    "coupled stretching": {
        "scene": "stretching",
        "stretching": {"method": "coupled"},
        "fluid": {"lattice_spacing_um": 0.1},
        "cell": {"local_area_modulus": 1},
    },
    "static stretching": {"scene": "stretching", "cell": {"mesh_frequency": 200}},
}


@pytest.mark.parametrize("case", BIG.values(), ids=BIG)
def test_a_case_that_does_not_fit_is_refused_before_it_starts(tmp_path, case):
    done = solver(tmp_path, case, "--force", preexec_fn=limited(200))
    assert done.returncode == 2 and "there are 200 MiB (limit of the address space)" in done.stderr
    assert "raise /fluid/lattice_spacing_um" in done.stderr or "lower /cell/mesh_frequency" in done.stderr
    assert not (tmp_path / "run.h5.part").exists()


def test_running_out_of_memory_names_the_need(tmp_path):
    # The estimate is below the limit, but programs and libraries take address space, too.
    done = solver(tmp_path, BIG["streamlines"], "--force", preexec_fn=limited(320))
    assert done.returncode == 2 and "out of memory; it needs about" in done.stderr


def test_the_memory_that_is_told_is_taken(tmp_path):
    case = merged(BIG["streamlines"], {"stop": {"max_steps": 2}, "output": {"flow_field": False}})
    report = json.loads(solver(tmp_path, case, "--json", "--force", command="check").stdout)
    words = [DLD, "run", tmp_path / "case.json", tmp_path / "run.h5", "--force"]
    used = 0  # KiB; not that of wait4, which counts the process of the tests before its program is the solver
    with subprocess.Popen(words, stderr=subprocess.DEVNULL) as running:
        while running.poll() is None:
            found = re.search(r"VmHWM:\s*(\d+)", Path(f"/proc/{running.pid}/status").read_text())
            used = int(found[1]) if found else used
            time.sleep(0.005)
    assert 0.7 < used / 1024 / report["memory_MiB"] < 1.1


@pytest.mark.parametrize(("threads", "code"), [("2,1", 0), ("1", 0), ("0", 2), ("many", 2)])
def test_threads_of_openmp(tmp_path, threads, code):
    case = {"scene": "channel", "fluid": {"lattice_spacing_um": 1.2}, "stop": {"max_steps": 100}}
    environment = os.environ | {"OMP_NUM_THREADS": threads}
    assert solver(tmp_path, case, env=environment).returncode == code
