"""Runs that are stopped: within a second, with the exit code of what stopped them; the run that goes on ends
with the same bytes, wherever a signal, a kill or the end of the wall time came. Where the solver is built."""

import json
import os
import random
import signal
import subprocess
import time
from pathlib import Path

import pytest
from short_passage import DLD, PASSAGE, needs_solver
from study.planning.points import merged

SPHERE = {"shape": "sphere", "radius_um": 3, "mesh_frequency": 3, "local_area_modulus": 1}
SHORT = {
    "passage": merged(PASSAGE, {"output": {"snapshots_per_row": 4}}),
    "blocked passage": merged(PASSAGE, {"fluid": {"lateral_flow": "blocked"}}),
    "smoothed passage": merged(PASSAGE, {"cell": {"viscosity_field": "smoothed"}}),
    "shear": {
        "scene": "shear",
        "fluid": {"lattice_spacing_um": 1},
        "cell": SPHERE | {"viscosity_update_interval": 7},
        "shear": {"duration": 4, "box_um": 20},
    },
    "coupled stretching": {
        "scene": "stretching",
        "fluid": {"lattice_spacing_um": 0.8},
        "cell": {"mesh_frequency": 4, "local_area_modulus": 1, "global_area_modulus": 2},
        "stretching": {"method": "coupled", "forces_pN": [20, 60]},
        "stop": {"max_steps": 8000},
    },
    "static stretching": {
        "scene": "stretching",
        "cell": {"mesh_frequency": 12},
        "stretching": {"forces_pN": [0, 20, 40, 60, 80]},
    },
}
#: Each would go on for hours.
LONG = {
    "passage": {"scene": "passage", "fluid": {"lattice_spacing_um": 0.2}, "cell": {"mesh_frequency": 20}},
    "streamlines": {"scene": "streamlines", "fluid": {"lattice_spacing_um": 0.2, "force_density": 1e-5}},
    "channel": {
        "scene": "channel",
        "geometry": {"depth_um": 40},
        "fluid": {"precision": "double", "force_density": 1e-7},
        "channel": {"width_um": 40},
    },
    "shear": merged(SHORT["shear"], {"shear": {"duration": 1e6}, "stop": {"max_steps": 10**12}}),
    "coupled stretching": merged(
        SHORT["coupled stretching"],
        {"stop": {"max_steps": 10**12}, "stretching": {"forces_pN": list(range(20, 120))}},
    ),
    "static stretching": merged(SHORT["static stretching"], {"cell": {"mesh_frequency": 80}}),
}


def command(folder, name, *words):
    case = folder / "case.json"
    files = [case, folder / f"{name}.h5", "--summary", folder / f"{name}.json"]
    return [DLD, "run", *files, "--force", *words]


def write(folder, case):
    (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")


def stopped_again_and_again(words, seed, times=12):
    """Runs the command to its end, stopping it at random moments; returns how often."""
    choose, stops = random.Random(seed), 0
    while True:
        with subprocess.Popen(words, stderr=subprocess.DEVNULL) as running:
            number = choose.choice([signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
            try:
                running.wait(choose.uniform(0.03, 0.12) if stops < times else None)
            except subprocess.TimeoutExpired:
                running.send_signal(number)
                stops += 1
        if running.returncode == 0:
            return stops
        # A signal that comes before the program has begun ends it as any other program.
        assert running.returncode in (-number, 128 + number)


@needs_solver
@pytest.mark.parametrize("name", SHORT)
def test_a_run_that_is_stopped_ends_with_the_same_bytes(tmp_path, name):
    write(tmp_path, SHORT[name])
    subprocess.run(command(tmp_path, "whole"), stderr=subprocess.DEVNULL, check=True)
    words = command(tmp_path, "stopped", "--checkpoint-minutes", "0.001")
    assert stopped_again_and_again(words, seed=name) >= 2
    for suffix in ("json", "h5"):
        whole, stopped = (tmp_path / f"{kind}.{suffix}" for kind in ("whole", "stopped"))
        assert whole.read_bytes() == stopped.read_bytes(), suffix
    assert not list(tmp_path.glob("*.checkpoint*")) and not list(tmp_path.glob("*.part"))


def cpu_s(pid):
    """Seconds of the processor that a process has taken."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@needs_solver
@pytest.mark.parametrize("name", LONG)
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_is_seen_within_a_second(tmp_path, name, number):
    write(tmp_path, LONG[name])
    with subprocess.Popen(command(tmp_path, "long"), stderr=subprocess.DEVNULL) as running:
        time.sleep(1.5)
        assert running.poll() is None
        before = cpu_s(running.pid)
        running.send_signal(number)
        _, status, used = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
    assert running.returncode in (-number, 128 + number)
    assert used.ru_utime + used.ru_stime - before < 1, "seconds of the processor, whatever else it does"


@needs_solver
def test_a_run_stops_before_the_end_of_its_wall_time(tmp_path):
    write(tmp_path, LONG["shear"])
    started = time.monotonic()
    done = subprocess.run(
        command(tmp_path, "long", "--wall-time", "0.05"), capture_output=True, text=True, check=False
    )
    assert done.returncode == 128 + signal.SIGALRM and "the wall time is over" in done.stderr
    assert 2.5 < time.monotonic() - started < 15
    assert (tmp_path / "long.h5.checkpoint").exists() and not (tmp_path / "long.h5").exists()
