"""What the boundary depends on: brackets with one thing changed against those without the change."""

import json
import math

import h5py
import pandas as pd
import pytest
from study.analysis.boundary import UNDISPUTED


def bracket(folder, series, shift, kind, classes):
    """A bracket of the plan; its last state {capillary number: class} is written to its folder."""
    name = f"{series}/d{shift:g}"
    points = [{"value": value, "class": label, "run": f"r{value}"} for value, label in classes.items()]
    (folder / name).mkdir(parents=True)
    state = {"points": points, "undecided_inside": 0}
    (folder / name / "level-1.json").write_text(json.dumps(state), encoding="utf-8")
    case = {"geometry": {"row_shift_um": shift}}
    found = {"series": series, "kind": kind, "axis": "capillary_number", "levels": 1, "case": case}
    return {name: found}


@pytest.fixture
def made(tmp_path, call, root):
    """Table and data of the figure: a stiffer law at two row shifts, at one of which it is open."""
    closed = {0.2: "displaced", 0.25: "zigzag"}
    flipping = {0.3: "displaced", 0.35: "zigzag", 0.4: "displaced", 0.5: "zigzag"}
    known = [
        ("corrected", 6.8, "boundary", closed),
        ("corrected", 6.0, "boundary", {0.4: "displaced", 0.5: "zigzag"}),
        ("corrected", 3.6, "boundary", closed),
        ("stiffer", 6.8, "uncertainty", flipping),
        ("stiffer", 6.0, "uncertainty", {0.5: "displaced", 0.8: "displaced"}),
        ("default", 6.8, "boundary", closed),
        ("default", 3.6, "boundary", closed),
    ]
    rows = [
        {"cause": "law", "setting": "8", "series": "stiffer", "reference": "corrected"},
        {"cause": "kernel", "setting": "2", "series": "default", "reference": "corrected"},
    ]
    plan = {"note": "", "uncertainty": rows, "brackets": {}}
    for one in known:
        plan["brackets"] |= bracket(tmp_path / "brackets", *one)
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    given = {"plan": tmp_path / "plan.json"}
    table, drawn, output = (tmp_path / name for name in ("table.csv", "drawn.csv", "figure.pdf"))
    call("boundary_uncertainty", **given, brackets=tmp_path / "brackets", output=table)
    claims = {"claims": root / "params/claims.json"}
    call("fig_boundary_uncertainty", **given, **claims, table=table, csv=drawn, output=output)
    assert output.with_suffix(".png").stat().st_size > 0
    return pd.read_csv(table), pd.read_csv(drawn)


def test_a_change_lies_between_what_both_brackets_allow(made):
    rows = made[0].set_index(["cause", "row_shift_um"])
    law = rows.loc[("law", 6.8)]
    assert tuple(law[UNDISPUTED]) == (0.3, 0.5)  # as far as passages contradict one another
    assert law.least_change_percent == pytest.approx(100 * (0.3 / 0.25 - 1))
    assert law.most_change_percent == pytest.approx(100 * (0.5 / 0.2 - 1))
    assert law.change_percent == pytest.approx(100 * ((0.3 * 0.5 / (0.2 * 0.25)) ** 0.5 - 1), abs=0.05)
    same = rows.loc[("kernel", 6.8)]
    assert (same.least_change_percent, same.change_percent, same.most_change_percent) == (-20, 0, 25)


def test_an_open_bracket_bounds_the_change_on_one_side(made):
    row = made[0].set_index(["cause", "row_shift_um"]).loc[("law", 6.0)]
    assert row.least_change_percent == pytest.approx(100 * (0.8 / 0.5 - 1))
    assert pd.isna(row.change_percent) and pd.isna(row.most_change_percent)


def test_only_row_shifts_at_which_the_target_changes_something_are_told(made):
    assert set(made[0].row_shift_um) == {6.0, 6.8}
    assert list(made[0].cause) == ["law", "law", "kernel"]  # at one row shift in the order of the study


