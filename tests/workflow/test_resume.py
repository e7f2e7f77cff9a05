"""A passage that is killed goes on to the same bytes: SIGKILL after every pillar line, for every option that
has a state of its own. Where the solver is built."""

import json
import signal
import subprocess
import time

import h5py
import pytest
from short_passage import DLD, PASSAGE, needs_solver
from study.planning.points import merged

FOLLOWED = merged(PASSAGE, {"output": {"snapshots_per_row": 4}})
OPTIONS = {
    "blocked": {"fluid": {"lateral_flow": "blocked"}},
    "free, one step per update": {"coupling": {"steps_per_update": 1}},
    "smoothed, penalty": {
        "cell": {"viscosity_field": "smoothed", "volume_control": "penalty", "volume_modulus": 100},
        "coupling": {"wall_repulsion": 2.815},
    },
    "corrected, full height, double": {
        "geometry": {"height": "full"},
        "fluid": {"precision": "double", "walls": "central_linear"},
        "coupling": {"kernel": "phi4_corrected", "steps_per_update": 1, "wall_repulsion": 2.815},
    },
}


def row_of(checkpoint):
    """Pillar lines passed by a checkpoint; -1 without one."""
    try:
        with h5py.File(checkpoint) as file:
            return int(file["arrays/row"][0])
    except OSError:
        return -1


def killed_after_every_row(command, checkpoint):
    """Runs the command to its end, killing it at every pillar line that it saves; returns the kills."""
    kills = 0
    while True:
        before = row_of(checkpoint)
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as running:
            while running.poll() is None and row_of(checkpoint) == before:
                time.sleep(0.01)
            if running.poll() is None:
                running.send_signal(signal.SIGKILL)
                kills += 1
        if running.returncode == 0:
            return kills
        assert running.returncode == -signal.SIGKILL


@needs_solver
@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
def test_a_killed_passage_ends_with_the_same_bytes(tmp_path, options):
    case = tmp_path / "case.json"
    case.write_text(json.dumps(merged(FOLLOWED, options)), encoding="utf-8")
    commands = {
        name: [DLD, "run", case, tmp_path / f"{name}.h5", "--summary", tmp_path / f"{name}.json", "--force"]
        for name in ("whole", "killed")
    }
    subprocess.run(commands["whole"], stderr=subprocess.DEVNULL, check=True)
    kills = killed_after_every_row(commands["killed"], tmp_path / "killed.h5.checkpoint")
    assert kills >= 3
    for suffix in ("json", "h5"):
        whole, killed = (tmp_path / f"{name}.{suffix}" for name in ("whole", "killed"))
        assert whole.read_bytes() == killed.read_bytes(), suffix
