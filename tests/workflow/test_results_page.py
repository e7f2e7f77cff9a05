"""README.md and the page of the results: numbers are made, never typed; a README of one screen."""

import re
import shutil
import subprocess

import pandas as pd
import pytest
from conftest import ROOT
from study.analysis.boundary import critical_capillary_number
from study.analysis.tables import read_table
from study.paper import results_page


def committed(path, tmp_path):
    """A copy of a file as it is committed: a user's own runs may have changed the results in this folder."""
    shown = subprocess.run(["git", "show", f"HEAD:{path}"], cwd=ROOT, capture_output=True)
    if shown.returncode != 0:
        pytest.skip("not a clone")
    copy = tmp_path / path.replace("/", "-")
    copy.write_bytes(shown.stdout)
    return copy


TABLES = [
    "stage_times",
    "phase_boundary",
    "boundary_uncertainty",
    "boundary_lattices",
    "lattice_cells",
    "second_starts",
    "a_priori_summary",
    "passages",
]


def make_page(call, root, results, verdicts, output):
    """Makes the page of the results from a folder with `tables`."""
    plan = results / "plan-of-the-page.json"
    plan.write_text('{"note": ""}', encoding="utf-8")
    given = {"plan": plan, "results": results, "verdicts": verdicts, "root": root, "output": output}
    given |= {"claims": root / "params/claims.json", "numbers": root / "paper/numbers.toml"}
    call("results_page", template=root / "workflow/templates/results.md.j2", **given)
    return output.read_text(encoding="utf-8")


def test_the_committed_numbers_are_those_of_the_committed_results(tmp_path, call):
    copied = [
        "README.md",
        "docs/results.md",
        "params/claims.json",
        "paper/numbers.toml",
        "results/claims.csv",
    ]
    copied += ["workflow/templates/results.md.j2", *(f"results/tables/{name}.csv" for name in TABLES)]
    for path in copied:
        made = committed(path, tmp_path)
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        made.rename(tmp_path / path)
    verdicts = tmp_path / "results/claims.csv"
    line = results_page.verdicts(read_table(verdicts))
    assert line in (tmp_path / "README.md").read_text(encoding="utf-8"), "snakemake --cores 2 readme"
    kept = (tmp_path / "docs/results.md").read_text(encoding="utf-8")
    page = make_page(call, tmp_path, tmp_path / "results", verdicts, tmp_path / "docs/results.md")
    assert page == kept, "make the page again: snakemake --cores 2 docs/results.md"


def test_the_readme_is_one_screen_and_points_to_the_rest():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(text.split()) <= 800
    assert text.count("![") == 1
    assert text.index("![") < text.index("## Run it") < text.index("## Five doors")
    doors = text.split("## Five doors")[1].split("\n## ")[0]
    assert len(re.findall(r"^\*\*[^*]+\.\*\*", doors, re.MULTILINE)) == 5
    for page in ("docs/glossary.md", "docs/results.md", "docs/which-settings.md", "docs/method.md"):
        assert f"]({page})" in text and (ROOT / page).exists()


def test_the_glossary_defines_the_words_of_the_readme():
    text = (ROOT / "docs/glossary.md").read_text(encoding="utf-8")
    defined = {line.split("|")[1].strip() for line in text.splitlines() if line.startswith("| ")}
    wanted = {"capillary number", "row shift", "separation distance", "lateral extent", "displaced", "zigzag"}
    assert wanted | {"epsilon", "gap", "lane", "row", "bracket", "film", "preset", "reading"} <= defined


def test_links_of_the_documents_exist():
    for document in (ROOT / "docs").glob("*.md"):
        text = re.sub(r"```.*?```", "", document.read_text(encoding="utf-8"), flags=re.DOTALL)
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text):
            place = (document.parent / target).resolve()
            assert place.exists() or "results" in place.relative_to(ROOT).parts, f"{document.name}: {target}"


def test_blocks_take_the_place_of_old_ones_and_nothing_else():
    text = "a\n<!-- one -->\nold\nolder\n<!-- end -->\nb\n<!-- two -->\n<!-- end -->\n"
    filled = results_page.with_blocks(text, {"one": "1", "two": "2"})
    assert filled == "a\n<!-- one -->\n1\n<!-- end -->\nb\n<!-- two -->\n2\n<!-- end -->\n"
    assert results_page.with_blocks(filled, {"one": "1", "two": "2"}) == filled
    with pytest.raises(ValueError, match="three"):
        results_page.with_blocks(text, {"three": "3"})


