"""The spot check: what is drawn, where the case of a row comes from, and which differences are found."""

import json
import subprocess
import sys

import pandas as pd
import programs
import pytest
from study.analysis.passages import COLUMNS, row_of
from study.analysis.runs import passage_runs
from study.analysis.spot_check import case_of, compared, drawn, texts
from study.analysis.tables import read_table
from study.planning.cases import run_id
from study.planning.documents import read_json

ROW = {
    "sweep": "grid",
    "class": "zigzag",
    "zigs": "2",
    "d_perp_um": "5.000",
    "film_um": "0.206",
    "failing_step": "",
}


@pytest.fixture(scope="module")
def committed(results, call):
    """The table of passages of a tier of made-up runs."""
    path = results / "tables/passages.csv"
    call(
        "passages_table",
        plan=results / "plan.json",
        runs=results / "runs",
        brackets=results / "brackets",
        output=path,
    )
    return path


def row(**changed):
    """A row of texts with some columns changed."""
    return dict.fromkeys(COLUMNS, "1") | ROW | changed


def test_the_draw_depends_on_the_seed_alone_and_takes_no_run_twice(committed):
    table = read_table(committed)
    first = drawn(table, 10, 1, 1e99)
    assert first == drawn(table.sample(frac=1.0, random_state=3), 10, 1, 1e99)
    assert first != drawn(table, 10, 2, 1e99)
    assert len(set(first)) == 10
    assert set(drawn(table, 10**6, 1, 1e99)) == set(table.run)


def test_longer_runs_are_left_out_on_request(committed):
    table = read_table(committed)
    table.loc[table.run == table.run[0], "node_updates"] = 10**12
    assert set(drawn(table, 10**6, 1, 1e11)) == set(table.run) - {table.run[0]}


def test_every_row_of_the_table_is_found_in_the_study(results, committed):
    plan = read_json(results / "plan.json")
    table = pd.read_csv(committed, dtype=str, keep_default_na=False)
    for line in table.to_dict("records"):
        assert run_id(case_of(line, plan), plan["solver_model"]) == line["run"]
    with pytest.raises(ValueError, match="run 000000000000 "):
        case_of(table.iloc[0].to_dict() | {"run": "0" * 12}, plan)


@pytest.mark.parametrize(
    ("changed", "verdict", "columns"),
    [
        ({}, "same", []),
        ({"steps": "1.0"}, "same", []),  # a column with gaps has whole numbers in another format
        ({"film_um": "0.207"}, "alike", ["film_um"]),
        ({"d_perp_um": "5.024"}, "alike", ["d_perp_um"]),
        ({"d_perp_um": "4.976"}, "alike", ["d_perp_um"]),
        ({"d_perp_um": "5.026"}, "other", ["d_perp_um"]),
        ({"d_perp_um": ""}, "other", ["d_perp_um"]),
        ({"class": "displaced"}, "other", ["class"]),
        ({"zigs": "1"}, "other", ["zigs"]),
        ({"sweep": "another name of the same run"}, "same", []),
    ],
)
def test_a_difference_is_seen_and_weighed(changed, verdict, columns):
    assert compared(row(), row(**changed)) == (verdict, columns)


def test_a_run_compares_with_its_own_row(results, committed):
    table = pd.read_csv(committed, dtype=str, keep_default_na=False).set_index("run")
    runs = passage_runs(results / "plan.json", results / "brackets", results / "runs")
    for run in runs:
        line = table.loc[[run.id]].iloc[0].to_dict() | {"run": run.id}
        assert compared(line, texts(row_of(run))) == ("same", [])


def test_the_programs_make_a_run_again_and_fail_where_it_comes_out_otherwise(
    root, results, committed, call, tmp_path
):
    program = tmp_path / "dld"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{root}/tests/workflow/fake_solver.py" "$@"\n')
    program.chmod(0o755)
    table = pd.read_csv(committed, dtype=str, keep_default_na=False)
    table.loc[table.run == table.run[0], "d_perp_um"] = "1.000"
    (tmp_path / "tables").mkdir()
    table.to_csv(tmp_path / "tables/passages.csv", index=False)
    scripts, runs = root / "workflow/scripts", tmp_path / "runs"
    given = {"plan": results / "plan.json", "tables": tmp_path / "tables", "runs": runs, "dld": program}
    given["own"] = results / "runs"
    other = table.run[table.run != table.run[0]].iloc[0]
    for run in (table.run[0], other):
        call("spot_run", **given, runner=scripts / "run_case", run=run, output=tmp_path / f"{run}.json")

    def checked(*arguments):
        command = [sys.executable, programs.program("spot_check"), *arguments]
        environment = {"PYTHONPATH": str(root / "workflow"), "PATH": "/usr/bin:/bin"}
        return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)

    assert json.loads((tmp_path / f"{other}.json").read_text())["verdict"] == "same"
    good = checked("--results", tmp_path / f"{other}.json", "--output", tmp_path / "one.csv")
    assert (good.returncode, good.stdout.count("1 passages made again: 1 the same")) == (0, 1)
    both = [tmp_path / f"{run}.json" for run in (other, table.run[0])]
    bad = checked("--results", *both, "--output", tmp_path / "two.csv")
    assert bad.returncode == 1
    assert sorted(read_table(tmp_path / "two.csv").verdict) == ["other", "same"]
