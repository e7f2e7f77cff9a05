"""What must not matter to the bytes of a run: threads, locale, time zone, folder, environment. Where the
solver is built."""

import json
import os
import re
import subprocess

import pytest
from short_passage import DLD, PASSAGE, needs_solver
from study.planning.points import merged

CASE = merged(PASSAGE, {"stop": {"max_rows": 1}})
CIRCUMSTANCES = {
    "two threads": ({"OMP_WAIT_POLICY": "passive"}, ["--threads", "2"], "."),
    "threads by the environment": ({"OMP_NUM_THREADS": "2", "OMP_WAIT_POLICY": "passive"}, [], "."),
    "locale": ({"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8"}, [], "."),
    "time zone": ({"TZ": "Pacific/Chatham"}, [], "."),
    "folder": ({}, [], "deeper/with spaces and é"),
    "no environment": (None, [], "."),
}


#: The provenance in the output says how many threads there were; nothing else may depend on it.
THREADS = rb'"threads":\d'
#: The seal of the file is a checksum over all of it.
SEAL = rb"\ndld seal [0-9a-f]{16} [0-9a-f]{16}\n"


def files_of_run(place, environment, words):
    """Bytes of the output and of the summary of a run in a folder, short of the number of threads."""
    place.mkdir(parents=True, exist_ok=True)
    (place / "case.json").write_text(json.dumps(CASE), encoding="utf-8")
    command = [DLD.resolve(), "run", "case.json", "run.h5", "--summary", "summary.json", *words]
    subprocess.run(command, cwd=place, env=environment, stderr=subprocess.DEVNULL, check=True)
    files = [(place / name).read_bytes() for name in ("run.h5", "summary.json")]
    return [re.sub(SEAL, b"", re.sub(THREADS, b"", content)) for content in files]


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    return files_of_run(tmp_path_factory.mktemp("plain"), None, [])


@needs_solver
@pytest.mark.parametrize("name", CIRCUMSTANCES)
def test_circumstances_do_not_matter(plain, tmp_path, name):
    environment, words, folder = CIRCUMSTANCES[name]
    given = {} if environment is None else {**os.environ, **environment}
    assert files_of_run(tmp_path / folder, given, words) == plain