def test_times_leave_out_what_is_made_on_request():
    rows = [
        ("passages", 0.4, 3, 60.0, 30.0),
        ("passages", 0.4, 1, 60.0, 60.0),
        ("stability", 0.8, 5, 9.0, 2.0),
    ]
    table = pd.DataFrame(rows, columns=["stage", "dx_um", "runs", "total_s", "longest_s"])
    lines = results_page.times(table).splitlines()
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
    lines = results_page.boundary(pd.DataFrame(rows, columns=[*BRACKET, "series"]), claim).splitlines()
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
    lines = results_page.doubts(table).splitlines()
    assert lines[0] == "| changed alone | against | d = 6.8 um | d = 6.0 um |"
    assert lines[2:] == [
        "| force: half | `corrected` | 0.2 - 0.25 (-5 to +6 %) |  |",
        "| mesh: frequency 14 | `corrected` | 0.3 - 0.31 (+21 to +30 %) | above 0.5 (above +12 %) |",
        "| mesh: frequency 28 | `reference` | 0.3 - 0.31 |  |",
    ]


def test_doubts_that_were_not_made_are_one_sentence():
    assert "snakemake --cores 2 uncertainty" in results_page.doubts(None)
    assert len(results_page.doubts(None).splitlines()) == 1


def test_the_page_is_made_of_the_tables_of_a_tier(results, call, root, tmp_path):
    given = {"plan": results / "plan.json", "brackets": results / "brackets"}
    names = {
        "boundary": "phase_boundary",
        "points": "points",
        "row-shifts": "shifts",
        "confirmation": "confirmed",
    }
    tables = tmp_path / "tables"
    tables.mkdir()
    call("boundary_tables", **given, **{name: tables / f"{table}.csv" for name, table in names.items()})
    call("stage_times", **given, runs=results / "runs", output=tables / "stage_times.csv")
    call("passages_table", **given, runs=results / "runs", output=tables / "passages.csv")
    starts = "set,points,same_class,other_class,no_class\ngrid,2,2,0,0\n"
    (tables / "second_starts.csv").write_text(starts, encoding="utf-8")
    guesses = "sweep,rule,right,wrong,left_out,hit_rate,node_updates\ngrid,tweezer,3,1,0,0.75,2e8\n"
    (tables / "a_priori_summary.csv").write_text(guesses, encoding="utf-8")
    claims = "id,claim,measured,verdict\nresistance,a resistance,8e8,REPRODUCED\n"
    (tmp_path / "claims.csv").write_text(claims, encoding="utf-8")
    page = make_page(call, root, tmp_path, tmp_path / "claims.csv", tmp_path / "results.md")
    assert results_page.NO_DOUBTS in page and "| grid | 2 | 2 | 0 | 0 |" in page
    assert "- A resistance. Measured: 8e8. **Reproduced.**" in page
    assert "| extent of the stretched cell, s as simulated | 3 of 4 | 2.0e+08 |" in page
    call("boundary_uncertainty", **given, output=tables / "boundary_uncertainty.csv")
    page = make_page(call, root, tmp_path, tmp_path / "claims.csv", tmp_path / "results.md")
    assert results_page.NO_DOUBTS not in page
    text = tmp_path / "README.md"
    shutil.copy(root / "README.md", text)
    call("readme_verdicts", readme=text, verdicts=tmp_path / "claims.csv")
    assert "**Claims: 1 reproduced" in text.read_text(encoding="utf-8")


def test_second_starts_stand_by_set():
    row = {"set": "grid", "points": 20, "same_class": 18, "other_class": 2, "no_class": 0}
    assert results_page.starts(pd.DataFrame([row])).splitlines()[2:] == ["| grid | 20 | 18 | 2 | 0 |"]


def test_the_critical_capillary_number_inverts_the_law():
    assert critical_capillary_number(2.9 + 5.4, (2.9, 5.4, 1.72)) == 0
    assert critical_capillary_number(2.8, (2.9, 5.4, 1.72)) is None
    assert critical_capillary_number(8.4, (2.9, 5.4, 1.72)) is None
