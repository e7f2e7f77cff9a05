"""The figures of rules, choices and refinement on made-up tables: what they count, extrapolate, leave out."""

import json

import pandas as pd
import pytest

PASSAGES = "sweep,dx_um,skalak_denominator,lateral_flow,row_shift_um,capillary_number,class"
PASSAGES += ",d_perp_um,centre_um,film_um,run"
CROSSINGS = "run,row,bump"
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


def cell(sweep, dx, capillary, kind, values, run):
    return f"{sweep},{dx},12,free,6.8,{capillary},{kind},{values},{run}"


def test_refinement_extrapolates_comparable_cells_alone(draw):
    passages = [
        cell("grid", 0.4, 0.1, "displaced", "7.0,3.6,0.2", "a"),
        cell("grid-fine", 0.2, 0.1, "displaced", "7.2,3.5,0.05", "b"),
        cell("grid", 0.4, 0.4, "displaced", "6.0,3.0,0.2", "c"),
        cell("boundary/lattice-0.2", 0.2, 0.4, "zigzag", "5.9,2.9,0.1", "d"),
        cell("grid", 0.4, 1.2, "zigzag", "4.5,2.1,0.2", "e"),
        cell("grid-fine", 0.2, 1.2, "zigzag", "4.9,2.5,0.4", "f"),
        cell("grid", 0.4, 0.7, "diverged", ",,", "g"),
        cell("grid-fine", 0.2, 0.7, "zigzag", "5.0,2.2,0.1", "h"),
        cell("blocked-lateral", 0.2, 1.0, "zigzag", "5.0,2.2,0.1", "i"),
        cell("grid", 0.4, 1.0, "zigzag", "5.0,2.2,0.1", "j"),
    ]
    crossings = ["e,3,0", "e,9,0", "f,3,0", "f,8,0", "d,3,0", "d,8,0"]
    table = draw("fig_refinement", table=(PASSAGES, passages), crossings=(CROSSINGS, crossings))
    status = table.groupby(["observable", "capillary_number"]).status.first()
    assert status["d_perp_um"].to_dict() == {0.1: "limit", 0.4: "class differs", 1.2: "crossing differs"}
    assert status["film_um", 0.1] == "negative"
    limits = table[table.dx_um == 0].set_index("observable")
    assert limits.value["d_perp_um"] == pytest.approx(7.4)
    assert limits.change_percent["d_perp_um"] == pytest.approx(100 * 0.4 / 7.0, abs=0.01)


def test_refinement_uses_the_observed_order_of_three_lattices(draw):
    spacings = [("grid", 0.4), ("boundary/lattice-0.2", 0.2), ("boundary/lattice-0.1", 0.1)]
    passages = [
        cell(name, dx, 0.1, "displaced", f"{7 + dx**2:.6f},{3 + dx**2:.6f},{0.1 + dx**2:.6f}", name)
        for name, dx in spacings
    ]
    table = draw("fig_refinement", table=(PASSAGES, passages), crossings=(CROSSINGS, []))
    limits = table[table.dx_um == 0].set_index("observable")
    assert limits.order["d_perp_um"] == pytest.approx(2, abs=0.01)
    assert limits.value["d_perp_um"] == pytest.approx(7, abs=1e-3)


def test_a_priori_keeps_cells_that_no_rule_judges(draw):
    rows = [
        "grid,6.8,0.1,displaced,displaced,displaced,1,1",
        "grid,6.8,0.4,displaced,zigzag,displaced,0,1",
        "grid,6.8,1.0,undecided,zigzag,zigzag,,",
        "grid,6.8,1.5,diverged,zigzag,,,",
        "grid-fine,6.8,0.1,displaced,displaced,displaced,1,1",
    ]
    summary = ["grid,tweezer,1,1,2,0.5,4e8", "grid,centre,2,0,2,1.0,1.5e11", "grid-fine,tweezer,1,0,0,1,1"]
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
        "kernel,phi2,critical_ca(d=6.8),6.8,,,2.4,,all-displaced,,,1",
    ]
    table = draw("fig_sensitivity", table=(SENSITIVITY, rows))
    changed = table[table.observable.str.startswith("d_perp")].set_index("choice").class_changed
    assert changed.to_dict() == {"kernel": 0, "capillary_factor": 1, "viscosity_ratio": 1}
    assert "default" not in set(table.choice)


@pytest.mark.parametrize(
    ("script", "headers"),
    [
        ("fig_refinement", {"table": PASSAGES, "crossings": CROSSINGS}),
        ("fig_a_priori", {"table": A_PRIORI, "summary": SUMMARY}),
        ("fig_sensitivity", {"table": SENSITIVITY}),
    ],
)
def test_empty_tables_give_a_figure(draw, script, headers):
    assert draw(script, **{name: (header, []) for name, header in headers.items()}).empty
