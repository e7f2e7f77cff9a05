"""What the tests of the pipeline share: the plan of the smoke tier and made-up results of its runs."""

import fcntl
import json
import os
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy; several threads slow small matrices down

import fake_solver
import matplotlib as mpl
import matplotlib.pyplot as plt
import pytest
from programs import program
from study.planning.brackets import at_value, bracket
from study.planning.cases import run_id
from study.planning.documents import read_json
from study.planning.plan import load_plan
from study.planning.tiers import load_study

mpl.use("Agg")

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def study():
    return load_study(ROOT / "params/studies/krueger2014.json")


def make_run(case, plan, folder):
    """A made-up run in its folder; its identity and class."""
    identity = run_id(case, plan["solver_model"])
    place = folder / "runs" / identity
    if not place.exists():
        place.mkdir(parents=True)
        (place / "case.json").write_text(json.dumps(case), encoding="utf-8")
        (place / "benchmark.tsv").write_text("s\n1.5\n", encoding="utf-8")
        fake_solver.run(case, place / "run.h5", place / "summary.json")
    return {"class": read_json(place / "summary.json")["status"], "run": identity}


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


def made_up_tier(tier, folder):
    """The plan of a tier and made-up results of its runs and brackets in a folder."""
    plan = load_plan(ROOT / "params/studies/krueger2014.json", tier)
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    for run in plan["runs"]:
        make_run(run["case"], plan, folder)
    for definition in plan["brackets"].values():
        make_bracket(definition, plan, folder)


@pytest.fixture(scope="session")
def made_up(tmp_path_factory, worker_id):
    """The folder with the made-up runs of a tier, made once for all processes of the tests: only to read."""
    base = tmp_path_factory.getbasetemp()
    base = base if worker_id == "master" else base.parent

    def of(tier):
        folder = base / f"made-up-{tier}"
        with (base / f"{tier}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not (folder / "done").exists():
                folder.mkdir()
                made_up_tier(tier, folder)
                (folder / "done").touch()
        return folder

    return of


@pytest.fixture(scope="session", params=["smoke", "fine"])
def results(request, tmp_path_factory, made_up):
    """Folder of a tier: its plan and made-up results of its runs and brackets; scripts write there too."""
    folder, source = tmp_path_factory.mktemp(request.param), made_up(request.param)
    shutil.copy(source / "plan.json", folder)
    for name in ("runs", "brackets"):
        (folder / name).symlink_to(source / name)
    return folder


def words_of(arguments):
    """Arguments by name as the words of a command line."""
    return [str(word) for name, value in arguments.items() for word in (f"--{name}", value)]


@pytest.fixture(scope="session")
def call_apart():
    """Runs one of the study's scripts in a process of its own, as the rules do, with arguments given by name;
    it has to succeed."""

    def run(script, **arguments):
        command = [sys.executable, program(script), *words_of(arguments)]
        environment = {"PYTHONPATH": str(ROOT / "workflow"), "PATH": "/usr/bin:/bin", "HOME": "/tmp"}
        environment["OPENBLAS_NUM_THREADS"] = "1"  # several threads slow small matrices down
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
        assert done.returncode == 0, done.stderr

    return run


@pytest.fixture(scope="session")
def call():
    """The same within the process of the tests, which has the libraries loaded: a tenth of the time."""

    def run(script, **arguments):
        path, before = str(program(script)), sys.argv
        sys.argv = [path, *words_of(arguments)]
        try:
            runpy.run_path(path, run_name="__main__")
        except SystemExit as end:
            assert not end.code, end.code
        finally:
            sys.argv = before
            plt.close("all")
            plt.rcdefaults()

    return run
