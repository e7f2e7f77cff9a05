"""A run that is stopped at any moment goes on to the same bytes: 40 kills at random moments, several in one
run, over every option that has state of its own. The moments differ with DLD_SEED."""

import json
import os
import random
import signal
import subprocess
import time

import pytest
from short_passage import DLD, needs_solver
from study.planning.points import merged
from test_resume import FOLLOWED, OPTIONS

SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
KILLS = 40 // len(OPTIONS)


def stopped_at_random(command, chance, seconds, most):
    """Runs a command to its end, stopping it at random moments at most so often; returns the stops."""
    stops = 0
    while True:
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as running:
            if stops < most:
                try:
                    running.wait(chance.uniform(0.05, 1.1) * seconds)
                except subprocess.TimeoutExpired:
                    running.send_signal(chance.choice(SIGNALS))
                    stops += 1
            running.wait()
        if running.returncode == 0:
            return stops
        assert running.returncode in (-signal.SIGKILL, 128 + signal.SIGTERM, 128 + signal.SIGINT)


@needs_solver
@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
def test_a_run_stopped_at_random_ends_with_the_same_bytes(tmp_path, options):
    chance = random.Random(int(os.environ.get("DLD_SEED", "1")))
    case = tmp_path / "case.json"
    case.write_text(json.dumps(merged(FOLLOWED, options)), encoding="utf-8")
    commands = {
        name: [DLD, "run", case, tmp_path / f"{name}.h5", "--summary", tmp_path / f"{name}.json", "--force"]
        for name in ("whole", "stopped")
    }
    started = time.monotonic()
    subprocess.run(commands["whole"], stderr=subprocess.DEVNULL, check=True)
    seconds = time.monotonic() - started
    stops = 0
    while stops < KILLS:
        stops += stopped_at_random(commands["stopped"], chance, seconds, KILLS - stops)
        for suffix in ("json", "h5"):
            whole, stopped = (tmp_path / f"{name}.{suffix}" for name in ("whole", "stopped"))
            assert whole.read_bytes() == stopped.read_bytes(), suffix
            stopped.unlink()
