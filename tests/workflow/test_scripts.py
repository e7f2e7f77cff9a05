"""The scripts on made-up runs of both tiers: columns, fits, labels, verdicts, figures with the same bytes."""

import json
import shutil

import h5py
import pandas as pd
import pytest
from study.drawing.wording import WORDS
from study.paper.grades import CONTRADICTS, GRADES, HOLDS, NOT_REPRODUCED, NOT_RUN, REPRODUCED
from study.planning.documents import read_json
from study.planning.points import STUDY_GROUPS

EXPERIMENT = "params/experiment/tweezer_experiment.csv"
EXPECTED = {
    "streamline_separation": "device variant row_shift_um epsilon s_um s_uncertainty_um s_upper_um "
    "resistance_Pa_s_per_m2 lateral_velocity_ratio reynolds_number",
    "fits": "name parameter value std_error paper_value",
    "phase_boundary": "dx_um row_shift_um ca_displaced ca_zigzag status lateral_flow settings series runs",
    "critical_row_shift": "series dx_um capillary_number d_displaced_um d_zigzag_um status runs",
    "boundary_confirmation": "series row_shift_um confirmation class_at_displaced agrees runs",
    "boundary_points": "series dx_um row_shift_um capillary_number class run",
    "second_starts": "set points same_class other_class no_class",
    "crossings": "sweep dx_um row_shift_um capillary_number row gap_position_um bump d_perp_um film_um run",
    "return_maps": "sweep row_shift_um capillary_number row gap_position_um next_gap_position_um bump",
    "a_priori": "sweep dx_um row_shift_um capillary_number class predicted_tweezer predicted_centre run",
    "a_priori_summary": "sweep rule right wrong left_out hit_rate node_updates",
    "sensitivity": "choice value observable result change unit runs",
    "stage_times": "stage part dx_um runs total_s median_s longest_s",
    "stokes_checks": "row_shift_um relative_change reversal_max_high",
    "units": "source capillary_number pressure_gradient_bar_per_m mean_velocity_mm_per_s",
    "stretching": "method skalak_denominator force_pN axial_um transverse_um",
    "stretching_comparison": "set diameter skalak_denominator chi2 best_denominator",
    "passages": "dx_um skalak_denominator lateral_flow row_shift_um epsilon capillary_number class d_perp_um "
    "centre_um film_um area_change volume_change min_face_ratio crossings steps failing_quantity run",
}


def passages(folder, results, given, call):
    """The tables of the cells in the array."""
    brackets = {"brackets": results / "brackets"}
    names = {"boundary": "phase_boundary", "points": "boundary_points", "row-shifts": "critical_row_shift"}
    outputs = {name: folder / f"{table}.csv" for name, table in names.items()}
    confirmation = folder / "boundary_confirmation.csv"
    call("boundary_tables", plan=given["plan"], **brackets, **outputs, confirmation=confirmation)
    call("passages_table", **given, **brackets, output=folder / "passages.csv")
    table = folder / "passages.csv"
    call(
        "second_starts_table", passages=table, confirmation=confirmation, output=folder / "second_starts.csv"
    )
    maps = folder / "return_maps.csv"
    call("crossings_table", **given, **brackets, output=folder / "crossings.csv", maps=maps)
    call("stage_times", **given, **brackets, output=folder / "stage_times.csv")


@pytest.fixture(scope="module")
def tables(results, call, root):
    """Makes all tables of a tier; returns them by name."""
    folder, claims = results / "tables", root / "params/claims.json"
    given = {"plan": results / "plan.json", "runs": results / "runs"}
    flow = folder / "streamline_separation.csv"
    call("streamline_table", **given, output=flow)
    separation = folder / "fits_separation.csv"
    call("separation_law_fits", table=flow, claims=claims, output=separation)
    passages(folder, results, given, call)
    boundary = folder / "phase_boundary.csv"
    call("boundary_fits", table=boundary, separation=separation, claims=claims, output=folder / "fits.csv")
    call("stokes_checks", **given, output=folder / "stokes_checks.csv")
    call("units_table", table=flow, claims=claims, output=folder / "units.csv")
    stretching = folder / "stretching.csv"
    call("stretching_table", **given, output=stretching)
    comparison = folder / "stretching_comparison.csv"
    call("stretching_comparison", table=stretching, experiment=root / EXPERIMENT, output=comparison)
    last = {"passages": folder / "passages.csv", "separation": flow, "stretching": stretching}
    output = {"output": folder / "a_priori.csv", "summary": folder / "a_priori_summary.csv"}
    call("a_priori_table", **last, claims=claims, runs=results / "runs", **output)
    call("sensitivity_table", **given, boundary=boundary, output=folder / "sensitivity.csv")
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
    assert set(rows["class"]) <= {"displaced", "zigzag", "undecided", "diverged"}
    if "fine" in results.name:
        diverged = rows[rows["class"] == "diverged"]
        assert set(diverged.failing_quantity) == {"speed"}


