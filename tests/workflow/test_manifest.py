"""Tables and figures that were changed by hand are named, and nothing is made from them."""

import subprocess
import sys

import pytest
from conftest import ROOT
from study.planning.manifest import MANIFEST, Changed, accept, begin, changed, record, recorded, settle


@pytest.fixture
def results(tmp_path):
    """A folder of results with a table, a figure and the verdicts, all recorded; and raw runs beside them."""
    folder = tmp_path / "results"
    others = ["runs/0/run.h5", "deep/tables/fits.csv"]
    for name in ["tables/fits.csv", "figures/fig07.png", "claims.csv", *others]:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("d,Ca\n1,2\n")
    accept(folder)
    return folder


def edit(path):
    path.write_text(path.read_text().replace("2", "3"))


def test_the_manifest_has_tables_figures_and_verdicts(results):
    assert set(recorded(results)) == {"tables/fits.csv", "figures/fig07.png", "claims.csv"}
    header, first = (results / MANIFEST).read_text().splitlines()[:2]
    assert header == "file,bytes,sha256" and first.startswith("claims.csv,9,") and len(first) == 13 + 64
    assert changed(results) == []


@pytest.mark.parametrize("name", ["tables/fits.csv", "figures/fig07.png", "claims.csv"])
def test_a_file_changed_by_hand_is_named_by_the_command(results, name):
    command = [sys.executable, ROOT / "workflow/scripts/planning/manifest.py", results]
    assert subprocess.run(command, check=False).returncode == 0
    edit(results / name)
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 1 and f"{results / name}\n" in done.stderr and "git checkout" in done.stderr
    assert subprocess.run([*command, "--accept"], check=False).returncode == 0
    assert subprocess.run(command, check=False).returncode == 0


def test_nothing_is_made_from_a_table_changed_by_hand(results, tmp_path):
    table, claims = results / "tables/fits.csv", results / "claims.csv"
    edit(table)
    with pytest.raises(Changed, match=r"fits\.csv"):
        begin(results, tmp_path / "journal", [([str(table)], [str(claims)])])
    assert not (tmp_path / "journal").exists()
    begin(results, tmp_path / "journal", [([str(claims)], [])])  # another job does not mind
    # Made again in the same call, it is no more what was changed.
    begin(results, tmp_path / "journal", [([str(table)], [str(claims)]), ([], [str(table)])])


@pytest.mark.parametrize("made", [True, False])
def test_what_a_call_makes_is_recorded_when_it_ends_also_by_the_next(results, tmp_path, made):
    journal, table = tmp_path / "journal", results / "tables/fits.csv"
    begin(results, journal, [([], [str(table), str(results / "tables/new.csv")])])
    if made:
        table.write_text("made anew")
        (results / "tables/new.csv").write_text("made")
    settle(journal)
    assert changed(results) == [] and not journal.exists()
    assert ("tables/new.csv" in recorded(results)) == made
    settle(journal)  # there is none


def test_what_was_changed_before_a_call_that_made_nothing_stays_changed(results, tmp_path):
    journal, table = tmp_path / "journal", results / "tables/fits.csv"
    edit(table)
    begin(results, journal, [([], [str(table)])])
    settle(journal)
    assert changed(results) == [str(table)]


def test_a_table_that_is_gone_is_made_again_and_no_fault(results):
    (results / "tables/fits.csv").unlink()
    assert changed(results) == []
    record(results, ["tables/fits.csv"])
    assert "tables/fits.csv" not in recorded(results)


@pytest.mark.parametrize("text", ["", "file,bytes\n", "file,bytes,sha256\nclaims.csv\n"])
def test_a_damaged_manifest_is_named(results, text):
    (results / MANIFEST).write_text(text)
    with pytest.raises(ValueError, match=r"manifest\.csv is damaged"):
        changed(results)


@pytest.mark.parametrize("folder", ["results", "results/deep", "results/triangle", "results/two-species"])
def test_the_committed_results_are_as_they_were_made(folder):
    assert recorded(ROOT / folder)
    assert changed(ROOT / folder) == []
