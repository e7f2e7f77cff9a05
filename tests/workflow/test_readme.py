"""The numbers of README.md: made from the results, never typed."""

import shutil
import subprocess

import pandas as pd
import pytest
from conftest import ROOT
from study import readme
from study.boundary import critical_capillary_number
from study.claims import load_claims
from study.tables import read_table


def committed(path, tmp_path):
    """A copy of a file as it is committed: a user's own runs may have changed the results in this folder."""
    shown = subprocess.run(["git", "show", f"HEAD:{path}"], cwd=ROOT, capture_output=True)
    if shown.returncode != 0:
        pytest.skip("not a clone")
    copy = tmp_path / path.replace("/", "-")
    copy.write_bytes(shown.stdout)
    return copy


def test_the_committed_numbers_are_those_of_the_committed_results(tmp_path):
    def table(path):
        return read_table(committed(path, tmp_path))

    claim = load_claims(committed("params/claims.json", tmp_path))["phase-boundary"]
    text = committed("README.md", tmp_path).read_text(encoding="utf-8")
    uncertainty = "results/tables/boundary_uncertainty.csv"
    made = subprocess.run(["git", "cat-file", "-e", f"HEAD:{uncertainty}"], cwd=ROOT, capture_output=True)
    for block in (
        readme.times(table("results/tables/stage_times.csv")),
        readme.boundary(table("results/tables/phase_boundary.csv"), claim),
        readme.doubts(table(uncertainty) if made.returncode == 0 else None),
        readme.starts(table("results/tables/second_starts.csv")),
        readme.verdicts(table("results/claims.csv")),
    ):
        assert block in text, "make the numbers again: snakemake --cores 2 readme"


def test_blocks_take_the_place_of_old_ones_and_nothing_else():
    text = "a\n<!-- one -->\nold\nolder\n<!-- end -->\nb\n<!-- two -->\n<!-- end -->\n"
    filled = readme.with_blocks(text, {"one": "1", "two": "2"})
    assert filled == "a\n<!-- one -->\n1\n<!-- end -->\nb\n<!-- two -->\n2\n<!-- end -->\n"
    assert readme.with_blocks(filled, {"one": "1", "two": "2"}) == filled
    with pytest.raises(ValueError, match="three"):
        readme.with_blocks(text, {"three": "3"})


def test_times_leave_out_what_is_made_on_request():
    rows = [
        ("passages", 0.4, 3, 60.0, 30.0),
        ("passages", 0.4, 1, 60.0, 60.0),
        ("stability", 0.8, 5, 9.0, 2.0),
    ]
    table = pd.DataFrame(rows, columns=["stage", "dx_um", "runs", "total_s", "longest_s"])
    lines = readme.times(table).splitlines()
    assert lines[2:] == ["| passages | 0.4 | 4 | 60 | 2.0 |", "| **all** |  | 4 |  | **2** |"]


BRACKET = ["row_shift_um", "ca_undisputed_displaced", "ca_undisputed_zigzag"]


def test_the_boundary_shows_open_brackets_and_the_printed_law():
    claim = {"value": {"offset_um": 2.9, "amplitude_um": 5.4, "rate": 1.72}}
    rows = [
        (2.0, 2.4, None, "default"),
        (6.8, 0.2, 0.25, "default"),
        (6.8, 0.21, 0.22, "corrected"),
        (6.8, 0.452, 0.461, "hinge_sphere"),
        (7.2, None, 0.1, "hinge_sheet"),
        (6.8, 0.1, 0.12, "blocked"),
        (6.8, 0.4, 0.5, "sensitivity/kernel/phi3"),
        (4.4, 0.4, 0.5, "blocked-corrected"),
    ]
    lines = readme.boundary(pd.DataFrame(rows, columns=[*BRACKET, "series"]), claim).splitlines()
    assert lines[0] == (
        "| d / um | `default` | `corrected` | `hinge_sphere` | `hinge_sheet` | `blocked` "
        "| paper, Eq. (5) | `default` over Eq. (5) |"
    )
    assert lines[2:] == [
        "| 2.0 | above 2.4 |  |  |  |  |  |  |",
        "| 6.8 | 0.2 - 0.25 | 0.21 - 0.22 | 0.452 - 0.461 |  | 0.1 - 0.12 | 0.19 | 1.06 - 1.32 |",
        "| 7.2 |  |  |  | below 0.1 |  | 0.13 |  |",
    ]


