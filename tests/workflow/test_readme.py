"""The numbers of README.md: made from the results, never typed."""

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
    brackets = table("results/tables/phase_boundary.csv")
    for block in (
        readme.times(table("results/tables/stage_times.csv")),
        readme.boundary(brackets, claim),
        readme.doubts(brackets),
        readme.blocked(brackets, claim),
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


def test_the_boundary_shows_open_brackets_and_the_printed_law():
    claim = {"value": {"offset_um": 2.9, "amplitude_um": 5.4, "rate": 1.72}}
    rows = [
        (2.0, 2.4, None, "free", "lattice-0.4"),
        (6.8, 0.452, 0.461, "free", "lattice-0.4"),
        (6.8, 0.3, 0.33, "free", "lattice-0.2"),
        (6.8, 0.195, 0.24, "free", "extrapolated"),
        (6.8, 0.38, 0.399, "free", "corrected-0.4"),
        (6.8, 0.4, 0.5, "blocked", "blocked-lateral"),
        (6.8, 0.4, 0.5, "free", "sensitivity/kernel/phi3"),
    ]
    columns = ["row_shift_um", "ca_displaced", "ca_zigzag", "lateral_flow", "series"]
    lines = readme.boundary(with_undisputed(pd.DataFrame(rows, columns=columns)), claim).splitlines()
    assert lines[0] == (
        "| d / um | Ca at 0.4 um | Ca at 0.2 um | Ca at 0.4 um, corrected | extrapolated | paper, Eq. (5) "
        "| 0.4 um, corrected, over Eq. (5) |"
    )
    assert lines[2] == "| 2.0 | above 2.4 |  |  |  |  |  |"
    assert (
        lines[3] == "| 6.8 | 0.452 - 0.461 | 0.3 - 0.33 | 0.38 - 0.399 | 0.195 - 0.24 | 0.19 | 2.01 - 2.11 |"
    )


def with_undisputed(table):
    """The table with brackets that no point contradicts."""
    return table.assign(ca_undisputed_displaced=table.ca_displaced, ca_undisputed_zigzag=table.ca_zigzag)


COLUMNS = ["row_shift_um", "ca_displaced", "ca_zigzag", "undecided_inside", "contradictions", "series"]


def test_doubts_show_the_row_shifts_where_something_was_changed():
    rows = [
        (5.2, 1.0, 1.1, 2, 0, "corrected-0.4"),
        (6.8, 0.374, 0.378, 0, 0, "corrected-0.4"),
        (6.8, 0.528, 0.545, 0, 0, "mesh-14"),
        (6.0, None, 0.2, 0, 1, "mesh-14"),
        (6.8, 0.2, 0.3, 0, 0, "lattice-0.4"),
    ]
    lines = readme.doubts(pd.DataFrame(rows, columns=COLUMNS)).splitlines()
    assert lines[0] == "| changed alone | d = 6.8 um | d = 6.0 um |"
    assert lines[2:] == [
        "| **`corrected`, 0.4 um** (`corrected-0.4`) | 0.374 - 0.378 |  |",
        "| mesh refined alone, frequency 10 to 14 (`mesh-14`) | 0.528 - 0.545 | below 0.2 (1 against it) |",
    ]


def test_brackets_without_lateral_flow_stand_beside_the_printed_law():
    claim = {"value": {"offset_um": 2.9, "amplitude_um": 5.4, "rate": 1.72}}
    rows = [
        (4.4, 0.833, 1.12, 2, 0, "blocked-corrected"),
        (6.8, 0.2, 0.22, 0, 0, "blocked-lateral"),
        (9.0, 0.2, 0.22, 0, 0, "blocked-lateral"),
        (6.0, 0.15, 0.154, 0, 1, "blocked-corrected"),
        (4.4, 0.833, 1.12, 0, 0, "corrected-0.4"),
    ]
    table = with_undisputed(pd.DataFrame(rows, columns=COLUMNS))
    table.loc[3, "ca_undisputed_zigzag"] = 0.189
    lines = readme.blocked(table, claim).splitlines()
    assert lines[2:] == [
        "| 4.4 | 0.833 - 1.12 (2 undecided inside) |  | 0.74 | 1.12 - 1.50 |",
        "| 6.0 | 0.15 - 0.154 (1 against it) |  | 0.32 | 0.46 - 0.59 |",
        "| 6.8 |  | 0.2 - 0.22 | 0.19 |  |",
        "| 9.0 |  | 0.2 - 0.22 |  |  |",
    ]


def test_second_starts_stand_by_set():
    row = {"set": "grid", "points": 20, "same_class": 18, "other_class": 2, "no_class": 0}
    assert readme.starts(pd.DataFrame([row])).splitlines()[2:] == ["| grid | 20 | 18 | 2 | 0 |"]


def test_the_critical_capillary_number_inverts_the_law():
    assert critical_capillary_number(2.9 + 5.4, (2.9, 5.4, 1.72)) == 0
    assert critical_capillary_number(2.8, (2.9, 5.4, 1.72)) is None
    assert critical_capillary_number(8.4, (2.9, 5.4, 1.72)) is None
