"""A cell from a mesh file in a study: found in params/cells, named by its content, read by the solver."""

import copy
import json
import subprocess

import numpy as np
import pytest
from study.planning import meshes
from study.planning.dld import answers
from study.planning.documents import SCHEMAS, problems, read_json
from study.planning.plan import make_plan
from study.planning.tiers import load_study

CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")
STUDY = {
    "title": "A bead from a file",
    "purpose": "A test.",
    "devices": {"deep": {"depth_um": 9.6, "height": "full"}},
    "cells": {"bead": {"cell": {"shape": "mesh", "mesh_file": "bead.off", "radius_um": 2.0}}},
    "tiers": {
        "full": {
            "note": "",
            "passages": {"one": {"row_shifts_um": [4.0], "capillary_numbers": [0.1], "case": {}}},
        }
    },
}


def sphere(radius, divisions):
    """Vertices and faces of an icosahedron whose edges are halved some times, on a sphere."""
    phi = (1 + 5**0.5) / 2
    points = [(0, s, t * phi) for s in (1, -1) for t in (1, -1)]
    points = [np.roll(point, k) for k in range(3) for point in points]
    points = [np.array(point, float) / np.linalg.norm(point) for point in points]
    near = min(np.linalg.norm(points[0] - other) for other in points[1:]) * 1.01
    faces = [
        (a, b, c) if np.dot(np.cross(points[a], points[b]), points[c]) > 0 else (a, c, b)
        for a in range(12)
        for b in range(a + 1, 12)
        for c in range(b + 1, 12)
        if max(np.linalg.norm(points[i] - points[j]) for i, j in ((a, b), (b, c), (a, c))) < near
    ]
    for _ in range(divisions):
        known, finer = {}, []
        for face in faces:
            middles = []
            for i, j in zip(face, (*face[1:], face[0]), strict=True):
                key = frozenset((i, j))
                if key not in known:
                    known[key] = len(points)
                    middle = points[i] + points[j]
                    points.append(middle / np.linalg.norm(middle))
                middles.append(known[key])
            (a, b, c), (ab, bc, ca) = face, middles
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return radius * np.array(points), faces


def off(radius):
    points, faces = sphere(radius, 3)
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(map(repr, p.tolist())) for p in points)]
    return "\n".join([*lines, *(f"3 {a} {b} {c}" for a, b, c in faces)]) + "\n"


@pytest.fixture
def root(tmp_path, monkeypatch):
    """A root with the mesh of the study in params/cells."""
    monkeypatch.setattr(meshes, "ROOT", tmp_path)
    folder = tmp_path / meshes.CELLS
    folder.mkdir(parents=True)
    (folder / "bead.off").write_text(off(2.0), encoding="utf-8")
    return tmp_path


def plan_of(study, tmp_path):
    path = tmp_path / "bead.json"
    path.write_text(json.dumps(study), encoding="utf-8")
    return make_plan(load_study(path), "full", CASE_SCHEMA)


def test_the_case_names_the_mesh_from_the_folder_of_its_run(root, tmp_path):
    (run,) = plan_of(STUDY, tmp_path)["runs"]
    folder = root / "results/runs" / run["id"]
    folder.mkdir(parents=True)
    assert (folder / run["case"]["cell"]["mesh_file"]).resolve() == root / meshes.CELLS / "bead.off"
    assert problems(run["case"], CASE_SCHEMA) == []


def test_a_run_is_named_by_the_content_of_the_mesh_and_not_by_its_name(root, tmp_path):
    (before,) = plan_of(STUDY, tmp_path)["runs"]
    other = copy.deepcopy(STUDY)
    other["cells"]["bead"]["cell"]["mesh_file"] = "renamed.off"
    file = root / meshes.CELLS / "bead.off"
    (file.with_name("renamed.off")).write_bytes(file.read_bytes())
    assert plan_of(other, tmp_path)["runs"][0]["id"] == before["id"]
    file.write_text(off(2.1), encoding="utf-8")
    assert plan_of(STUDY, tmp_path)["runs"][0]["id"] != before["id"]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("none.off", "there is no such file"),
        ("../x.off", "allowed is a file below"),
        ("/x.off", "allowed is"),
    ],
)
def test_a_mesh_that_is_not_in_the_folder_of_the_cells_is_refused(root, tmp_path, name, message):
    study = copy.deepcopy(STUDY)
    study["cells"]["bead"]["cell"]["mesh_file"] = name
    with pytest.raises(ValueError, match=f"/cell/mesh_file = {name}: {message}"):
        plan_of(study, tmp_path)


def test_the_solver_reads_the_mesh_in_a_plan_and_in_a_run(root, tmp_path):
    dld = root / "build/dld"
    if not dld.exists():
        pytest.skip("the solver is not built")
    (run,) = plan_of(STUDY, tmp_path)["runs"]
    (answer,) = answers([run["case"]], dld)
    assert answer["problems"] == [] and answer["expected_cost"]["seconds_on_one_core"] > 0
    folder = root / "results/runs" / run["id"]
    folder.mkdir(parents=True)
    (folder / "case.json").write_text(json.dumps(run["case"]), encoding="utf-8")
    command = [dld, "check", folder / "case.json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
