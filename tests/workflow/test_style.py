"""Figures that could not be read in print are refused; speed against accuracy says what its tables say."""

import json

import pandas as pd
import pytest
from study.drawing import style

UNDISPUTED = ["ca_undisputed_displaced", "ca_undisputed_zigzag"]


@pytest.mark.parametrize(("width", "size", "fault"), [(style.PAGE + 0.5, 8, "wide"), (2, 6.5, "6.5 pt")])
def test_a_figure_that_cannot_be_read_in_print_is_refused(tmp_path, width, size, fault):
    figure = style.new_figure(width, 1)
    figure.text(0.5, 0.5, "a word", fontsize=size)
    with pytest.raises(ValueError, match=fault):
        style.save(figure, tmp_path / "figure.pdf")
    assert not (tmp_path / "figure.pdf").exists()


def brackets(series, ends):
    return [(name, shift, *ends[shift]) for name in [series] for shift in ends]


def test_speed_against_accuracy_judges_by_the_reference(tmp_path, call):
    truth = brackets("reference", {4.4: (0.8, 1.25), 6.8: (0.2, 0.3125)})
    ours = brackets("default", {4.4: (2.0, None), 6.8: (0.25, 0.25), 9.9: (0.1, 0.2)})
    made = {
        "boundary": pd.DataFrame(ours, columns=["series", "row_shift_um", *UNDISPUTED]),
        "uncertainty": pd.DataFrame(truth, columns=["series", "row_shift_um", *UNDISPUTED]),
    }
    grid = {"sweep": "grid", "row_shift_um": 6.8, "class": "displaced", "s_variant": "accurate-0.4"}
    cells = [(0.1, 7.0, 6.0, 7.0), (0.4, 5.0, 6.0, 5.5)]
    names = ["capillary_number", "tweezer_um", "printed_d_cr_um", "d_perp_um"]
    made["a-priori"] = pd.DataFrame(cells, columns=names).assign(s_um=2.8, **grid)
    times = [
        ("boundary", "default", 12.0),
        ("uncertainty", "reference", 240.0),
        ("stretching", "static", 1.5),
    ]
    times += [("streamlines", "accurate-0.4", 0.6)]
    made["times"] = pd.DataFrame(times, columns=["stage", "part", "median_s"])
    error = {"method": "preset", "setting": "draft", "error_kind": "D_perp, relative", "seconds": 3.0}
    errors = [error | {"point": point, "error": size} for point, size in (("d = 4.8", 0.02), ("all", 0.5))]
    made["accuracy"] = pd.DataFrame(errors).assign(reference_uncertainty=0.01)
    flat = [("depth-averaged flow", d, 0.5 * d**0.9, 1.3) for d in (3.2, 8.0)]
    made["cheap"] = pd.DataFrame(flat, columns=["method", "row_shift_um", "s_um", "seconds"])
    files = {}
    for name, table in made.items():
        files[name] = tmp_path / f"{name}.csv"
        table.to_csv(files[name], index=False)
    (tmp_path / "plan.json").write_text(json.dumps({"note": ""}), encoding="utf-8")
    given = {"plan": tmp_path / "plan.json", "csv": tmp_path / "drawn.csv", "output": tmp_path / "drawn.pdf"}
    call("fig_speed_accuracy", **files, **given)
    drawn = pd.read_csv(tmp_path / "drawn.csv").set_index(["quantity", "name", "cells"])
    standard = drawn.loc[("critical Ca", "standard")]
    assert standard.error["stiff"] == pytest.approx(0) and standard.at_least["stiff"] == 0
    assert standard.error["soft"] == pytest.approx(1) and standard.at_least["soft"] == 1
    assert standard.band["stiff"] == pytest.approx(0.25)
    assert standard.minutes["stiff"] == pytest.approx(0.2)
    rule = drawn.loc[("critical Ca", "rule, printed law", "stiff")]
    assert rule.error == pytest.approx(1 - 0.2 / 0.25)
    passed = 0.1 * 4 ** ((7.0 - 6.8**0.9) / 2.0)  # the diameter falls from 7 to 5 um, linearly in ln Ca
    rule = drawn.loc[("critical Ca", "rule, 2D flow", "stiff")]
    assert rule.error == pytest.approx(passed / 0.25 - 1, abs=1e-3)
    assert rule.minutes == pytest.approx((1.5 + 1.3) / 60, rel=1e-2)
    assert drawn.loc[("D_perp", "draft", "all")].error == pytest.approx(0.02)
    assert drawn.loc[("D_perp", "stretched cell", "all")].error == pytest.approx(1 - 5 / 5.5, abs=1e-3)
