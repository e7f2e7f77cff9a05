"""The view of the tables for a reading: names, numbers and classes, each from where it has to come."""

import pandas as pd
import pytest
from claim_tables import DEFAULT, NUMBERS, SHIFTS, bracket, fit_rows, judged, passage, tables
from study.paper.claims import grid, load_claims
from study.paper.readings import class_within, view
from study.planning.documents import read_json
from study.planning.points import merged

OTHER = {"id": "other", "sweep": "other", "series": "other"}
FACTOR = DEFAULT | {"id": "ca-2", "capillary_factor": 2.0}
BLOCKED = {"id": "blocked", "series": "blocked", "flow_variant": "blocked-lateral"}


def label_at(seen, shift, capillary):
    """The class that the checks see at a point; None without one."""
    rows = grid(seen).set_index(["row_shift_um", "capillary_number"]).label
    return rows.get((shift, capillary))


@pytest.fixture
def claims(root):
    return load_claims(root / "params/claims.json")


def test_every_reading_has_its_runs_in_the_study(root, study):
    readings, tier = read_json(root / "params/claims.json")["readings"], study["tiers"]["paper"]
    assert [readings[0][key] for key in ("id", "sweep", "series")] == ["default", "grid", "default"]
    assert len({reading["id"] for reading in readings}) == len(readings)
    for reading in readings:
        assert reading["series"] in tier["boundary"]["series"], reading
        assert reading["sweep"] in tier["passages"], reading
        assert reading.get("flow_variant", "paper") in tier["streamlines"]["variants"], reading
        case = merged({"cell": {}, "fluid": {}}, tier["boundary"]["series"][reading["series"]]["case"])
        assert case["cell"].get("bending_law") == reading.get("bending_law"), reading
        assert (case["fluid"].get("lateral_flow") == "blocked") == ("flow_variant" in reading), reading


def test_the_view_of_the_default_is_its_own_tables():
    given = tables([passage("inertia", 6.8, 0.7)], [bracket("other", 6.8, 0.2, 0.3)])
    seen = view(given, DEFAULT)
    assert len(seen["cells"]) == len(SHIFTS) * sum(number <= 1.5 for number in NUMBERS)
    for name, table in given.items():
        order = ["sweep", "run"] if "sweep" in table else list(table.columns[:2])
        frames = [part.sort_values(order).reset_index(drop=True) for part in (seen[name], table)]
        if name == "a_priori":
            frames[1] = frames[1][frames[1].sweep == "grid"].reset_index(drop=True)
        pd.testing.assert_frame_equal(*frames, check_dtype=False)


def test_a_sweep_stands_under_the_name_of_the_default_and_alone():
    rows = [passage("other", 6.8, number, "displaced", film_um=0.1) for number in NUMBERS]
    seen = view(tables([*rows, passage("inertia", 6.8, 0.7), passage("grid-refined", 6.8, 0.7)]), OTHER)
    assert set(seen["passages"].sweep) == {"grid"}
    assert set(grid(seen).film_um) == {0.1}
    assert label_at(seen, 6.8, 1.5) == "displaced"
    assert set(seen["a_priori"].run) == {row["run"] for row in rows}
    assert set(seen["a_priori"].sweep) == {"grid"}
    assert seen["critical_row_shift"].empty


def test_brackets_and_fits_stand_under_the_name_of_the_default():
    given = tables(brackets=[bracket("other", 6.8, 0.2, 0.3)])
    given["fits"] = pd.concat([given["fits"], pd.DataFrame(fit_rows("boundary/other", rate=0.5))])
    seen = view(given, OTHER)
    assert list(seen["phase_boundary"].query("series == 'default'").row_shift_um) == [6.8]
    fits = seen["fits"].set_index(["name", "parameter"]).value
    assert fits["boundary/default", "rate"] == 0.5
    assert ("boundary/default", "offset_um") not in fits.index
    assert fits["separation-law/paper", "B"] == 0.76


def test_numbers_are_divided_by_the_factor_and_what_is_per_number_is_multiplied():
    given = tables([passage("inertia", 6.8, 0.7)], [bracket("default", 6.8, 0.4, 0.5)])
    seen = view(given, FACTOR)
    assert {0.05, 0.075, 1.2} <= set(seen["passages"].capillary_number)
    assert label_at(seen, 6.8, 0.1) == printed(6.8, 0.2)
    assert 0.35 in set(seen["passages"].query("sweep == 'inertia'").capillary_number)
    ends = seen["phase_boundary"].iloc[-1][["ca_displaced", "ca_zigzag", "ca_undisputed_zigzag"]]
    assert list(ends) == [0.2, 0.25, 0.25]
    rate = seen["fits"].set_index(["name", "parameter"]).loc[("boundary/default", "rate")]
    assert list(rate[["value", "low", "high"]]) == pytest.approx([3.44, 3.24, 3.64])
    assert seen["fits"].set_index(["name", "parameter"]).value["separation-law/paper", "B"] == 0.76
    assert seen["units"].pressure_gradient_bar_per_m.to_list() == pytest.approx([0.3582, 5.3718])
    assert sorted(set(seen["cells"].capillary_number)) == [number for number in NUMBERS if number <= 1.5]
    assert given["fits"].value.max() == 19.2  # nothing of this touches the tables themselves