def test_a_stokes_flow_that_diverged_is_a_row_without_a_comparison(results, call, tmp_path):
    plan = read_json(results / "plan.json")
    plan["runs"] = [run for run in plan["runs"] if run["group"] == "stokes"]
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    for run in plan["runs"]:
        shutil.copytree(results / "runs" / run["id"], tmp_path / "runs" / run["id"])
    bad = plan["runs"][0]
    (tmp_path / "runs" / bad["id"] / "summary.json").write_text('{"status": "diverged"}', encoding="utf-8")
    output = tmp_path / "stokes_checks.csv"
    call("stokes_checks", plan=tmp_path / "plan.json", runs=tmp_path / "runs", output=output)
    table = pd.read_csv(output)
    hit = table.runs.str.contains(bad["id"])
    assert hit.sum() == 1
    assert table[hit].relative_change.isna().all()
    assert table[~hit].relative_change.notna().all()


@pytest.fixture
def with_failures(results, tmp_path):
    """A tier of made-up runs in which the first run of every group failed; its folder and those runs."""
    if "smoke" not in results.name:
        pytest.skip("one tier is enough")
    plan = read_json(results / "plan.json")
    shutil.copy(results / "plan.json", tmp_path)
    (tmp_path / "brackets").symlink_to(results / "brackets")
    first = {run["group"]: run for run in reversed(plan["runs"]) if run["group"] in STUDY_GROUPS}
    failed = {run["id"] for run in first.values()}
    for run in (results / "runs").iterdir():
        place = tmp_path / "runs" / run.name
        place.parent.mkdir(exist_ok=True)
        if run.name not in failed:
            place.symlink_to(run)
            continue
        place.mkdir()
        shutil.copy(run / "case.json", place)
        (place / "summary.json").write_text('{"status": "failed", "reason": "no room"}', encoding="utf-8")
        with h5py.File(place / "run.h5", "w") as file:
            file.attrs.update({"status": "failed", "provenance": "{}"})
    return tmp_path, failed


def test_runs_that_failed_leave_the_tables_of_the_others(with_failures, call):
    folder, failed = with_failures
    given = {"plan": folder / "plan.json", "runs": folder / "runs"}
    for script in ("streamline_table", "stokes_checks", "stretching_table"):
        call(script, **given, output=folder / f"{script}.csv")
    passages(folder, folder, given, call)
    call(
        "sensitivity_table",
        **given,
        boundary=folder / "phase_boundary.csv",
        output=folder / "sensitivity.csv",
    )
    call("trajectories", **given, output=folder / "fig06.csv")
    thumbnails = {"trajectories": folder / "thumbnails.csv", "provenance": folder / "provenance.csv"}
    call("report_data", **given, groups="passages", brackets=folder / "brackets", **thumbnails)
    table = pd.read_csv(folder / "passages.csv")
    hit = table.run.isin(failed)
    assert hit.any() and set(table[hit]["class"]) == {"failed"}
    assert table[~hit].d_perp_um.notna().any()
    assert len(pd.read_csv(folder / "stretching_table.csv"))
    assert pd.read_csv(folder / "streamline_table.csv").status.isin(["failed"]).any()


