"""Frontiers, limits, and the judgement of runs on made-up numbers; scripts of the study on made-up runs."""

import numpy as np
import pandas as pd
import pytest
from study.analysis import accuracy, class_rules, frontier


def test_frontier_keeps_what_nothing_dominates():
    costs = [1, 2, 3, 4, 2, np.nan, 5]
    errors = [8, 4, 5, 1, 4, 0.1, np.nan]
    assert list(frontier.on_frontier(costs, errors)) == [True, True, False, True, True, False, False]


def test_frontier_of_equal_costs_keeps_the_most_accurate():
    assert list(frontier.on_frontier([1, 1, 1], [3, 2, 2.5])) == [False, True, False]


def test_step_line_goes_right_then_down():
    x, y = frontier.step_line([10, 1], [1, 5])
    assert (list(x), list(y)) == ([1, 10, 10], [5, 5, 1])


def test_straight_limit_and_its_standard_error():
    h = np.array([0.8, 0.4, 0.2, 0.1])
    value, error = frontier.straight_limit(h, 3 + 2 * h, 1)
    assert value == pytest.approx(3) and error < 1e-12
    noise = 0.01 * np.array([1, -1, -1, 1])
    value, error = frontier.straight_limit(h, 3 + 2 * h + noise, 1)
    assert 0 < abs(value - 3) < 3 * error
    with pytest.raises(ValueError, match="three points"):
        frontier.straight_limit([0.2, 0.1], [1, 2], 1)


def made_up(method, setting, spacing, value, cost, status="displaced", point="p"):
    labels = {"study": "passages", "method": method, "setting": setting, "point": point}
    observed = {"D_perp, relative": np.array([value])} if value is not None else {}
    return labels | {
        "work_units": cost,
        "seconds": None,
        "spacing": spacing,
        "status": status,
        "observed": observed,
    }


DEFINITIONS = {"other": {"methods": ["other"], "order": 1}}
LADDER = [made_up("other", f"{h}", h, 5 + h, 1 / h) for h in (0.4, 0.2, 0.1)]


def judged(row):
    limits = accuracy.references(DEFINITIONS, LADDER)
    classes = accuracy.expected_classes(DEFINITIONS, LADDER)
    return next(iter(accuracy.judged("passages", row, "other", limits, classes)))


def test_a_run_is_judged_by_the_limit_of_the_other_ladder():
    found = judged(made_up("mine", "0.4", 0.4, 5.5, 7))
    assert found["reference_value"] == pytest.approx(5.0)
    assert found["error"] == pytest.approx(0.1)
    assert found["status"] == "ok"


def test_another_class_and_failed_runs_are_no_good_rows():
    assert judged(made_up("mine", "a", 0.4, 5.5, 7, "zigzag"))["status"] == "other class"
    failed = judged(made_up("mine", "b", 0.4, None, 7, "diverged"))
    assert failed["status"] == "diverged" and failed["error"] is None


def test_over_points_takes_the_worst_error_the_whole_cost_and_the_first_failure():
    rows = [judged(made_up("mine", "0.4", 0.4, value, 7)) for value in (5.5, 6.0)]
    joined = next(iter(accuracy.over_points(rows)))
    assert (joined["error"], joined["work_units"], joined["status"]) == (pytest.approx(0.2), 14, "ok")
    rows[1]["status"], rows[1]["error"] = "diverged", None
    joined = next(iter(accuracy.over_points(rows)))
    assert joined["error"] is None and joined["status"] == "diverged"


def test_frontier_does_not_reward_errors_below_the_references_uncertainty():
    rows = [
        judged(made_up("mine", name, 0.4, value, cost))
        for name, value, cost in (("cheap", 5.05, 1), ("lucky", 5.0, 9))
    ]
    for row in rows:
        row["reference_uncertainty"] = 0.02
    assert [row["on_frontier"] for row in accuracy.mark_frontiers(rows)] == [True, False]


PASSAGES = [
    ("displaced", [True] * 5, np.linspace(0.2, 1, 5), 100.0),
    ("zigzag", [True, True, False, True, False], np.linspace(0.2, 1, 5), 100.0),
    ("displaced", [True, False, True, True, True], np.linspace(0.2, 1, 5), 100.0),
]


def test_rules_for_the_class_count_wrong_answers_and_the_work_up_to_the_line():
    error, work = class_rules.judged_rule(class_rules.any_zig, PASSAGES, 1)
    assert (error, work) == (pytest.approx(2 / 3), pytest.approx(3 * 40))
    assert class_rules.judged_rule(class_rules.any_zig, PASSAGES, 2) == (
        pytest.approx(1 / 3),
        pytest.approx(180),
    )
    assert class_rules.judged_rule(class_rules.last_line, PASSAGES, 2)[0] == 0
    assert class_rules.judged_rule(class_rules.any_zig, PASSAGES, 9) == (0, 300)  # over before


