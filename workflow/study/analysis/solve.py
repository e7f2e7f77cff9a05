"""A solver run that is not known beforehand: made once in its folder, whoever asks for it first."""

import fcntl
import json
import subprocess
import sys
import time
from pathlib import Path

from study.analysis.runs import DamagedRun, checked_summary
from study.planning.cases import run_id
from study.planning.classes import DECIDED
from study.planning.failures import FAILED, stated_status

FINISHED = (*DECIDED, "undecided", "diverged", "converged")
ENDED = (*FINISHED, FAILED)


def status_in(folder):
    """Class of a run that ended in its folder; None if it is to be made: it is not there, was interrupted, or
    its files are damaged."""
    summary = folder / "summary.json"
    if not summary.exists():
        return None
    if stated_status(summary) == FAILED:
        return FAILED
    try:
        status = checked_summary(folder)["status"]
    except DamagedRun as problem:
        print(problem, file=sys.stderr)
        return None
    return status if status in ENDED else None


def solved(case, solver_model, runs, runner, dld):
    """Runs a resolved case unless its folder has the result; returns its (identity, class).

    A lock makes two jobs that ask for the same run at the same time share it.
    """
    identity = run_id(case, solver_model)
    folder = Path(runs) / identity
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if status_in(folder) not in FINISHED:
            (folder / "case.json").write_text(json.dumps(case, indent=2) + "\n", encoding="utf-8")
            started = time.perf_counter()
            files = [folder / name for name in ("case.json", "run.h5", "summary.json")]
            subprocess.run([runner, dld, *files, "1", folder / "run.log"], check=True)
            seconds = time.perf_counter() - started
            (folder / "benchmark.tsv").write_text(f"s\n{seconds:.2f}\n", encoding="utf-8")
        status = status_in(folder)
    (folder / "lock").unlink(missing_ok=True)
    if status is None:
        raise RuntimeError(f"{folder} has no finished run")
    return identity, status
