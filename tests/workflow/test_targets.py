"""Calls of Snakemake for single files, in a tree of their own: what is not planned is refused in words, and
nothing is made from a table that was changed by hand."""

import os
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

LINKED = ("Snakefile", "workflow", "params", "paper", "solver", "CMakeLists.txt", "README.md", "docs")
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "workflow")}


@pytest.fixture
def tree(tmp_path):
    """A tree without a solver, with the committed results."""
    for name in LINKED:
        (tmp_path / name).symlink_to(ROOT / name)
    ignored = shutil.ignore_patterns("runs", "brackets", "spot_check", "smoke", "quick", "logs", "deep")
    shutil.copytree(ROOT / "results", tmp_path / "results", ignore=ignored)
    return tmp_path


def called(tree, *words):
    command = [
        sys.executable,
        "-m",
        "snakemake",
        "--cores",
        "1",
        "--nolock",
        *words,
    ]
    return subprocess.run(command, cwd=tree, env=ENVIRONMENT, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    ("file", "words"),
    [
        (
            "results/runs/0123456789ab/summary.json",
            "this run is in no section of tier paper of study krueger2014",
        ),
        (
            "results/brackets/default/d99/level-0.json",
            "bracket default/d99: tier paper of study krueger2014 has no",
        ),
        (
            "results/brackets/default/d6/confirm-fine-low.json",
            "bracket default/d6 is not confirmed with 'fine'",
        ),
        ("results/figures/animation_none.gif", "No rule to produce results/figures/animation_none.gif"),
    ],
)
def test_what_is_not_planned_is_refused_in_words(tree, file, words):
    done = called(tree, "-n", file)
    assert done.returncode == 1 and words in done.stdout + done.stderr
    assert "KeyError" not in done.stdout + done.stderr


def test_a_table_changed_by_hand_is_named_and_not_used(tree):
    assert called(tree, "verify").returncode == 0
    table, figure = (tree / "results" / name for name in ("tables/phase_boundary.csv", "figures/fig02.png"))
    table.write_text(table.read_text().replace("1", "2"))
    done = called(tree, "verify")
    assert done.returncode == 1 and "results/tables/phase_boundary.csv" in done.stderr
    claims = tree / "results/claims.csv"
    before = claims.read_bytes()
    done = called(tree, "--force", "results/claims.csv", "--allowed-rules", "claims")
    assert done.returncode == 1 and "not as the pipeline made them" in done.stderr
    assert "results/tables/phase_boundary.csv" in done.stderr and claims.read_bytes() == before
    # Another file is made, and recorded; a date is not enough for that.
    figure.write_bytes(b"another figure")
    called(tree, "--touch", "--force", "results/figures/fig02.png", "--allowed-rules", "figure_geometry")
    assert "fig02.png" in called(tree, "verify").stderr
    done = called(tree, "--force", "results/figures/fig02.png", "--allowed-rules", "figure_geometry")
    assert done.returncode == 0, done.stderr
    done = called(tree, "verify")
    assert "phase_boundary.csv" in done.stderr and "fig02.png" not in done.stderr
