"""A damaged checkpoint is noticed and put aside; the run ends with the bytes of one that nothing stopped."""

import json
import random
import shutil
import signal
import subprocess
import time

import pytest
from short_passage import DLD, PASSAGE, needs_solver

TRIES = 54
PAGE = 4096


def flipped(content, chance):
    """One bit flipped."""
    place = chance.randrange(len(content))
    content[place] ^= 1 << chance.randrange(8)


def zeroed(content, chance):
    """A page of zeros."""
    place = chance.randrange(max(1, len(content) - PAGE))
    content[place : place + PAGE] = bytes(min(PAGE, len(content) - place))


def cut(content, chance):
    """The end is missing."""
    del content[chance.randrange(len(content)) :]


def edited(content, chance):
    """Eight bytes are another number."""
    place = chance.randrange(len(content) - 8) & ~7
    content[place : place + 8] = chance.randbytes(8)


def grown(content, chance):
    """Bytes behind the end."""
    content += chance.randbytes(1 + chance.randrange(PAGE))


def run(folder, name):
    """The solver's command with files of the given name."""
    return [
        DLD,
        "run",
        folder / "case.json",
        folder / f"{name}.h5",
        "--summary",
        folder / f"{name}.json",
        "--force",
    ]


@pytest.fixture(scope="module")
def stopped(tmp_path_factory):
    """A folder with a whole run and the checkpoint of one that was killed after its first row."""
    folder = tmp_path_factory.mktemp("stopped")
    (folder / "case.json").write_text(json.dumps(PASSAGE), encoding="utf-8")
    subprocess.run(run(folder, "whole"), stderr=subprocess.DEVNULL, check=True)
    checkpoint = folder / "killed.h5.checkpoint"
    with subprocess.Popen(run(folder, "killed"), stderr=subprocess.DEVNULL) as running:
        while running.poll() is None and not checkpoint.exists():
            time.sleep(0.005)
        running.send_signal(signal.SIGKILL)
    assert checkpoint.exists()
    shutil.copy(checkpoint, folder / "kept")
    return folder


@needs_solver
def test_a_damaged_checkpoint_changes_no_result(stopped, tmp_path):
    chance = random.Random(1)
    whole = (stopped / "whole.h5").read_bytes(), (stopped / "whole.json").read_bytes()
    for turn in range(TRIES):
        damage = (flipped, zeroed, cut, edited, grown, flipped)[turn % 6]
        content = bytearray((stopped / "kept").read_bytes())
        damage(content, chance)
        folder = tmp_path / str(turn)
        folder.mkdir()
        shutil.copy(stopped / "case.json", folder)
        (folder / "again.h5.checkpoint").write_bytes(content)
        done = subprocess.run(run(folder, "again"), capture_output=True, text=True, check=False)
        assert done.returncode == 0, (turn, damage.__doc__, done.stderr)
        again = (folder / "again.h5").read_bytes(), (folder / "again.json").read_bytes()
        assert again == whole, (turn, damage.__doc__)
