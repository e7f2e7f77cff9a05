"""What the tests of the pipeline share: the plan of the smoke tier and made-up results of its runs."""

import json
import subprocess
import sys
from pathlib import Path

import fake_solver
import pytest
from study import plan as planning

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def study():
    return planning.validated(ROOT / "params/study.json", "study")


@pytest.fixture(scope="session", params=["smoke", "paper"])
def results(request, tmp_path_factory):
    """Folder of a tier: its plan.json and made-up results of all its runs; scripts write there too."""
    folder = tmp_path_factory.mktemp(request.param)
    plan = planning.load_plan(ROOT / "params/study.json", request.param)
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    for run in plan["runs"]:
        place = folder / "runs" / run["id"]
        if not place.exists():
            place.mkdir(parents=True)
            fake_solver.run(run["case"], place / "run.h5", place / "summary.json")
    return folder


@pytest.fixture(scope="session")
def call():
    """Runs one of the study's scripts with arguments given by name and returns nothing; it has to succeed."""

    def run(script, **arguments):
        words = [str(word) for name, value in arguments.items() for word in (f"--{name}", value)]
        command = [sys.executable, ROOT / "workflow/scripts" / f"{script}.py", *words]
        environment = {"PYTHONPATH": str(ROOT / "workflow"), "PATH": "/usr/bin:/bin", "HOME": "/tmp"}
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
        assert done.returncode == 0, done.stderr

    return run
