"""The figure of the phase space on small made-up tables: cells, both boundaries, other calibrations."""

import json

import pandas as pd
import pytest
from study.analysis.boundary import PARAMETERS, UNDISPUTED, law

TRUE = (3.1, 5.4, 1.72)
SHIFTS = [4.4, 5.2, 6.0, 6.8, 7.2]


def middle(shift):
    """Capillary number of the made-up boundary."""
    return next(ca / 1000 for ca in range(1, 3000) if law(TRUE, ca / 1000) < shift)


def brackets(series, factor, shifts):
    """Brackets of 4 % of a series whose boundary is at `factor` times the made-up one, and an open one."""
    rows = [(series, shift, factor * middle(shift) * 0.98, factor * middle(shift) * 1.02) for shift in shifts]
    return [*rows, (series, 8.8, None, 0.1)]


@pytest.fixture
def drawn(tmp_path, call, root):
    """The CSV of the figure."""
    cells = [
        (ca, d, "displaced" if d < law(TRUE, ca) else "zigzag") for ca in (0.1, 0.5, 1.5) for d in SHIFTS
    ]
    cells += [(0.3, 8.8, "undecided"), (0.5, 8.8, "diverged"), (2.4, 6.0, "zigzag")]
    passages = pd.DataFrame(cells, columns=["capillary_number", "row_shift_um", "class"])
    table = pd.concat([passages.assign(sweep=name) for name in ("grid", "corrected", "hinge_sphere")])
    rows = brackets("default", 1, SHIFTS) + brackets("corrected", 1, SHIFTS)
    rows += brackets("hinge_sphere", 2, SHIFTS[2:]) + brackets("hinge_sheet", 0.5, SHIFTS)
    boundary = pd.DataFrame(rows, columns=["series", "row_shift_um", *UNDISPUTED])
    fitted = [
        (f"boundary/{name}", *pair)
        for name in ("default", "corrected", "hinge_sheet")
        for pair in zip(PARAMETERS, TRUE, strict=True)
    ]
    fits = pd.DataFrame(fitted, columns=["name", "parameter", "value"])
    tables = {"passages": table, "boundary": boundary.assign(status="open", contradictions=0), "fits": fits}
    for name, one in tables.items():
        one.to_csv(tmp_path / f"{name}.csv", index=False)
    plan = {"note": "", "figures": {"trajectory_sweep": "grid"}}
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    given = {name: tmp_path / f"{name}.csv" for name in tables} | {"claims": root / "params/claims.json"}
    files = {"csv": tmp_path / "drawn.csv", "output": tmp_path / "fig07.pdf"}
    call("fig07_phase_space", plan=tmp_path / "plan.json", **given, **files)
    assert files["output"].with_suffix(".png").stat().st_size > 0
    return pd.read_csv(files["csv"])


def test_the_figure_has_both_boundaries_and_the_printed_classes(drawn):
    kinds = drawn.groupby("kind").series.unique().map(sorted).to_dict()
    assert kinds == {
        "cell": ["grid"],
        "bracket": ["default"],
        "fit": ["corrected", "default", "hinge_sheet"],
        "middle": ["hinge_sphere"],
        "paper": ["Eq. (5)", "text"],
    }
    assert drawn.capillary_number.max() == 1.6  # as far as the paper's diagram
    paper = drawn[drawn.kind == "paper"].iloc[0]
    assert (paper.capillary_number, paper.d_um) == (0, 8.3)
    text = drawn[drawn.series == "text"].set_index("row_shift_um")[UNDISPUTED]
    assert text.loc[6.8].tolist() == [0.15, 0.3]
    cells = drawn[drawn.kind == "cell"].set_index(["row_shift_um", "capillary_number"]).printed_class
    assert cells[(6.8, 0.1)] == "displaced" and cells[(6.8, 0.5)] == "zigzag"
    assert cells[(7.2, 0.5)] != cells[(7.2, 0.5)]  # the text is silent on this row shift


def test_the_band_holds_the_fit_and_is_drawn_of_our_boundary_alone(drawn):
    ours = drawn[(drawn.kind == "fit") & (drawn.series == "default")]
    assert ((ours.d_low_um < ours.d_um + 0.02) & (ours.d_um < ours.d_high_um + 0.02)).all()
    others = drawn[(drawn.kind == "fit") & (drawn.series != "default")]
    assert others.d_low_um.isna().all()


def test_a_calibration_without_a_fit_has_the_middles_of_its_two_sided_brackets(drawn):
    middles = drawn[drawn.kind == "middle"]
    assert sorted(middles.d_um) == SHIFTS[2:]
    assert sorted(middles.capillary_number) == pytest.approx(
        sorted(2 * middle(shift) for shift in SHIFTS[2:]), rel=1e-2
    )
