"""What the solver says to its user besides results: what it takes, and what was given without effect."""

import json
import os
import subprocess
from pathlib import Path

import pytest
from study.planning.cases import resolved, run_id
from study.planning.documents import SCHEMAS, read_json
from study.planning.plan import load_plan

ROOT = Path(__file__).resolve().parents[2]
DLD = Path(os.environ.get("DLD", ROOT / "build/dld"))
needs_solver = pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")

CASE = {
    "description": "a coarse flow",
    "scene": "streamlines",
    "geometry": {"row_shift_um": 6.4, "depth_um": 6.4},
    "fluid": {"lattice_spacing_um": 1.6},
    "stop": {"max_steps": 200, "max_rows": 5},
}


def solver(*arguments):
    return subprocess.run([DLD, *arguments], capture_output=True, text=True, check=False)


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.json"
    path.write_text(json.dumps(CASE), encoding="utf-8")
    return path


@needs_solver
def test_a_key_without_effect_is_said_by_check_and_run_and_in_the_summary(case, tmp_path):
    summary = tmp_path / "summary.json"
    checked = solver("check", case)
    ran = solver("run", case, tmp_path / "run.h5", "--summary", summary)
    said = "/stop/max_rows has no effect: the scene streamlines does not read it; use /stop/max_steps"
    assert f"{case}: warning: {said}" in checked.stderr
    assert f"{case}: warning: {said}" in ran.stderr
    assert json.loads(summary.read_text(encoding="utf-8"))["warnings"] == [said]


@needs_solver
def test_a_run_says_first_what_it_takes(case, tmp_path):
    ran = solver("run", case, tmp_path / "run.h5")
    first = ran.stderr.splitlines()[0]
    assert first == (
        "streamlines: circle, radius 10 um, pitch 32 um, d = 6.4 um (epsilon 0.2), depth 6.4 um; "
        "dx = 1.6 um (standard)"
    )


def test_words_about_a_case_are_no_part_of_its_identity():
    schema = read_json(SCHEMAS / "case.schema.json")
    plain = {key: value for key, value in CASE.items() if key != "description"}
    described = resolved(CASE | {"$schema": "case.schema.json"}, schema)
    assert run_id(described, 1) == run_id(resolved(plain, schema), 1)


@needs_solver
def test_a_planned_ellipsoid_has_the_radius_of_its_axes(tmp_path):
    schema = read_json(SCHEMAS / "case.schema.json")
    ellipsoid = {"shape": "ellipsoid", "semi_axes_um": [5, 3, 1.5]}
    path = tmp_path / "case.json"
    path.write_text(json.dumps(resolved({"scene": "passage", "cell": ellipsoid}, schema)), "utf-8")
    checked = solver("check", "--json", path)
    assert json.loads(checked.stdout)["case"]["cell"]["radius_um"] == 5
    assert "warning" not in checked.stderr


@needs_solver
def test_nothing_is_said_of_the_cases_that_the_planner_writes(tmp_path):
    plan = load_plan(ROOT / "params/studies/krueger2014.json", "smoke")
    path = tmp_path / "case.json"
    for scene in ("streamlines", "stretching", "passage"):
        run = next(run for run in plan["runs"] if run["case"]["scene"] == scene)
        path.write_text(json.dumps(run["case"]), encoding="utf-8")
        assert "warning" not in solver("check", path).stderr, scene
