"""The project as a whole: documented commands exist, the plan of the workflow holds, the code is tidy."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CODE = [ROOT / name for name in ("solver", "workflow", "params", "tests", ".ci")]
SUFFIXES = {".py", ".smk", ".cpp", ".hpp", ".json", ".md", ".cff", ".toml", ".txt", ".tex", ""}


def text_files():
    """Files written by hand: code, parameters and documents."""
    beside = (
        path for path in ROOT.iterdir() if path.is_file() and path.name != ".git"
    )  # a file in a worktree
    yield from (path for path in beside if path.suffix in SUFFIXES)
    for folder in CODE:
        for path in folder.rglob("*"):
            if path.is_file() and path.suffix in SUFFIXES and "__pycache__" not in path.parts:
                yield path


def test_the_readmes_commands_exist():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```(?:sh|bash|console)\n(.*?)```", readme, flags=re.DOTALL)
    commands = [line.split("#")[0].split() for block in blocks for line in block.splitlines() if line.strip()]
    assert commands[0][:2] == ["bash", "workflow/reproduce"]
    assert ["bash", "workflow/test"] in commands
    for words in commands:
        for word in words:
            if re.match(r"(workflow|params|\.ci)/", word):
                assert (ROOT / word).exists(), " ".join(words)


def test_links_of_the_readme_exist():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)#:]+)\)", readme):
        assert (ROOT / target).exists() or target.startswith("results/"), target


def test_no_paths_of_a_machine_are_written_anywhere():
    pattern = re.compile(r"(?<![\w.])/(home|work|root|Users|mnt|scratch)/\w")
    found = [
        str(path)
        for path in text_files()
        if pattern.search(path.read_text(encoding="utf-8", errors="ignore"))
    ]
    assert found == []


def test_python_code_is_formatted_and_clean():
    ruff = [sys.executable, "-m", "ruff"]
    for command in (["format", "--check"], ["check"]):
        done = subprocess.run(
            [*ruff, *command, "workflow", "tests"], cwd=ROOT, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stdout


def test_rules_have_no_lambdas_and_every_script_is_used():
    rules = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "workflow/rules").rglob("*.smk"))
    assert "lambda" not in rules
    used = rules + (ROOT / "Snakefile").read_text(encoding="utf-8")
    used += (ROOT / "workflow/test").read_text(encoding="utf-8")
    used += (ROOT / "workflow/reproduce").read_text(encoding="utf-8")
    used += (ROOT / "workflow/scripts/run_case").read_text(encoding="utf-8")
    used += (ROOT / "docs/extending.md").read_text(encoding="utf-8")  # programs for people
    for script in (ROOT / "workflow/scripts").rglob("*"):
        if script.is_file() and script.suffix != ".pyc":
            assert script.name in used, script.name


@pytest.mark.parametrize("tier", ["paper", "smoke"])
def test_the_workflow_plans_its_figures(tier, tmp_path):
    snakemake = [sys.executable, "-m", "snakemake", "--snakefile", ROOT / "Snakefile", "--directory", ROOT]
    command = [*snakemake, "--dry-run", "--forceall", "--cores", "1", "--nolock", "--config", f"tier={tier}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    for rule in ("solve", "claims", "figure_trajectories"):
        assert rule in done.stdout + done.stderr


def test_no_rule_asks_for_a_number_of_cores():
    """A call on a cluster has none, and Snakemake (9.27) refuses to read a workflow that asks for it."""
    texts = [ROOT / "Snakefile", *(ROOT / "workflow/rules").rglob("*.smk")]
    assert [path.name for path in texts if "workflow.cores" in path.read_text(encoding="utf-8")] == []


def test_shell_programs_are_valid():
    for name in (
        "workflow/bootstrap",
        "workflow/reproduce",
        "workflow/test",
        "workflow/test-cluster",
        "workflow/test-container",
        "workflow/test-deep",
        "workflow/lock",
        "workflow/scripts/run_case",
        ".ci/run",
    ):
        assert subprocess.run([shutil.which("bash"), "-n", ROOT / name], check=False).returncode == 0, name


def test_a_diverged_run_is_kept(tmp_path):
    folder = tmp_path / "0123456789ab"
    folder.mkdir()
    for status in (0, 3):
        program = tmp_path / f"dld-{status}"
        program.write_text(f"#!/bin/sh\necho working >&2\necho x > $3\necho x > $5\nexit {status}\n")
        program.chmod(0o755)
        files = [folder / name for name in ("case.json", "run.h5", "summary.json")]
        command = [ROOT / "workflow/scripts/run_case", program, *files, "1", folder / "run.log"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert (folder / "run.log").read_text() == "working\n"
        assert (folder / "summary.json").read_text() == "x\n"