def test_second_starts_count_changed_classes():
    point = {"device": "circle", "cell": "healthy", "dx_um": 0.4, "lateral_flow": "free"}
    point |= {"skalak_denominator": 12, "capillary_number": 0.5}
    pairs = [(4.4, "displaced", "displaced"), (6.0, "displaced", "zigzag"), (6.8, "undecided", "zigzag")]
    rows = [
        point | {"row_shift_um": shift, "epsilon": shift / 32, "sweep": sweep, "class": label}
        for shift, *labels in pairs
        for sweep, label in zip(("grid", "second-start"), labels, strict=True)
    ]
    assert class_rules.second_starts(pd.DataFrame(rows)) == (0.5, 2)


@pytest.fixture(scope="module")
def table(results, call):
    """Cost table, diagrams and conclusions of a tier of made-up runs."""
    folder = results / "tables"
    plan = {"plan": results / "plan.json"}
    cheap, output = folder / "accuracy_cheap_models.csv", folder / "accuracy_cost.csv"
    call("accuracy_cheap_models", **plan, output=cheap)
    call("accuracy_table", **plan, runs=results / "runs", cheap=cheap, output=output)
    return output


def test_the_table_has_every_method_at_every_point_and_over_all(table, results):
    rows = pd.read_csv(table)
    assert {"study", "method", "setting", "error", "error_kind", "work_units", "seconds"} <= set(rows.columns)
    assert {"on_frontier", "status"} <= set(rows.columns)
    assert set(rows.study) == {"flow", "tweezer", "passages"}
    for _, part in rows.groupby(["study", "error_kind", "point"]):
        assert part.on_frontier.sum() >= 1 or (part.status != "ok").all()
    exact = rows[(rows.method == "depth-averaged flow") & (rows.point == "all")]
    assert len(exact) and (exact.error > 0).all()


@pytest.fixture(scope="module")
def check(results, call):
    """Table of fast and conservative settings, of made-up runs."""
    output = results / "tables" / "settings_check.csv"
    call("settings_check", plan=results / "plan.json", runs=results / "runs", output=output)
    return output


def test_settings_check_compares_the_same_point(check, study):
    rows = pd.read_csv(check)
    checks = [study["tiers"][tier]["accuracy"]["settings_check"] for tier in ("smoke", "paper")]
    names = rows.settings.unique()
    fitting = [part for part in checks if set(names) == set(part["settings"])]
    assert len(rows) in {len(names) * len(part["points"]) for part in fitting}
    assert (rows.run != rows.conservative_run).all()
    change = rows.d_perp_um / rows.conservative_d_perp_um - 1
    assert np.allclose(rows.d_perp_relative_change, change, atol=2e-4)
    assert (rows.same_class == (rows["class"] == rows.conservative_class)).all()


def test_diagrams_and_conclusions_follow_from_the_table(table, check, results, call, call_apart):
    plan = {"plan": results / "plan.json", "table": table}
    for study in ("flow", "tweezer", "passages"):
        pdf = results / "figures" / f"work_precision_{study}.pdf"
        call("work_precision", **plan, study=study, csv=pdf.with_suffix(".csv"), output=pdf)
        first = pdf.read_bytes()
        call_apart("work_precision", **plan, study=study, csv=pdf.with_suffix(".csv"), output=pdf)
        assert pdf.read_bytes() == first
        assert pdf.with_suffix(".png").stat().st_size > 10_000
    text = results / "accuracy_conclusions.md"
    call("accuracy_conclusions", **plan, check=check, runs=results / "runs", output=text)
    written = text.read_text(encoding="utf-8")
    assert "## Fast settings against conservative ones" in written
    ladder = [line for line in written.splitlines() if line.startswith("| phi4 | ")]
    assert (
        len(ladder)
        == 3 * pd.read_csv(table).query("method == 'lattice, phi4' and point != 'all'").point.nunique()
    )
    points = pd.read_csv(table).query("study == 'passages' and point != 'all'").point.nunique()
    assert written.count("| error at most |") == 4 + 3 * points  # kinds of error, of passages at each point
    assert ("## Presets" in written) == ("fine" in results.name)


def test_the_convergence_figure_has_every_coupling_on_two_lattices_or_more(table, results, call):
    pdf = results / "figures" / "fig_convergence.pdf"
    plan = {"plan": results / "plan.json", "table": table, "runs": results / "runs"}
    call("fig_convergence", **plan, csv=pdf.with_suffix(".csv"), output=pdf)
    shown, rows = pd.read_csv(pdf.with_suffix(".csv")), pd.read_csv(table)
    passages = rows[
        (rows.study == "passages") & (rows.point != "all") & rows.method.str.startswith("lattice")
    ]
    known = passages.dropna(subset="value").groupby("method").spacing.nunique()
    assert set("lattice, " + shown.method) == set(known.index[known > 1])
    assert set(shown["class"]) <= {"displaced", "zigzag", "undecided"}
    plain = shown[(shown.method == "phi4") & (shown.error_kind == shown.error_kind.iloc[0])]
    found = passages[(passages.method == "lattice, phi4") & (passages.error_kind == shown.error_kind.iloc[0])]
    assert sorted(plain.value) == pytest.approx(sorted(found.value), abs=1e-4)
    assert pdf.with_suffix(".png").stat().st_size > 10_000
