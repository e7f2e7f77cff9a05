"""Calls of the pipeline beside, after and over one another: nothing finished is lost, failures are named."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from study.analysis.solve import status_in
from study.planning import failures
from study.planning.lock import Busy, only_looks, taken
from study.planning.redraw import drawing_rules, rules_in

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENT = os.environ | {"PYTHONPATH": str(ROOT / "workflow")}
ENVIRONMENT["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
CASE = '{"scene": "passage"}'


def test_the_second_call_is_told_who_holds_the_lock_and_since_when(tmp_path):
    first = taken(tmp_path / "lock", ["snakemake", "a b"])
    with pytest.raises(Busy, match=rf"process {os.getpid()} since \d{{4}}-.* \(snakemake 'a b'\)"):
        taken(tmp_path / "lock", [])
    first.close()
    taken(tmp_path / "lock", []).close()


@pytest.mark.parametrize(("words", "looks"), [("-n", 1), ("--dry-run -c1", 1), ("-np", 1), ("--unlock", 1)])
def test_a_call_that_only_looks_takes_no_lock(words, looks):
    assert only_looks(words.split()) == looks
    assert not only_looks(["--cores", "2", "--config", "tier=n", "results/-n.csv"])


def test_a_second_snakemake_in_the_tree_ends_before_it_touches_anything(tmp_path):
    for name in ("Snakefile", "workflow", "params", "paper", "solver", "CMakeLists.txt"):
        (tmp_path / name).symlink_to(ROOT / name)
    mine = tmp_path / ".snakemake/locks/0.output.lock"
    mine.parent.mkdir(parents=True)
    mine.write_text("of the first call")
    with taken(tmp_path / ".snakemake/study.lock", ["the first call"]):
        command = [sys.executable, "-m", "snakemake", "--cores", "1", "--nolock", "build/dld"]
        done = subprocess.run(command, cwd=tmp_path, env=ENVIRONMENT, capture_output=True, text=True)
    assert done.returncode == 1
    assert "another call works in this tree" in done.stderr and "the first call" in done.stderr
    assert mine.exists()
    assert not (tmp_path / "build").exists()


def run_case(folder, program, **options):
    """Starts run_case on a folder with a shell program as the solver: $3 output, $5 summary."""
    solver = folder.parent / "dld"
    solver.write_text(f"#!/bin/sh\n{program}\n")
    solver.chmod(0o755)
    files = [folder / name for name in ("case.json", "run.h5", "summary.json")]
    command = [ROOT / "workflow/scripts/run_case", solver, *files, "1", folder / "run.log"]
    return subprocess.Popen(command, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True, **options)


@pytest.fixture
def folder(tmp_path):
    """A folder of a run with its case."""
    place = tmp_path / "runs" / "0123456789ab"
    place.mkdir(parents=True)
    (place / "case.json").write_text(CASE)
    return place


def test_a_run_whose_caller_was_killed_is_waited_for_and_not_made_twice(folder):
    program = f'echo run >> {folder}/count; sleep 2; echo x > "$3"; echo \'{{"status": "zigzag"}}\' > "$5"'
    first = run_case(folder, program)
    while not (folder / "count").exists():
        time.sleep(0.02)
    first.send_signal(signal.SIGKILL)  # the solver lives on
    first.wait()
    second = run_case(folder, program)
    assert "still solves this run: waiting" in second.communicate(timeout=60)[1]
    assert second.returncode == 0
    assert (folder / "count").read_text() == "run\n"
    assert failures.stated_status(folder / "summary.json") == "zigzag"


@pytest.mark.parametrize("status", [2, 4, 139])
def test_a_run_that_fails_is_a_result_that_says_so_and_is_made_again(folder, status):
    done = run_case(folder, f"echo no room left >&2; exit {status}")
    assert "FAILED with exit status" in done.communicate(timeout=60)[1]
    assert done.returncode == 0
    assert status_in(folder) == failures.FAILED
    runs = folder.parent
    (runs.parent / "brackets/a/d6").mkdir(parents=True)
    point, kept = (runs.parent / f"brackets/a/d6/level-1-{side}.json" for side in ("low", "high"))
    point.write_text('{"value": 0.3, "class": "failed", "run": "0123456789ab"}')
    kept.write_text("null")
    why = failures.failed_runs([folder.name, "missing"], runs)
    assert why == {folder.name: f"exit status {status}: no room left"}
    failures.forget([folder.name], runs, runs.parent / "brackets")
    assert status_in(folder) is None
    assert (point.exists(), kept.exists()) == (False, True)


@pytest.mark.parametrize("status", [129, 130, 137, 142, 143])
def test_an_interrupted_run_is_no_result(folder, status):
    done = run_case(folder, f"exit {status}")
    done.communicate(timeout=60)
    assert done.returncode == status
    assert status_in(folder) is None


def test_a_damaged_summary_is_a_failure_and_named(folder):
    (folder / "summary.json").write_text('{"stat')
    assert failures.failed_runs([folder.name], folder.parent) == {folder.name: "its summary is damaged"}


def test_redraw_may_run_the_rules_that_read_tables_alone():
    rules = {}
    for path in (ROOT / "workflow/rules").rglob("*.smk"):
        rules |= rules_in(path.read_text(encoding="utf-8"))
    allowed = drawing_rules(ROOT / "workflow/rules")
    assert {"redraw", "paper", "claims", "figure_phase_space", "figure_devices"} <= set(allowed)
    assert not {"solve", "bracket_point", "figure_convergence", "passages_table"} & set(allowed)
    for name, text in rules.items():
        draws = "{FIGURES}" in text and "--output" in text and "--runs" not in text
        assert not draws or name in allowed, f"{name} draws from tables"


def moved(tmp_path, name):
    """A tree with an environment that was made elsewhere and copied to a place of this name."""
    tree = tmp_path / name
    (tree / "workflow").mkdir(parents=True)
    bootstrap = (ROOT / "workflow/bootstrap").read_text()
    part = bootstrap[bootstrap.index("settle_python_packages() {") :].split("\n}\n")[0]
    (tree / "settle").write_text(f"set -euo pipefail\n{part}\n}}\nsettle_python_packages\n")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", tmp_path / "old tree/.venv"], check=True)
    old = tmp_path / "old tree/.venv"
    (old / "bin/program").write_text(f"#!{old}/bin/python\nprint('hello')\n")
    old.rename(tree / ".venv")
    (tree / "workflow/study").mkdir()
    (tree / "workflow/study/__init__.py").write_text("")
    (tree / ".venv/bin/program").chmod(0o755)
    return tree


@pytest.mark.parametrize("name", ["new", "new & s|ide"])
def test_a_moved_environment_belongs_to_its_new_place(tmp_path, name):
    tree = moved(tmp_path, name)
    subprocess.run(["bash", "settle"], cwd=tree, check=True)
    first = (tree / ".venv/bin/program").read_text().splitlines()[0]
    assert first == f"#!{tree}/.venv/bin/python"
    where = [tree / ".venv/bin/python", "-c", "import study; print(study.__file__)"]
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    found = subprocess.run(where, cwd="/", env=clean, capture_output=True, text=True, check=True).stdout
    assert found.strip() == f"{tree}/workflow/study/__init__.py"
    before = (tree / ".venv/place").stat().st_mtime_ns
    subprocess.run(["bash", "settle"], cwd=tree, check=True)
    assert (tree / ".venv/place").stat().st_mtime_ns == before


def test_a_build_folder_of_another_tree_is_begun_anew(tmp_path):
    (tmp_path / "build/CMakeFiles").mkdir(parents=True)
    cache = tmp_path / "build/CMakeCache.txt"
    cmake = tmp_path / "bin/cmake"
    cmake.parent.mkdir()
    cmake.write_text("#!/bin/sh\n")
    cmake.chmod(0o755)
    environment = {"PATH": f"{cmake.parent}:/usr/bin:/bin"}
    for home, kept in ((tmp_path, True), ("/nowhere", False)):
        cache.write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
        subprocess.run([ROOT / "workflow/scripts/configure"], cwd=tmp_path, env=environment, check=True)
        assert cache.exists() == kept


def test_a_failed_run_leaves_readable_files(folder):
    run_case(folder, "exit 4").communicate(timeout=60)
    assert json.loads((folder / "summary.json").read_text())["status"] == failures.FAILED
    assert (folder / "run.h5").stat().st_size > 0


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("", "--logger study"),
        ("tier=quick", "--config tier=quick --logger study"),
        ("--config tier=smoke dld=x -n", "--config tier=smoke dld=x --logger study"),
        ("redraw", "--forceall redraw"),
        ("tier=quick redraw=fig07", "--config tier=quick only=fig07 --logger study"),
        ("claim=d-perp-6.8", "--config claim=d-perp-6.8 --logger study"),
        ("--cores 1 -- results/a.csv", "--keep-going --cores 1 -- results/a.csv"),
    ],
)
def test_the_words_of_reproduce_become_a_call_of_snakemake(tmp_path, words, expected):
    (tmp_path / "workflow").mkdir()
    (tmp_path / "workflow/reproduce").write_text((ROOT / "workflow/reproduce").read_text())
    (tmp_path / "workflow/bootstrap").write_text("")
    python = tmp_path / ".venv/bin/python"
    python.parent.mkdir(parents=True)
    python.write_text('#!/bin/sh\necho "$PYTHONPATH: $*"\n')
    python.chmod(0o755)
    command = ["bash", tmp_path / "workflow/reproduce", *words.split()]
    *before, said = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    assert said.startswith(f"{tmp_path}/workflow: -m snakemake")
    assert [line.endswith(" -- build/dld") for line in before] in ([], [True])  # the solver first, if at all
    assert expected in said and "--nolock" in said
    for target in ("redraw", "claim"):
        assert said.endswith(f" {target}") == (target in words)
