"""Damaged, edited or mixed-up files of finished runs and of measurements are never used in silence."""

import json
import shutil
import subprocess

import h5py
import pytest
from short_passage import DLD, needs_solver
from study.analysis import solve
from study.analysis.measured import read_measured
from study.analysis.runs import DamagedRun, Run, checked_summary, seal_holds
from study.analysis.spot_check import asked

#: Two runs of a second.
CASES = {
    name: {
        "scene": "streamlines",
        "geometry": {"row_shift_um": shift},
        "fluid": {"lattice_spacing_um": 1.6, "precision": "single", "force_density": 1e-3},
        "stop": {"steady_tolerance": 1e-3},
    }
    for name, shift in (("one", 6.4), ("other", 3.2))
}
CASES["one"]["geometry"]["depth_um"] = CASES["other"]["geometry"]["depth_um"] = 6.4


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Folders of two finished runs."""
    place = tmp_path_factory.mktemp("made")
    for name, case in CASES.items():
        (place / name).mkdir()
        (place / name / "case.json").write_text(json.dumps(case), encoding="utf-8")
        words = [DLD, "run", "case.json", "run.h5", "--summary", "summary.json"]
        subprocess.run(words, cwd=place / name, stderr=subprocess.DEVNULL, check=True)
    return place


@pytest.fixture
def folder(made, tmp_path):
    """A copy of the first run that may be damaged."""
    return shutil.copytree(made / "one", tmp_path / "one")


def verified(folder):
    words = [DLD, "verify", "run.h5", "summary.json", "--case", "case.json"]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)


def flip(path, place):
    content = bytearray(path.read_bytes())
    content[place] ^= 4
    path.write_bytes(bytes(content))


def edited(path):
    summary = json.loads(path.read_text())
    path.write_text(json.dumps(summary | {"separation_um": 2.0}), encoding="utf-8")


def unsealed(path):
    """The file as a version without seals left it."""
    path.write_bytes(path.read_bytes()[:-44])
    with h5py.File(path, "a") as file:
        del file.attrs["sealed"]


DAMAGES = {
    "a bit flipped early": lambda f, _: flip(f / "run.h5", 3000),
    "a bit flipped in the middle": lambda f, _: flip(f / "run.h5", (f / "run.h5").stat().st_size // 2),
    "a bit flipped in the seal": lambda f, _: flip(f / "run.h5", -20),
    "the seal cut off": lambda f, _: (f / "run.h5").write_bytes((f / "run.h5").read_bytes()[:-44]),
    "half of the file": lambda f, _: (f / "run.h5").write_bytes((f / "run.h5").read_bytes()[:5000]),
    "an empty file": lambda f, _: (f / "run.h5").write_bytes(b""),
    "no file": lambda f, _: (f / "run.h5").unlink(),
    "an edited summary": lambda f, _: edited(f / "summary.json"),
    "an empty summary": lambda f, _: (f / "summary.json").write_text(""),
    "half a summary": lambda f, _: (f / "summary.json").write_text('{"status": "conv'),
    "a summary of another run": lambda f, other: shutil.copy(other / "summary.json", f),
    "the files of another run": lambda f, other: [
        shutil.copy(other / n, f) for n in ("summary.json", "run.h5")
    ],
}


@needs_solver
@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_damage_is_named_by_the_solver_and_the_pipeline(folder, made, damage):
    case = json.loads((folder / "case.json").read_text())
    assert verified(folder).returncode == 0
    run = Run("one", "", {}, case, folder)
    assert run.summary["status"] == "converged" and run.data("flow/x_um") is not None
    damage(folder, made / "other")
    done = verified(folder)
    assert done.returncode == 4 and ("run.h5" in done.stderr or "summary.json" in done.stderr)
    with pytest.raises(DamagedRun, match="its run is made again"):
        checked_summary(folder, case)


@needs_solver
def test_runs_of_versions_without_seals_are_read(folder):
    unsealed(folder / "run.h5")
    assert not seal_holds(folder / "run.h5")
    assert verified(folder).returncode == 0
    assert checked_summary(folder)["status"] == "converged"
    edited(folder / "summary.json")
    assert verified(folder).returncode == 4
    with pytest.raises(DamagedRun):
        checked_summary(folder)


def test_a_damaged_run_of_a_bracket_is_made_again(tmp_path, monkeypatch, capsys):
    folder = tmp_path / "run"
    folder.mkdir()
    (folder / "summary.json").write_text("")
    assert solve.status_in(folder) is None
    assert "summary.json" in capsys.readouterr().err


HEADER = "# measured\nset,F_pN,DA_um,DA_err_um,conf_err\n"


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("A,20,9.5,0,high", "line 4, DA_err_um = 0: an error bar is above 0"),
        ("A,20,9.5,-0.5,high", "line 4, DA_err_um"),
        ("A;20;9.5;0.5;high", "line 4: 1 columns, the header has 5"),
        ("A,20,9.5,0.5", "line 4: 4 columns"),
        ("A,20,9.5;0.5,,high", "line 4, DA_um = '9.5;0.5'"),
        ("A,twenty,9.5,0.5,high", "line 4, F_pN = 'twenty'"),
        ("A,nan,9.5,0.5,high", "line 4, F_pN = 'nan'"),
        ("A,,9.5,0.5,high", "line 4, F_pN is empty"),
        ("A,20,-9.5,0.5,high", "line 4, DA_um = -9.5: at least 0"),
        ('A,"20\n",9.5,0.5,high', "line 4: 2 columns"),
    ],
)
def test_a_wrong_cell_of_measured_data_is_named(tmp_path, row, words):
    path = tmp_path / "data.csv"
    path.write_text(HEADER + "A,0,7.7,,low\n" + row + "\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"data\.csv:") as error:
        read_measured(path)
    assert words in str(error.value)


def test_measured_data_without_faults_are_read(root):
    assert len(read_measured(root / "params/experiment/tweezer_experiment.csv")) > 10


@pytest.mark.parametrize(
    ("name", "value"),
    [("sample", "abc"), ("sample", 0), ("sample", 2.5), ("sample", ""), ("seed", "x"), ("seed", -1)]
    + [("most_node_updates", text) for text in ("many", "nan", "inf", -1)],
)
def test_an_option_of_the_spot_check_that_is_no_number_is_named(name, value):
    with pytest.raises(ValueError, match=f"--config {name}={value}: a"):
        asked({name: value})


def test_options_of_the_spot_check_may_be_texts():
    assert asked({"sample": "3", "seed": 7, "most_node_updates": "5e9"}) == (5e9, 3, 7)
    assert asked({}) == (1e99, 20, 1)