def printed(shift, capillary):
    return passage("", shift, capillary)["class"]


def test_with_a_factor_the_tweezer_predicts_by_the_printed_number():
    seen = view(tables(), FACTOR)["a_priori"].set_index(["row_shift_um", "capillary_number"])
    row = seen.loc[(6.8, 0.5)]  # a run at Ca = 1, a pull of 45 pN
    assert row.tweezer_um == pytest.approx(8 - 0.901 / 2, abs=0.001)
    assert row.right_tweezer == (row["class"] == "displaced")  # the diameter is above 2 s = 5 um
    assert set(seen.right_tweezer) == {0.0, 1.0}


def test_a_class_is_told_by_a_bracket_up_to_its_ends_and_not_between_them_or_beyond():
    seen = view(tables(brackets=[bracket("other", 6.8, 0.3, 0.5), bracket("other", 4.4, 0.7, None)]), OTHER)
    assert [label_at(seen, 6.8, ca) for ca in (0.1, 0.3)] == ["displaced", "displaced"]
    assert label_at(seen, 6.8, 0.4) is None
    assert [label_at(seen, 6.8, ca) for ca in (0.5, 1.5)] == ["zigzag", "zigzag"]
    assert label_at(seen, 4.4, 0.7) == "displaced"
    assert label_at(seen, 4.4, 0.8) is None  # all displaced as far as was tried
    assert label_at(seen, 5.2, 0.1) is None  # without a bracket
    row = grid(seen).iloc[-1]
    assert row.run == "other-6.8-a other-6.8-b"
    assert pd.isna(row.d_perp_um)


def test_the_undisputed_ends_count():
    one = bracket("other", 6.8, 0.3, 0.4, ca_undisputed_displaced=0.2, ca_undisputed_zigzag=0.5)
    seen = view(tables(brackets=[one]), OTHER)
    assert [label_at(seen, 6.8, ca) for ca in (0.2, 0.3, 0.4, 0.5)] == ["displaced", None, None, "zigzag"]
    assert class_within(pd.Series(bracket("other", 8.0, float("nan"), 0.1)), 0.1) == "zigzag"


@pytest.mark.parametrize("sweep", ["other", "boundary/other"])
def test_a_run_wins_over_a_bracket_even_undecided(sweep):
    runs = [passage(sweep, 6.8, 0.2, "undecided"), passage(sweep, 6.8, 0.5, "displaced", d_perp_um=4.2)]
    seen = view(tables(runs, [bracket("other", 6.8, 0.3, 0.5)]), OTHER)
    assert [label_at(seen, 6.8, ca) for ca in (0.1, 0.2, 0.5)] == ["displaced", "undecided", "displaced"]
    rows = grid(seen).set_index("capillary_number")
    assert rows.index.is_unique
    assert rows.run[0.5] == f"{sweep}-6.8-0.5" and rows.d_perp_um[0.5] == 4.2


def test_runs_of_a_bracket_count_at_the_cells_of_the_default_alone_and_after_the_sweep():
    runs = [passage("boundary/other", 6.8, 0.2, "zigzag"), passage("boundary/other", 6.8, 0.21)]
    seen = view(tables([*runs, passage("other", 6.8, 0.2, "displaced")]), OTHER)
    assert list(grid(seen).capillary_number) == [0.2]
    assert label_at(seen, 6.8, 0.2) == "displaced"


def test_the_flow_of_a_reading_takes_the_place_of_the_papers(claims):
    assert judged(claims, "resistance", tables()).reproduced
    other = judged(claims, "resistance", tables(), BLOCKED)
    assert not other.reproduced and other.difference == pytest.approx(100 * (9.0 / 8.8 - 1))
    assert other.runs[0].startswith("blocked-lateral")
    assert "18.500" in judged(claims, "separation-law", tables(), BLOCKED).measured
    for name in ("stokes-linear", "stokes-mirror", "unit-conversion"):
        assert judged(claims, name, tables())
        assert judged(claims, name, tables(), BLOCKED) is None


def test_another_law_of_bending_has_no_tweezer_of_its_own(claims):
    rows = [passage("other", shift, number) for shift in SHIFTS for number in NUMBERS]
    for reading, there in ((OTHER, True), (OTHER | {"bending_law": "hinge_sheet"}, False)):
        for name in ("tweezer", "tweezer-master-curve", "a-priori"):
            assert (judged(claims, name, tables(rows), reading) is not None) == there, name
        assert judged(claims, "cell-area", tables(rows), reading).reproduced  # the mesh at rest is the same


def test_a_claim_without_runs_in_a_reading_is_not_run_in_it(claims):
    given = tables(brackets=[bracket("other", 6.8, 0.15, 0.3)])
    assert judged(claims, "eps-17-stiff-displaced", given, OTHER).reproduced
    for name in ("eps-5-all-displaced", "eps-13-zigzag", "window", "design-example", "inertia", "d-perp-6.8"):
        assert judged(claims, name, given, OTHER) is None, name