def test_verdicts(tables, results, call, root):
    csv, markdown = results / "claims.csv", results / "claims.md"
    given = {
        "claims": root / "params/claims.json",
        "tables": results / "tables",
        "experiment": root / EXPERIMENT,
    }
    tier = "fine" if "fine" in results.name else "smoke"
    call("claims_table", **given, plan=results / "plan.json", csv=csv, markdown=markdown)
    table = pd.read_csv(csv).set_index("id")
    verdict = table.verdict
    assert set(table.filter(like="verdict").to_numpy().ravel()) <= set(GRADES)
    assert all(f"(`{name}`)" in markdown.read_text() for name in verdict.index)
    assert ("a test of the rules, no result" in markdown.read_text()) == (tier == "smoke")
    assert table.check.str.startswith("study.paper.claims_").all()
    drawn = {path.stem for path in (root / "results/figures").glob("*.png")}
    assert set(table.figure.dropna()) <= drawn
    assert table.tables.notna().all()
    assert table.tables["phase-boundary"] == "fits phase_boundary"
    if tier == "smoke":
        assert set(verdict) == {NOT_RUN}
    else:
        assert verdict["eps-17-stiff-displaced"] == REPRODUCED
        assert verdict["eps-20-22-all-zigzag"] == REPRODUCED
        assert verdict["eps-11-soft-zigzag"] == HOLDS  # the made-up boundary is at Ca = 0.83
        assert set(verdict) == {REPRODUCED, HOLDS, CONTRADICTS, NOT_REPRODUCED}
        assert verdict["reynolds"] == verdict["unit-conversion"] == CONTRADICTS
        assert table["verdict_ca-1.6"]["unit-conversion"] == REPRODUCED
        assert table.verdict_hinge_sphere["table-1"] == verdict["table-1"] == HOLDS
        assert table.verdict_hinge_sphere["tweezer"] == NOT_RUN  # the cell of this law was not stretched
        assert table.verdict_blocked["eps-17-stiff-displaced"] == REPRODUCED  # by its bracket


@pytest.fixture
def whole_study(results, tmp_path):
    """A copy of the tables of the whole study, to be changed."""
    if "fine" not in results.name:
        pytest.skip("on the tables of the paper tier")
    shutil.copytree(results / "tables", tmp_path / "tables")
    return tmp_path / "tables"


@pytest.fixture
def verdicts(whole_study, results, call, root):
    """Judges the claims by the changed tables; a data frame by claim."""

    def judged():
        given = {
            "claims": root / "params/claims.json",
            "tables": whole_study,
            "experiment": root / EXPERIMENT,
        }
        csv = whole_study / "claims.csv"
        plan = results / "plan.json"
        call("claims_table", **given, plan=plan, csv=csv, markdown=whole_study / "claims.md")
        return pd.read_csv(csv).set_index("id")

    return judged


def test_a_flow_that_diverged_leaves_its_claims_undecided_and_is_no_error(tables, whole_study, verdicts):
    rows = tables["streamline_separation"]
    rows.loc[rows.index[rows.variant == "paper"][0], "status"] = "diverged"
    rows.to_csv(whole_study / "streamline_separation.csv", index=False)
    found = verdicts()
    assert found.verdict["table-1"] == found.verdict["resistance"] == "NOT DECIDED"
    assert "did not converge" in found.note["table-1"]
    assert found.verdict["eps-17-stiff-displaced"] == "REPRODUCED"


def test_a_stokes_flow_that_diverged_leaves_its_claims_undecided(tables, whole_study, verdicts):
    rows = tables["stokes_checks"].copy()
    rows.loc[0, "relative_change"] = None
    rows.to_csv(whole_study / "stokes_checks.csv", index=False)
    verdict = verdicts().verdict
    assert verdict["stokes-linear"] == verdict["stokes-mirror"] == "NOT DECIDED"


def test_a_claim_without_its_runs_says_so_and_is_no_error(tables, whole_study, verdicts):
    rows = tables["passages"]
    rows[rows.row_shift_um != 5.2].to_csv(whole_study / "passages.csv", index=False)
    assert verdicts().verdict["eps-13-zigzag"] == NOT_RUN


