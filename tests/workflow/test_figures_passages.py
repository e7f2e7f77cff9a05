"""The figures of the lateral extent on small made-up tables: all classes, gaps, nothing at all."""

import json

import numpy as np
import pandas as pd
import pytest

SHIFTS, NUMBERS, LATTICE = [4.0, 6.0, 8.0], [0.1, 0.5, 1.5], 0.4
SCALE, EXPONENT, TRUE_FACTOR = 20.0, 0.75, 1.1  # the law of the made-up cells


def passages():
    """Cells of which those wider than 1.1 * law are displaced; one of them diverged, without an extent."""
    rows = pd.DataFrame(
        [(d, ca) for d in SHIFTS for ca in NUMBERS], columns=["row_shift_um", "capillary_number"]
    )
    law = SCALE * (rows.row_shift_um / 32) ** EXPONENT
    wider = rows.capillary_number < 0.9 - 0.1 * rows.row_shift_um
    rows["d_perp_um"] = law * TRUE_FACTOR * np.where(wider, 1.02, 0.96)
    rows["class"] = np.where(wider, "displaced", "zigzag")
    rows["run"] = [f"run{k}" for k in range(len(rows))]
    rows = rows.assign(sweep="grid", dx_um=LATTICE, skalak_denominator=12, lateral_flow="free")
    rows = rows.assign(epsilon=rows.row_shift_um / 32, film_um=0.3, speed_um_per_kilostep=5.0)
    rows.loc[8, ["class", "d_perp_um", "film_um"]] = ["diverged", np.nan, np.nan]
    rows.loc[7, "class"] = "undecided"
    return rows


def crossings(rows):
    """Three crossings of every cell; the second row takes 4000 steps, the first 2000."""
    parts = [
        rows.assign(row=k, step=step, gap_position_um=4.0 - 0.2 * k) for k, step in enumerate((0, 2000, 6000))
    ]
    return pd.concat(parts).assign(bump=1)


def boundary():
    """A closed bracket with the middle at Ca = 0.4, an open one, and one of another series."""
    names = ["dx_um", "row_shift_um", "ca_displaced", "ca_zigzag", "status", "series"]
    values = [
        (LATTICE, 4.0, 0.2, 0.8, "bracketed", "default"),
        (LATTICE, 6.0, 0.1, None, "open", "default"),
        (LATTICE, 4.0, 1, 2, "bracketed", "hinge_sphere"),
    ]
    return pd.DataFrame(values, columns=names)


@pytest.fixture
def tables(tmp_path, request):
    """A folder with the tables; with the parameter `empty` they have no rows."""
    rows, empty = passages(), getattr(request, "param", "") == "empty"
    lines = crossings(rows)
    names = ["name", "parameter", "value"]
    fits = [("separation-law/refined", "A_um", SCALE), ("separation-law/refined", "B", EXPONENT)]
    force = np.linspace(0, 220, 12)
    stretching = pd.DataFrame({"force_pN": force, "transverse_um": 7.8 - force / 60})
    made = {
        "passages": rows,
        "crossings": lines,
        "return_maps": lines.assign(next_gap_position_um=lines.gap_position_um - 0.2),
        "phase_boundary": boundary(),
        "fits": pd.DataFrame(fits, columns=names),
        "stretching": stretching.assign(method="static", status="converged", skalak_denominator=12),
    }
    for name, table in made.items():
        (table.iloc[:0] if empty else table).to_csv(tmp_path / f"{name}.csv", index=False)
    figures = {"trajectory_sweep": "grid", "tweezer_denominators": [4, 12]}
    (tmp_path / "plan.json").write_text(json.dumps({"note": "", "figures": figures}), encoding="utf-8")
    return tmp_path


def make_all(folder, call, root):
    """Draws every figure; their data by name."""

    def draw(script, **given):
        outputs = {"csv": folder / f"{script}-drawn.csv", "output": folder / f"{script}.pdf"}
        call(script, plan=folder / "plan.json", **given, **outputs)
        assert (folder / f"{script}.png").stat().st_size > 0
        return pd.read_csv(outputs["csv"])

    table, claims = {"table": folder / "passages.csv"}, {"claims": root / "params/claims.json"}
    lines = {"crossings": folder / "crossings.csv", "boundary": folder / "phase_boundary.csv"}
    factors = {"fits": folder / "fits.csv", "factors": folder / "factors.csv"}
    return {
        "fig09": draw("fig09_extent_row_shift", **table, **claims, **factors),
        "fig10": draw("fig10_extent_capillary", **table, **claims, stretching=folder / "stretching.csv"),
        "maps": draw("fig_return_maps", table=folder / "return_maps.csv"),
        "film": draw("fig_film", **table),
        "speed": draw("fig_speed", **table, **lines, **claims),
    }


def test_figures_state_what_the_made_up_cells_were_made_with(tables, call, root):
    drawn = make_all(tables, call, root)
    factors = pd.read_csv(tables / "factors.csv").set_index(["law", "which"])
    best = factors.loc[("fitted", "best")]
    assert (best.misclassified, best.cells) == (0, 7)  # undecided and diverged cells do not count
    assert best.factor_low < TRUE_FACTOR < best.factor_high
    assert best.factor_high / best.factor_low == pytest.approx(1.02 / 0.96, abs=1e-3)
    zigzag = 7 - int((passages()["class"] == "displaced").sum())
    assert factors.loc[("fitted", "one")].misclassified == zigzag  # all cells are wider than the law itself
    assert factors.loc[("fitted", "printed")].misclassified == 0  # 0.96 * 1.1 is below 1.08
    assert drawn["fig10"].groupby("row_shift_um").in_window.first().tolist() == [1, 1, 0]
    assert drawn["fig10"].tweezer_4_um.isna().all()  # no stretching with this denominator
    assert len(drawn["maps"]) == 27
    speed = drawn["speed"][drawn["speed"].row_shift_um == 4.0].set_index("capillary_number")
    assert set(speed.slowest_row_kilosteps) == {4.0}
    assert set(speed.relative_speed) == {1.0}  # all cells were made equally fast
    assert speed.distance[0.1] == pytest.approx(0.1 / 0.4 - 1)
    assert drawn["speed"][drawn["speed"].row_shift_um != 4.0].distance.isna().all()


@pytest.mark.parametrize("tables", ["empty"], indirect=True)
def test_figures_without_any_row_are_still_made(tables, call, root):
    assert [name for name, data in make_all(tables, call, root).items() if len(data)] == []