def test_the_law_on_a_finer_lattice_is_compared_with_the_print(tmp_path, call, root):
    def brackets(series, law):
        for shift in (4.4, 5.2, 6.0, 6.8, 7.2):
            critical = -math.log((shift - law[0]) / law[1]) / law[2]
            yield {"series": series, "row_shift_um": shift} | dict(
                zip(UNDISPUTED, (0.99 * critical, 1.01 * critical), strict=True)
            )

    study = pd.DataFrame(list(brackets("default", (3.4, 5.4, 1.72))))  # the printed law, half a um higher
    finer = pd.DataFrame(list(brackets("refined", (2.9, 5.4, 1.72))))
    study.to_csv(tmp_path / "study.csv", index=False)
    pd.concat([finer, finer]).to_csv(tmp_path / "uncertainty.csv", index=False)  # two causes with one series
    files = {"boundary": tmp_path / "study.csv", "uncertainty": tmp_path / "uncertainty.csv"}
    files["claims"] = root / "params/claims.json"
    table = tmp_path / "laws.csv"
    call("boundary_lattices", **files, output=table)
    rows = pd.read_csv(table).set_index("series")
    assert rows.largest_distance_um["default"] == pytest.approx(0.5, abs=0.03)
    assert rows.largest_distance_um["refined"] < 0.03
    assert rows.brackets["refined"] == 5 and rows.brackets["reference"] == 0
    assert pd.isna(rows.offset_um["reference"])
    (tmp_path / "plan.json").write_text(json.dumps({"note": ""}), encoding="utf-8")
    drawn = {"csv": tmp_path / "drawn.csv", "output": tmp_path / "drawn.pdf", "cells": tmp_path / "cells.csv"}
    cells = {"row_shift_um": [6.8, 6.8], "capillary_number": [0.1, 0.3], "class": ["displaced", "displaced"]}
    pd.DataFrame(cells).assign(printed_class=["displaced", "zigzag"]).to_csv(drawn["cells"], index=False)
    call("fig_boundary_lattices", plan=tmp_path / "plan.json", **files, laws=table, **drawn)
    curves = pd.read_csv(tmp_path / "drawn.csv").query("kind == 'law'")
    assert set(curves.series) == {"default", "refined", "paper"}
    assert pd.read_csv(tmp_path / "drawn.csv").query("kind == 'cell'").printed_class.to_list() == [
        "displaced",
        "zigzag",
    ]


def test_cells_on_the_finer_lattice_stand_beside_the_grid_and_the_print(tmp_path, call, root):
    runs = []
    for number, (shift, status, extent) in enumerate([(6.8, "displaced", 6.6), (6.8, "zigzag", 5.7)]):
        case = {
            "geometry": {"row_shift_um": shift, "pitch_um": 32.0},
            "cell": {"capillary_number": 0.3},
            "fluid": {"lattice_spacing_um": 0.2},
        }
        labels = {"sweep": f"finer-{number}"}
        runs.append({"id": f"{number:012x}", "group": "uncertainty-cells", "labels": labels, "case": case})
        folder = tmp_path / "runs" / runs[-1]["id"]
        folder.mkdir(parents=True)
        h5py.File(folder / "run.h5", "w").close()
        summary = {"status": status, "d_perp_um": extent, "min_face_ratio": 0.9}
        (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    (tmp_path / "plan.json").write_text(json.dumps({"runs": runs}), encoding="utf-8")
    grid = {
        "sweep": "grid",
        "row_shift_um": 6.8,
        "capillary_number": 0.3,
        "class": "zigzag",
        "d_perp_um": 6.0,
    }
    pd.DataFrame([grid]).to_csv(tmp_path / "passages.csv", index=False)
    files = {"plan": tmp_path / "plan.json", "runs": tmp_path / "runs", "passages": tmp_path / "passages.csv"}
    table = tmp_path / "cells.csv"
    call("lattice_cells", **files, claims=root / "params/claims.json", output=table)
    rows = pd.read_csv(table)
    assert list(rows.printed_class) == ["zigzag", "zigzag"] and list(rows.as_printed) == [0, 1]
    assert list(rows.class_of_grid) == ["zigzag", "zigzag"]
    assert list(rows.change_percent) == [10.0, -5.0]


def test_the_figure_states_the_printed_boundary_beside_every_bracket(made):
    printed = made[1].groupby("row_shift_um").printed_ca.unique()
    assert printed[6.8] == pytest.approx([0.189], abs=1e-3)
    assert len(made[1]) == len(made[0])


def test_made_up_results_of_every_tier_give_table_and_figure(results, call, root, tmp_path):
    given, table = {"plan": results / "plan.json"}, tmp_path / "table.csv"
    call("boundary_uncertainty", **given, brackets=results / "brackets", output=table)
    rows = pd.read_csv(table)
    asked = {
        (row["cause"], str(row["setting"]))
        for row in json.loads((results / "plan.json").read_text(encoding="utf-8"))["uncertainty"]
    }
    assert asked == set(zip(rows.cause, rows.setting.astype(str), strict=True))
    if "fine" in results.name:  # a fold of the made-up cells is as stiff as the law says
        laws = rows[(rows.cause == "bending law") & (rows.row_shift_um == 6)].set_index("setting")
        assert laws.change_percent["hinge_sphere"] > 50
        assert laws.change_percent["hinge_sheet"] < -20
    for name, data in (("figure", table), ("empty", tmp_path / "none.csv")):
        if name == "empty":
            rows.iloc[:0].to_csv(data, index=False)
        files = {"csv": tmp_path / f"{name}.csv", "output": tmp_path / f"{name}.pdf"}
        call("fig_boundary_uncertainty", **given, table=data, claims=root / "params/claims.json", **files)