def test_the_boundary_of_the_made_up_cells_is_found_again(tables, results):
    if "fine" not in results.name:
        pytest.skip("the smoke tier has too few brackets")
    fits = tables["fits"].set_index(["name", "parameter"])
    for series, softening, tolerance in (
        ("default", 1.0, 0.1),
        ("corrected", 1.0, 0.1),
        ("hinge_sphere", 0.5, 0.3),
        ("hinge_sheet", 1.5, 0.3),
    ):
        rows = fits.loc[f"boundary/{series}"]
        assert rows.value["offset_um"] == pytest.approx(3.1, rel=tolerance)
        assert rows.value["rate"] == pytest.approx(1.72 * softening, rel=tolerance)
    boundary = tables["phase_boundary"].set_index(["series", "row_shift_um"])
    assert boundary.loc[("default", 2.0)].status == "all-displaced"
    assert boundary.loc[("default", 8.8)].status == "all-zigzag"


def test_the_sensitivity_study_states_every_choice_and_its_change(tables, results, study):
    rows = tables["sensitivity"]
    tier = study["tiers"]["fine" if "fine" in results.name else "smoke"]
    assert set(tier["sensitivity"]["choices"]) <= set(rows.choice)
    others = rows[rows.choice != "default"]
    assert set(zip(others.choice, others.value.astype(str), strict=True)) <= set(WORDS)
    softer = rows[(rows.choice == "skalak_denominator") & rows.observable.str.startswith("critical_ca")]
    assert len(softer) and (softer.change.dropna() > 0).all()  # the made-up boundary moves up
    factor = rows[(rows.choice == "capillary_factor") & rows.observable.str.startswith("critical_ca")]
    assert factor.relative_change.to_numpy() == pytest.approx(1 / 1.6 - 1, abs=1e-3)


def test_figures_are_made_and_the_same_byte_for_byte(tables, results, call, call_apart, root):
    def make(folder, call):
        plan, runs = {"plan": results / "plan.json"}, {"runs": results / "runs"}
        shapes = {name: folder / f"{name}.csv" for name in ("fig03", "fig05", "faces")}
        folder.mkdir()
        # A streamline that nears a stagnation point turns with the rounding of the libraries of its process.
        call_apart("array_lines", **plan, **runs, output=folder / "fig01.csv")
        call("fig01_array", **plan, lines=folder / "fig01.csv", output=folder / "fig01.pdf")
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
        drawn = {"trajectories": folder / "fig06.csv", "claims": root / "params/claims.json"}
        call("fig06_trajectories", **plan, **drawn, output=folder / "fig06.pdf")
        output = {"csv": folder / "classes.csv", "output": folder / "fig06_classes.pdf"}
        call("fig06_classes", **plan, table=results / "tables/passages.csv", **output)
        tables = {
            "passages": results / "tables/passages.csv",
            "boundary": results / "tables/phase_boundary.csv",
        }
        tables |= {"fits": results / "tables/fits.csv", "claims": root / "params/claims.json"}
        call("fig07_phase_space", **plan, **tables, csv=folder / "fig07.csv", output=folder / "fig07.pdf")
        given = {"table": results / "tables/streamline_separation.csv", "fits": results / "tables/fits.csv"}
        output = {"csv": folder / "table01.csv", "output": folder / "table01.pdf"}
        call("table01_separation", **plan, **given, claims=root / "params/claims.json", **output)
        shapes = {name: folder / f"fig08_{name}.csv" for name in ("shapes", "outlines", "faces", "numbers")}
        call("gap_sections", **plan, **runs, **shapes)
        separation = results / "tables/streamline_separation.csv"
        given = {"separation": separation, "claims": root / "params/claims.json"}
        call("fig08_shapes", **plan, **shapes, **given, output=folder / "fig08.pdf")
        call("animation_outlines", **plan, **runs, output=folder / "animation.csv")
        output = {"name": "zigzag", "output": folder / "animation_zigzag.gif"}
        call("animation", **plan, outlines=folder / "animation.csv", **output)
        return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}

    first = make(results / "drawn", call)
    assert sum(name.endswith(".pdf") for name in first) == 10
    assert sum(name.endswith(".png") for name in first) == 10
    if "smoke" in results.name:
        second = make(results / "figures-again", call_apart)
        assert [name for name in first if first[name] != second[name]] == []