def test_doubts_show_what_was_changed_and_by_how_much():
    changes = ["least_change_percent", "most_change_percent"]
    rows = [
        (6.0, 0.5, None, "mesh", "frequency 14", "corrected", 12.3, None),
        (6.8, 0.2, 0.25, "force", "half", "corrected", -5.4, 6.1),
        (6.8, 0.3, 0.31, "mesh", "frequency 14", "corrected", 21.0, 30.0),
        (6.8, 0.3, 0.31, "mesh", "frequency 28", "reference", None, None),
    ]
    table = pd.DataFrame(rows, columns=[*BRACKET, "cause", "setting", "reference", *changes])
    lines = readme.doubts(table).splitlines()
    assert lines[0] == "| changed alone | against | d = 6.8 um | d = 6.0 um |"
    assert lines[2:] == [
        "| force: half | `corrected` | 0.2 - 0.25 (-5 to +6 %) |  |",
        "| mesh: frequency 14 | `corrected` | 0.3 - 0.31 (+21 to +30 %) | above 0.5 (above +12 %) |",
        "| mesh: frequency 28 | `reference` | 0.3 - 0.31 |  |",
    ]


def test_doubts_that_were_not_made_are_one_sentence():
    assert "snakemake --cores 2 uncertainty" in readme.doubts(None)
    assert len(readme.doubts(None).splitlines()) == 1


def test_the_readme_has_a_place_for_every_block(results, call, root, tmp_path):
    given = {"plan": results / "plan.json", "brackets": results / "brackets"}
    names = {
        "boundary": "phase_boundary",
        "points": "points",
        "row-shifts": "shifts",
        "confirmation": "confirmed",
    }
    tables = {name: tmp_path / f"{table}.csv" for name, table in names.items()}
    call("boundary_tables", **given, **tables)
    call("stage_times", **given, runs=results / "runs", output=tmp_path / "stage_times.csv")
    starts = "set,points,same_class,other_class,no_class\ngrid,2,2,0,0\n"
    (tmp_path / "second_starts.csv").write_text(starts, encoding="utf-8")
    (tmp_path / "claims.csv").write_text("verdict\nREPRODUCED\n", encoding="utf-8")
    text = tmp_path / "README.md"
    shutil.copy(root / "README.md", text)
    verdicts = {"verdicts": tmp_path / "claims.csv", "claims": root / "params/claims.json"}
    call("readme_numbers", readme=text, tables=tmp_path, **verdicts)
    filled = text.read_text(encoding="utf-8")
    assert readme.NO_DOUBTS in filled and "| grid | 2 | 2 | 0 | 0 |" in filled
    call("boundary_uncertainty", **given, output=tmp_path / "boundary_uncertainty.csv")
    call("readme_numbers", readme=text, tables=tmp_path, **verdicts)
    assert readme.NO_DOUBTS not in text.read_text(encoding="utf-8")


def test_second_starts_stand_by_set():
    row = {"set": "grid", "points": 20, "same_class": 18, "other_class": 2, "no_class": 0}
    assert readme.starts(pd.DataFrame([row])).splitlines()[2:] == ["| grid | 20 | 18 | 2 | 0 |"]


def test_the_critical_capillary_number_inverts_the_law():
    assert critical_capillary_number(2.9 + 5.4, (2.9, 5.4, 1.72)) == 0
    assert critical_capillary_number(2.8, (2.9, 5.4, 1.72)) is None
    assert critical_capillary_number(8.4, (2.9, 5.4, 1.72)) is None
