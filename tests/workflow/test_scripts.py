"""The scripts on made-up runs of both tiers: columns, fits, labels, verdicts, figures with the same bytes."""

import pandas as pd
import pytest

EXPERIMENT = "params/experiment/tweezer_experiment.csv"
EXPECTED = {
    "streamline_separation": "variant row_shift_um epsilon s_um s_uncertainty_um s_upper_um "
    "resistance_Pa_s_per_m2 lateral_velocity_ratio reynolds_number",
    "fits": "name parameter value std_error paper_value",
    "stokes_checks": "row_shift_um relative_change reversal_max_high",
    "units": "source capillary_number pressure_gradient_bar_per_m mean_velocity_mm_per_s",
    "stretching": "method skalak_denominator force_pN axial_um transverse_um",
    "stretching_comparison": "set diameter skalak_denominator chi2 best_denominator",
    "passages": "dx_um skalak_denominator lateral_flow row_shift_um epsilon capillary_number class d_perp_um "
    "centre_um film_um area_change volume_change min_face_ratio crossings steps wall_s failing_quantity run",
}


@pytest.fixture(scope="module")
def tables(results, call, root):
    """Makes all tables of a tier; returns them by name."""
    folder, claims = results / "tables", root / "params/claims.json"
    given = {"plan": results / "plan.json", "runs": results / "runs"}
    flow = folder / "streamline_separation.csv"
    call("streamline_table", **given, output=flow)
    call("separation_law_fits", table=flow, claims=claims, output=folder / "fits.csv")
    call("stokes_checks", **given, output=folder / "stokes_checks.csv")
    call("units_table", table=flow, claims=claims, output=folder / "units.csv")
    stretching = folder / "stretching.csv"
    call("stretching_table", **given, output=stretching)
    comparison = folder / "stretching_comparison.csv"
    call("stretching_comparison", table=stretching, experiment=root / EXPERIMENT, output=comparison)
    call("passages_table", **given, output=folder / "passages.csv")
    return {name: pd.read_csv(folder / f"{name}.csv") for name in EXPECTED}


def test_tables_have_their_columns_and_rows(tables):
    for name, columns in EXPECTED.items():
        assert set(columns.split()) <= set(tables[name].columns), name
        assert len(tables[name]), name


def test_fits_find_the_law_of_the_made_up_flow_again(tables):
    fits = tables["fits"].set_index(["name", "parameter"]).value
    assert fits["separation-law/refined", "A_um"] == pytest.approx(19.0, abs=0.01)
    assert fits["separation-law/refined", "B"] == pytest.approx(0.75, abs=0.001)
    assert fits["separation-law/printed-table", "B"] == pytest.approx(0.758, abs=0.001)


def test_diverged_passages_are_labelled_rows(tables, results):
    rows = tables["passages"]
    assert set(rows["class"]) <= {"displaced", "zigzag", "diverged"}
    if "paper" in results.name:
        diverged = rows[rows["class"] == "diverged"]
        assert list(diverged.failing_quantity) == ["speed"]


def test_verdicts(tables, results, call, root):
    csv, markdown = results / "claims.csv", results / "claims.md"
    given = {
        "claims": root / "params/claims.json",
        "tables": results / "tables",
        "experiment": root / EXPERIMENT,
    }
    tier = "paper" if "paper" in results.name else "smoke"
    call("claims_table", **given, tier=tier, csv=csv, markdown=markdown)
    verdict = pd.read_csv(csv).set_index("id").verdict
    assert set(verdict) <= {"REPRODUCED", "NOT REPRODUCED", "NOT RUN"}
    assert len(markdown.read_text().splitlines()) == len(verdict) + 6
    if tier == "smoke":
        assert set(verdict) == {"NOT RUN"}
    else:
        assert verdict["eps-17-stiff-displaced"] == "REPRODUCED"
        assert verdict["eps-20-22-all-zigzag"] == "NOT REPRODUCED"  # one of the made-up runs diverges
        assert verdict["unit-conversion"] == "NOT REPRODUCED"


def test_figures_are_made_and_the_same_byte_for_byte(tables, results, call, root):
    def make(folder):
        plan, runs = {"plan": results / "plan.json"}, {"runs": results / "runs"}
        shapes = {name: folder / f"{name}.csv" for name in ("fig03", "fig05", "faces")}
        folder.mkdir()
        call("fig02_geometry", **plan, csv=folder / "fig02.csv", output=folder / "fig02.pdf")
        call("cell_shapes", **plan, **runs, **shapes)
        faces = {"faces": shapes["faces"]}
        call("fig03_mesh", **plan, shapes=shapes["fig03"], **faces, output=folder / "fig03.pdf")
        fields = {"fields": folder / "fig04.csv", "separatrices": folder / "lines.csv"}
        call("flow_fields", **plan, **runs, **fields)
        call("fig04_streamlines", **plan, **fields, output=folder / "fig04.pdf")
        given = {"table": results / "tables/stretching.csv", "experiment": root / EXPERIMENT}
        output = {"csv": folder / "curves.csv", "output": folder / "fig05.pdf"}
        call("fig05_tweezer", **plan, **given, shapes=shapes["fig05"], **faces, **output)
        call("trajectories", **plan, **runs, output=folder / "fig06.csv")
        call("fig06_trajectories", **plan, trajectories=folder / "fig06.csv", output=folder / "fig06.pdf")
        output = {"csv": folder / "classes.csv", "output": folder / "fig06_classes.pdf"}
        call("fig06_classes", **plan, table=results / "tables/passages.csv", **output)
        given = {"table": results / "tables/streamline_separation.csv", "fits": results / "tables/fits.csv"}
        output = {"csv": folder / "table01.csv", "output": folder / "table01.pdf"}
        call("table01_separation", **plan, **given, claims=root / "params/claims.json", **output)
        return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}

    first = make(results / "figures")
    assert sum(name.endswith(".pdf") for name in first) == 7
    assert sum(name.endswith(".png") for name in first) == 7
    if "smoke" in results.name:
        second = make(results / "figures-again")
        assert [name for name in first if first[name] != second[name]] == []
