"""What the tests of the pipeline share: the plan of the smoke tier and made-up results of its runs."""

import json
import subprocess
import sys
from pathlib import Path

import fake_solver
import pytest
from study import plan as planning
from study.brackets import at_value, bracket

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def study():
    return planning.load_study(ROOT / "params/studies/krueger2014.json")


def make_run(case, plan, folder):
    """A made-up run in its folder; its identity and class."""
    identity = planning.run_id(case, plan["solver_model"])
    place = folder / "runs" / identity
    if not place.exists():
        place.mkdir(parents=True)
        (place / "case.json").write_text(json.dumps(case), encoding="utf-8")
        (place / "benchmark.tsv").write_text("s\n1.5\n", encoding="utf-8")
        fake_solver.run(case, place / "run.h5", place / "summary.json")
    return {"class": planning.read_json(place / "summary.json")["status"], "run": identity}


def make_bracket(definition, plan, folder):
    """The last state of a bracket and its confirmations, as the rules would leave them."""

    def point(case, value):
        return {"value": value} | make_run(at_value(case, definition["axis"], value), plan, folder)

    place, case = folder / "brackets" / definition["name"], definition["case"]
    place.mkdir(parents=True)
    state = bracket([point(case, value) for value, _ in definition["known"]], definition)
    for _ in range(definition["levels"]):
        state = bracket(state["points"] + [point(case, value) for value in state["next"]], definition)
    (place / f"level-{definition['levels']}.json").write_text(json.dumps(state), encoding="utf-8")
    for label, other in definition["confirm"].items():
        for side in ("low", "high"):
            found = None if state[side] is None else point(other, state[side])
            (place / f"confirm-{label}-{side}.json").write_text(json.dumps(found), encoding="utf-8")


@pytest.fixture(scope="session", params=["smoke", "fine"])
def results(request, tmp_path_factory):
    """Folder of a tier: its plan and made-up results of its runs and brackets; scripts write there too."""
    folder = tmp_path_factory.mktemp(request.param)
    plan = planning.load_plan(ROOT / "params/studies/krueger2014.json", request.param)
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    for run in plan["runs"]:
        make_run(run["case"], plan, folder)
    for definition in plan["brackets"].values():
        make_bracket(definition, plan, folder)
    return folder


@pytest.fixture(scope="session")
def call():
    """Runs one of the study's scripts with arguments given by name and returns nothing; it has to succeed."""

    def run(script, **arguments):
        words = [str(word) for name, value in arguments.items() for word in (f"--{name}", value)]
        command = [sys.executable, ROOT / "workflow/scripts" / f"{script}.py", *words]
        environment = {"PYTHONPATH": str(ROOT / "workflow"), "PATH": "/usr/bin:/bin", "HOME": "/tmp"}
        environment["OPENBLAS_NUM_THREADS"] = "1"  # several threads slow small matrices down
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
        assert done.returncode == 0, done.stderr

    return run
