"""Plans: tiers, resolved cases, identities."""

import copy
import os

import pytest
from study.planning.cases import resolved, run_id
from study.planning.documents import SCHEMAS, problems, read_json
from study.planning.plan import make_plan
from study.planning.plan_file import ids, study_brackets, write_plan
from study.planning.points import STUDY_GROUPS, merged
from study.planning.tiers import expanded

GROUPS = {"streamlines", "stokes", "stretching", "passages", "boundary", "sensitivity", "sensitivity-flow"}
GROUPS |= {
    "stability",
    "long-run",
    "accuracy-flow",
    "accuracy-tweezer",
    "accuracy-passages",
    "settings-check",
    "uncertainty",
}
CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")


def identity(case, model=1):
    return run_id(resolved(case, CASE_SCHEMA), model)


@pytest.mark.parametrize("tier", ["smoke", "paper", "fine"])
def test_every_tier_has_a_valid_plan_with_all_groups(study, tier):
    plan = make_plan(study, tier, CASE_SCHEMA)
    assert {run["group"] for run in plan["runs"]} - {"uncertainty-cells"} == GROUPS
    for run in plan["runs"]:
        assert problems(run["case"], CASE_SCHEMA) == []


def test_the_quick_tier_asks_for_a_part_of_the_papers_runs_and_narrows_nothing(study):
    quick, paper = (make_plan(study, tier, CASE_SCHEMA) for tier in ("quick", "paper"))
    asked, known = (set(ids(plan, *STUDY_GROUPS)) for plan in (quick, paper))
    assert asked < known
    assert {bracket["levels"] for bracket in quick["brackets"].values()} == {0}
    assert {"sensitivity", "uncertainty"}.isdisjoint(run["group"] for run in quick["runs"])


def test_a_null_takes_away_what_the_extended_tier_has_and_nothing_else():
    tiers = {
        "base": {"a": {"b": 1, "c": 2}, "d": 3},
        "less": {"extends": "base", "a": {"b": None}, "d": None},
        "again": {"extends": "less", "d": 4},
        "wrong": {"extends": "base", "a": {"bb": None}},
    }
    assert expanded(tiers, "less") == {"a": {"c": 2}}
    assert expanded(tiers, "again") == {"a": {"c": 2}, "d": 4}
    with pytest.raises(ValueError, match=r"/tiers/wrong/a/bb: .* no 'bb'; "):
        expanded(tiers, "wrong")


def test_unknown_tier_is_named_with_the_known_ones(study):
    with pytest.raises(ValueError, match=r"no tier 'big'.*fine, paper, quick, smoke"):
        make_plan(study, "big", CASE_SCHEMA)


def test_identity_does_not_depend_on_order_spelling_or_written_defaults():
    plain = {"scene": "passage", "geometry": {"row_shift_um": 6}, "cell": {"capillary_number": 0.5}}
    spelled = {
        "cell": {"capillary_number": 0.5, "radius_um": 3.9},
        "geometry": {"pitch_um": 32, "row_shift_um": 6.0},
        "scene": "passage",
    }
    assert identity(plain) == identity(spelled)


def test_identity_depends_on_every_parameter_of_the_scene_and_on_the_solver_model():
    plain = {"scene": "streamlines", "geometry": {"row_shift_um": 6.0}}
    other = {"scene": "streamlines", "geometry": {"row_shift_um": 6.0}, "fluid": {"collision": "bgk"}}
    assert len({identity(plain), identity(other), identity(plain, 2)}) == 3


def test_identity_ignores_sections_that_the_scene_does_not_read():
    with_cell = {"scene": "streamlines", "cell": {"capillary_number": 1.2}}
    assert identity({"scene": "streamlines"}) == identity(with_cell)


def test_two_variants_of_the_same_point_share_a_run(study):
    tier = copy.deepcopy(study["tiers"]["smoke"])
    tier["streamlines"]["variants"]["twin"] = tier["streamlines"]["variants"]["accurate"]
    plan = make_plan(study | {"tiers": {"t": tier}}, "t", CASE_SCHEMA)
    runs = [run for run in plan["runs"] if run["labels"].get("variant") in ("accurate", "twin")]
    assert len({run["id"] for run in runs}) == len(runs) / 2
    assert len(ids(plan, "streamlines")) < sum(run["group"] == "streamlines" for run in plan["runs"])


