"""Brackets of the boundary: where they narrow, when they stop, what they say of undecided cells."""

import json
import subprocess
import sys

import fake_solver
import h5py
import programs
import pytest
from study.planning import brackets

CAPILLARY = {"name": "test", "axis": "capillary_number", "tolerance": 0.03, "levels": 5}
ROW_SHIFT = {"name": "test", "axis": "row_shift_um", "step": 0.4, "levels": 5}


def state_of(classes, definition=CAPILLARY):
    """State of a bracket from {value: class}."""
    points = [{"value": value, "class": name, "run": f"run-{value}"} for value, name in classes.items()]
    return brackets.bracket(points, definition)


def narrowed(class_of, ends, levels, definition=CAPILLARY):
    """Final state and the number of runs with a function value -> class."""
    state = state_of({value: class_of(value) for value in ends}, definition)
    for _ in range(levels):
        added = {value: class_of(value) for value in state["next"]}
        known = {point["value"]: point["class"] for point in state["points"]}
        state = state_of(known | added, definition)
    return state


@pytest.mark.parametrize("critical", [0.11, 0.3333, 0.8, 2.3])
def test_the_critical_value_is_found_to_three_per_cent_in_five_levels(critical):
    state = narrowed(lambda ca: "displaced" if ca < critical else "zigzag", [0.1, 2.4], 5)
    assert state["low"] < critical <= state["high"] <= 1.03 * state["low"]
    assert state["status"] == "bracketed"
    assert state["next"] == []


def test_each_level_divides_the_logarithm_by_three():
    state = state_of({0.1: "displaced", 2.7: "zigzag"})
    assert state["next"] == [0.3, 0.9]
    assert state["status"] == "open"


def test_a_bracket_of_no_levels_says_that_it_comes_from_the_cells():
    state = state_of({0.1: "displaced", 2.7: "zigzag"}, CAPILLARY | {"levels": 0})
    assert state["status"] == brackets.FROM_CELLS


@pytest.mark.parametrize(("name", "low", "high"), [("displaced", 2.4, None), ("zigzag", None, 0.1)])
def test_one_class_over_the_whole_range_asks_for_nothing(name, low, high):
    state = state_of({0.1: name, 0.5: name, 2.4: name})
    assert (state["low"], state["high"], state["next"]) == (low, high, [])
    assert state["status"] == f"all-{name}"


def test_an_undecided_end_is_not_taken_for_a_class():
    assert state_of({0.1: "displaced", 2.4: "undecided"})["status"] == "open"
    assert state_of({0.1: "diverged", 2.4: "zigzag"})["status"] == "open"
    assert state_of({0.1: "undecided", 2.4: "undecided"})["status"] == "open"


def test_undecided_cells_stay_inside_and_their_sides_are_narrowed():
    state = state_of({0.2: "displaced", 0.5: "undecided", 1.25: "zigzag"})
    assert (state["low"], state["high"], state["undecided_inside"]) == (0.2, 1.25, 1)
    assert state["next"] == [pytest.approx(0.3162), pytest.approx(0.7906)]

    def class_of(ca):
        return "displaced" if ca < 0.45 else "undecided" if ca < 0.55 else "zigzag"

    state = narrowed(class_of, [0.1, 2.4], 9)
    assert state["low"] == pytest.approx(0.45, rel=0.03)
    assert state["high"] == pytest.approx(0.55, rel=0.03)
    assert (state["status"], state["next"]) == ("open", [])


def test_a_contradicting_point_is_counted_and_does_not_move_the_cut_far():
    classes = {0.1: "displaced", 0.2: "zigzag", 0.3: "displaced", 0.4: "displaced", 1.0: "zigzag"}
    state = state_of(classes)
    assert (state["low"], state["high"], state["contradictions"]) == (0.4, 1.0, 1)


def test_row_shifts_are_narrowed_at_lattice_steps():
    state = state_of({2.0: "displaced", 3.2: "zigzag"}, ROW_SHIFT)
    assert state["next"] == [2.4, 2.8]
    state = narrowed(lambda d: "displaced" if d < 5.3 else "zigzag", [2.0, 8.8], 4, ROW_SHIFT)
    assert (state["low"], state["high"], state["status"]) == (5.2, 5.6, "bracketed")


def test_the_programs_share_runs_and_run_nothing_for_a_finished_bracket(root, study, tmp_path):
    """bracket_start, bracket_point and bracket_narrow with the made-up solver."""
    from study.planning.documents import read_json
    from study.planning.plan import load_plan

    plan = load_plan(root / "params/studies/krueger2014.json", "smoke")
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    dld = tmp_path / "dld"
    program = root / "tests/workflow/fake_solver.py"
    dld.write_text(f'#!/bin/sh\necho run >> {tmp_path}/count\nexec {sys.executable} {program} "$@"\n')
    dld.chmod(0o755)
    name = "default/d6.4"
    definition = plan["brackets"][name]
    runs = tmp_path / "runs"
    for value, run in definition["known"]:
        folder = runs / run
        folder.mkdir(parents=True)
        label = "displaced" if value < 0.3 else "zigzag"
        case = brackets.at_value(definition["case"], definition["axis"], value)
        fake_solver.run(case, folder / "run.h5", folder / "summary.json")
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        (folder / "summary.json").write_text(json.dumps(summary | {"status": label}), encoding="utf-8")
        with h5py.File(folder / "run.h5", "a") as file:
            file.attrs["status"] = label

    def call(script, **arguments):
        words = [str(word) for key, value in arguments.items() for word in (f"--{key}", value)]
        command = [sys.executable, programs.program(script), "--plan", tmp_path / "plan.json"]
        environment = {"PYTHONPATH": str(root / "workflow"), "PATH": "/usr/bin:/bin"}
        subprocess.run([*command, *words], check=True, env=environment)

    start, low, again = (tmp_path / f"{name}.json" for name in ("start", "low", "again"))
    given = {"runs": runs, "dld": dld, "runner": root / "workflow/scripts/run_case"}
    call("bracket_start", name=name, runs=runs, output=start)
    call("bracket_point", bracket=start, side="low", output=low, **given)
    call("bracket_point", bracket=start, side="low", output=again, **given)
    point = read_json(low)
    assert point == read_json(again)
    assert (tmp_path / "count").read_text().splitlines() == ["run"]
    assert (runs / point["run"] / "benchmark.tsv").exists()
    done = read_json(start) | {"next": []}
    start.write_text(json.dumps(done), encoding="utf-8")
    call("bracket_point", bracket=start, side="high", output=again, **given)
    assert read_json(again) is None
    assert (tmp_path / "count").read_text().splitlines() == ["run"]
