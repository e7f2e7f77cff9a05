"""Files of the solver: none is overwritten by the run that reads it, what cannot be written is known before a
run or leaves what was there; names of a study reach no command. Where the solver is built."""

import json
import resource
import signal
import subprocess

import pytest
from short_passage import DLD, PASSAGE, needs_solver
from study.planning.documents import SCHEMAS, problems, read_json


def solver(folder, *words, **options):
    command = [DLD, "run", *words]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, **options)


@pytest.fixture
def folder(tmp_path):
    """A folder with a case under three names: its own, a symbolic link and a hard link."""
    case = tmp_path / "case.json"
    case.write_text(json.dumps(PASSAGE), encoding="utf-8")
    (tmp_path / "link.json").symlink_to(case)
    (tmp_path / "hard.json").hardlink_to(case)
    return tmp_path


@needs_solver
@pytest.mark.parametrize(
    "words",
    [
        ["case.json", "case.json"],
        ["case.json", "./case.json"],
        ["case.json", "link.json"],
        ["case.json", "hard.json"],
        ["case.json", "out.h5", "--summary", "./out.h5"],
        ["case.json", "out.h5", "--summary", "out.h5.checkpoint"],
        ["case.json", "out.h5", "--summary", "out.xdmf"],
        ["case.json", "out.h5", "--summary", "case.json"],
    ],
)
def test_a_file_with_two_parts_in_a_run_is_refused(folder, words):
    done = solver(folder, *words)
    assert done.returncode == 2 and "name another file" in done.stderr
    assert json.loads((folder / "case.json").read_text()) == PASSAGE
    assert not (folder / "out.h5").exists()


@needs_solver
@pytest.mark.parametrize(
    "words", [["case.json", "no/out.h5"], ["case.json", "out.h5", "--summary", "no/s.json"]]
)
def test_a_folder_that_is_missing_is_known_before_the_run(folder, words):
    done = solver(folder, *words)
    assert (
        done.returncode == 4 and "does the folder exist" in done.stderr and "steady flow" not in done.stderr
    )


@needs_solver
def test_a_full_disk_ends_with_a_reason_and_keeps_what_was_there(folder):
    def no_room():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

    before = folder / "out.h5"
    before.write_bytes(b"of another run")
    done = solver(folder, "case.json", "out.h5", preexec_fn=no_room)
    assert done.returncode == 4 and "out.h5.checkpoint.part" in done.stderr
    assert before.read_bytes() == b"of another run"
    assert sorted(path.name for path in folder.glob("out*")) == ["out.h5"]


@pytest.mark.parametrize("name", ["$(touch x)", "../../x", "a b", "a;b", "a\n", "{run}", "", "'", "<b>"])
def test_names_that_reach_commands_and_paths_are_plain(study, name):
    schema = read_json(SCHEMAS / "study.schema.json")
    smoke = study["tiers"]["smoke"]
    for tiers in (
        {name: smoke},
        {"t": smoke | {"passages": {name: smoke["passages"]["grid"]}}},
        {"t": smoke | {"boundary": smoke["boundary"] | {"series": {name: {}}}}},
    ):
        found = problems({"solver_model": 1, "tiers": tiers}, schema)
        assert any("does not match" in text for text in found), tiers.keys()
