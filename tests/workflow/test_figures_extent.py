"""The figures of rules and choices on made-up tables: what they count, mark and leave out."""

import json

import pandas as pd
import pytest
from study.drawing.wording import WORDS, words

A_PRIORI = (
    "sweep,row_shift_um,capillary_number,class,predicted_tweezer,predicted_centre,right_tweezer,right_centre"
)
SUMMARY = "sweep,rule,right,wrong,left_out,hit_rate,node_updates"
SENSITIVITY = (
    "choice,value,observable,row_shift_um,capillary_number,result,low,high,class,change,relative_change,unit"
)


@pytest.fixture
def draw(tmp_path, call):
    """Draws a figure from tables given as header and rows; returns the CSV beside it."""
    plan = tmp_path / "plan.json"
    plan.write_text(json.dumps({"figures": {"trajectory_sweep": "grid"}, "note": ""}), encoding="utf-8")

    def run(script, **tables):
        files = {}
        for name, (header, rows) in tables.items():
            files[name] = tmp_path / f"{name}.csv"
            files[name].write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
        csv, output = tmp_path / f"{script}.csv", tmp_path / f"{script}.pdf"
        call(script, plan=plan, **files, csv=csv, output=output)
        assert output.stat().st_size > 0
        assert output.with_suffix(".png").stat().st_size > 0
        return pd.read_csv(csv)

    return run


def test_a_priori_keeps_cells_that_no_rule_judges(draw):
    rows = [
        "grid,6.8,0.1,displaced,displaced,displaced,1,1",
        "grid,6.8,0.4,displaced,zigzag,displaced,0,1",
        "grid,6.8,1.0,undecided,zigzag,zigzag,,",
        "grid,6.8,1.5,diverged,zigzag,,,",
        "corrected,6.8,0.1,displaced,displaced,displaced,1,1",
    ]
    summary = ["grid,tweezer,1,1,2,0.5,4e8", "grid,centre,2,0,2,1.0,1.5e11", "corrected,tweezer,1,0,0,1,1"]
    table = draw("fig_a_priori", table=(A_PRIORI, rows), summary=(SUMMARY, summary))
    assert len(table) == 4
    assert set(table.hit_rate_tweezer) == {0.5}
    assert table.right_tweezer.sum() == 1


def test_sensitivity_marks_a_changed_class(draw):
    point = '"d_perp(d=6.8, Ca=0.3)",6.8,0.3'
    rows = [
        f"default,,{point},6.0,,,displaced,,,um",
        f"kernel,phi3,{point},6.1,,,displaced,0.1,0.0167,um",
        f"capillary_factor,1.6,{point},5.4,,,zigzag,-0.6,-0.1,um",
        f"viscosity_ratio,1,{point},,,,diverged,,,um",
        "default,,critical_ca(d=6.8),6.8,,0.44,0.4,0.48,open,,,1",
        "kernel,phi3,critical_ca(d=6.8),6.8,,0.40,0.38,0.42,open,-0.04,-0.09,1",
        "walls,half-way,critical_ca(d=6.8),6.8,,,2.4,,all-displaced,,,1",
        "lateral_flow,blocked,critical_ca(d=6.8),6.8,,,0.2,,all-displaced,,,1",
    ]
    table = draw("fig_sensitivity", table=(SENSITIVITY, rows))
    changed = table[table.observable.str.startswith("d_perp")].set_index("choice").class_changed
    assert changed.to_dict() == {"kernel": 0, "capillary_factor": 1, "viscosity_ratio": 1}
    assert "default" not in set(table.choice)
    critical = table[table.observable.str.startswith("critical_ca")].set_index("choice")
    assert critical.at_least["walls"] == pytest.approx(2.4 - 0.44)
    assert critical.at_least[["kernel", "lateral_flow"]].isna().all()  # known; an end that says nothing
    assert critical.words["walls"] == "half-way (staircase) walls"


def test_every_choice_of_the_study_has_words(study):
    for tier in study["tiers"].values():
        choices = tier["sensitivity"]["choices"]
        pairs = {(choice, value) for choice, values in choices.items() for value in values}
        assert pairs <= set(WORDS)
    assert len(set(WORDS.values())) == len(WORDS)
    assert words("kernel", "phi5") == "kernel: phi5"


@pytest.mark.parametrize(
    ("script", "headers"),
    [
        ("fig_a_priori", {"table": A_PRIORI, "summary": SUMMARY}),
        ("fig_sensitivity", {"table": SENSITIVITY}),
    ],
)
def test_empty_tables_give_a_figure(draw, script, headers):
    assert draw(script, **{name: (header, []) for name, header in headers.items()}).empty