def test_row_shifts_and_depths_are_whole_on_every_lattice(study):
    for tier in study["tiers"]:
        for run in make_plan(study, tier, CASE_SCHEMA)["runs"]:
            spacing = run["case"]["fluid"]["lattice_spacing_um"]
            geometry = run["case"]["geometry"]
            lengths = [geometry["row_shift_um"], geometry["pitch_um"], 0.5 * geometry["depth_um"]]
            if run["case"]["scene"] != "stretching":
                lengths[-1] *= 2 if geometry["height"] == "full" else 1
                assert all(abs(length / spacing - round(length / spacing)) < 1e-6 for length in lengths), run


def test_merged_overlays_leaf_by_leaf():
    assert merged({"a": {"b": 1, "c": 2}}, {"a": {"c": 3}, "d": 4}) == {
        "a": {"b": 1, "c": 3},
        "d": 4,
    }


def test_a_tier_that_extends_another_adds_to_it(study):
    fine, paper = (make_plan(study, tier, CASE_SCHEMA) for tier in ("fine", "paper"))
    assert set(paper["brackets"]) < set(fine["brackets"])
    assert set(ids(paper, "passages")) < set(ids(fine, "passages"))


def test_a_bracket_knows_the_runs_of_the_sweeps_on_its_axis(study):
    plan = make_plan(study, "paper", CASE_SCHEMA)
    grid = {
        run["case"]["cell"]["capillary_number"]: run["id"]
        for run in plan["runs"]
        if run["labels"].get("sweep") == "grid" and run["case"]["geometry"]["row_shift_um"] == 4.4
    }
    assert dict(plan["brackets"]["default/d4.4"]["known"]) == grid
    mirror = plan["brackets"]["row-shift-0.4/ca0.5"]["known"]
    assert [shift for shift, _ in mirror] == study["tiers"]["paper"]["passages"]["grid"]["row_shifts_um"]


def test_a_row_shift_may_have_a_range_of_its_own(study):
    changed = copy.deepcopy(study)
    series = changed["tiers"]["paper"]["boundary"]["series"]["default"]
    series["ca_ranges"] = {"6.8": [0.3, 0.6]}
    brackets = make_plan(changed, "paper", CASE_SCHEMA)["brackets"]
    ends = [capillary for capillary, _ in brackets["default/d6.8"]["known"]]
    assert (ends[0], ends[-1]) == (0.3, 0.6)
    assert [capillary for capillary, _ in brackets["default/d6"]["known"]][-1] == 2.4
    series["ca_ranges"] = {"6.9": [0.3, 0.6]}
    with pytest.raises(ValueError, match=r"default: /ca_ranges/6.9: allowed are its row shifts, 2, 3.2"):
        make_plan(changed, "paper", CASE_SCHEMA)


def test_names_that_the_study_refers_to_exist(study):
    for name in study["tiers"]:
        tier = study["tiers"][name]
        series = set(tier["boundary"]["series"])
        boundary = tier["sensitivity"]["boundary"]
        assert boundary["reference"] in series or not boundary["choices"]
        assert set(boundary["choices"]) <= set(tier["sensitivity"]["choices"])
        plan = make_plan(study, name, CASE_SCHEMA)
        known = {bracket["series"] for bracket in study_brackets(plan).values()}
        for values in tier["sensitivity"]["choices"].values():
            assert {entry["series"] for entry in values.values() if "series" in entry} <= known
        variants = set(tier["streamlines"]["variants"])
        for members in tier["streamlines"]["refinement"].values():
            assert set(members) <= variants


def test_the_written_plan_changes_with_its_content_only(tmp_path):
    path = tmp_path / "results/plan.json"
    plan = {"tier": "t", "runs": [{"id": "a"}, {"id": "b"}], "brackets": {"c": {"levels": 2}}}
    assert write_plan(plan, path) == path
    assert read_json(path) == plan
    os.utime(path, (1, 1))
    write_plan(plan, path)
    assert path.stat().st_mtime == 1
    write_plan(plan | {"tier": "other"}, path)
    assert read_json(path)["tier"] == "other"
    assert path.stat().st_mtime > 1
    assert [file.name for file in path.parent.iterdir()] == ["plan.json"]
