"""The cases of a plan are shown to the solver before any of them runs."""

import json
import os

import pytest
from short_passage import DLD, needs_solver
from study.planning.cases import resolved, run_id
from study.planning.dld import answers
from study.planning.documents import SCHEMAS, read_json
from study.planning.plan import load_plan
from study.planning.precheck import cases_of, is_current, place_in, placed, seconds_of_runs
from study.planning.tiers import load_study

CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")


def changed_study(root, tmp_path, change):
    """A study of the smoke tier alone with something changed, and its plan."""
    study = json.loads((root / "params/studies/krueger2014.json").read_text(encoding="utf-8"))
    change(study["tiers"])
    path = tmp_path / "study.json"
    path.write_text(json.dumps(study), encoding="utf-8")
    return path


def refusal(root, tmp_path, change, tier="smoke"):
    path = changed_study(root, tmp_path, change)
    plan = load_plan(path, tier)
    with pytest.raises(ValueError) as error:
        seconds_of_runs(path, plan, CASE_SCHEMA, DLD, tmp_path / "kept.json")
    assert not (tmp_path / "kept.json").exists()
    return str(error.value)


def test_values_know_where_they_stand():
    document = placed({"a": [{"b": 2, "c": 0.5}, True, None], "d": "text"})
    assert document == {"a": [{"b": 2, "c": 0.5}, True, None], "d": "text"}
    assert json.dumps(document) == '{"a": [{"b": 2, "c": 0.5}, true, null], "d": "text"}'
    assert place_in(document["a"][0], "/b") == "/a/0/b"
    assert place_in(document, "/d") == "/d"
    assert place_in(document, "/e") is None and place_in(document, "/d/f") is None


@needs_solver
def test_a_row_shift_beside_the_lattice_is_refused_at_its_place(root, tmp_path):
    def change(tiers):
        sweep = next(iter(tiers["smoke"]["passages"].values()))
        sweep["row_shifts_um"] = [*sweep["row_shifts_um"], 4.1]

    text = refusal(root, tmp_path, change)
    assert "study.json: cases that the solver refuses:" in text
    name, sweep = next(iter(load_study(tmp_path / "study.json")["tiers"]["smoke"]["passages"].items()))
    place = f"/tiers/smoke/passages/{name}/row_shifts_um/{len(sweep['row_shifts_um']) - 1}"
    assert (
        f"{place}: /geometry/row_shift_um = 4.1: allowed is a multiple of the lattice spacing = 0.8 um"
        in text
    )


@needs_solver
def test_a_row_shift_beyond_the_pitch_is_refused_at_its_place_in_the_tier_that_has_it(root, tmp_path):
    def change(tiers):
        tiers["paper"]["streamlines"]["row_shifts_um"].append(40)

    text = refusal(root, tmp_path, change, "fine")
    assert "/tiers/paper/streamlines/row_shifts_um/8: /geometry/row_shift_um = 40" in text
    assert "less than the pitch of 32 um" in text


@needs_solver
def test_a_bracket_with_steps_beside_the_lattice_is_refused(root, tmp_path):
    def change(tiers):
        for entry in tiers["smoke"]["boundary"]["mirror"].values():
            entry["step_um"] = 0.5

    assert "/geometry/row_shift_um" in refusal(root, tmp_path, change)


@needs_solver
def test_the_solver_and_the_planner_resolve_alike(root):
    for tier in ("smoke", "fine"):
        cases = list(cases_of(load_plan(root / "params/studies/krueger2014.json", tier)).values())
        for case, answer in zip(cases, answers(cases, DLD), strict=True):
            assert answer["sections"] == [name for name in case if name != "scene"]
            assert {name: answer["case"][name] for name in case} == case


@needs_solver
def test_the_answer_is_kept_until_the_plan_or_the_solver_changes(root, tmp_path):
    path, kept = root / "params/studies/krueger2014.json", tmp_path / "kept.json"
    plan = load_plan(path, "smoke")
    first = seconds_of_runs(path, plan, CASE_SCHEMA, DLD, kept)
    assert set(first) >= {run["id"] for run in plan["runs"]} and min(first.values()) > 0
    before = read_json(kept)
    kept.write_text(json.dumps(before | {"seconds": {"kept": 1}}), encoding="utf-8")
    assert seconds_of_runs(path, plan, CASE_SCHEMA, DLD, kept) == {"kept": 1}
    fewer = plan | {"runs": plan["runs"][1:]}
    assert seconds_of_runs(path, fewer, CASE_SCHEMA, DLD, kept) != {"kept": 1}


@needs_solver
def test_a_case_in_si_units_is_the_run_of_its_capillary_number():
    plain = {"scene": "passage", "geometry": {"row_shift_um": 3.2}}
    driven = plain | {"operating": {"mean_speed_um_per_s": 800, "viscosity_mPa_s": 1.2}}
    case = resolved(driven, CASE_SCHEMA)
    number = case["cell"]["capillary_number"]
    assert "operating" not in case and number != CASE_SCHEMA["properties"]["cell"]["properties"][
        "capillary_number"
    ].get("default")
    same = resolved(plain | {"cell": {"capillary_number": number}}, CASE_SCHEMA)
    assert run_id(case, 4) == run_id(same, 4)
    # Pressure gradient: Ca = p' l r / kS without any estimate.
    driven["operating"] = {"pressure_gradient_Pa_per_m": 1e5, "shear_modulus_uN_per_m": 5}
    number = resolved(driven, CASE_SCHEMA)["cell"]["capillary_number"]
    assert number == pytest.approx(1e5 * (12 * 4.8) ** 0.5 * 3.9e-12 / 5e-6, rel=1e-12)


@needs_solver
def test_a_drive_that_is_given_twice_is_refused():
    driven = {"scene": "passage", "operating": {"mean_speed_um_per_s": 800, "pressure_gradient_Pa_per_m": 1}}
    with pytest.raises(ValueError, match="/operating = pressure_gradient_Pa_per_m, mean_speed_um_per_s"):
        resolved(driven, CASE_SCHEMA)


def test_si_units_without_a_solver_say_what_to_build(monkeypatch, tmp_path):
    monkeypatch.setattr("study.planning.dld.DLD", tmp_path / "dld")
    driven = {"scene": "passage", "operating": {"mean_speed_um_per_s": 801}}
    with pytest.raises(ValueError, match="build it first: cmake"):
        resolved(driven, CASE_SCHEMA)


def test_a_solver_older_than_its_sources_is_not_asked(tmp_path):
    dld, source = tmp_path / "dld", tmp_path / "main.cpp"
    source.touch()
    assert not is_current(dld, [source])
    dld.touch()
    os.utime(source, (1, 1))
    assert is_current(dld, [source])
    os.utime(dld, (0.5, 0.5))
    assert not is_current(dld, [source])


def test_a_solver_without_an_answer_is_named(tmp_path):
    dld = tmp_path / "dld"
    dld.write_text("#!/bin/sh\necho 'no such command' >&2\nexit 1\n", encoding="utf-8")
    dld.chmod(0o755)
    with pytest.raises(RuntimeError, match=r"dld resolve: exit 1: no such command"):
        answers([{"scene": "passage"}], dld)
