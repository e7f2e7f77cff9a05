"""Studies: files of their own, with the sections that they have and no others."""

import copy
import json
import subprocess
import sys
from pathlib import Path

import pytest
from study.analysis.devices import circle_facts, pressure_gradient_bar_per_m
from study.planning.arrays import case_parts
from study.planning.documents import SCHEMAS, problems, read_json
from study.planning.folders import PAPER, results_folder, study_file
from study.planning.plan import CELLS, load_plan, make_plan
from study.planning.plan_file import write_plan
from study.planning.tiers import load_study

CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")
SMALL = {
    "title": "Two devices",
    "purpose": "A test.",
    "devices": {
        "wide": {"pitch_um": 40, "pillar_radius_um": 12},
        "narrow": {"pitch_um": 24, "pillar_radius_um": 8},
    },
    "cells": {"soft": {}, "stiff": {"cell": {"bending_ratio": 0.001}}},
    "tiers": {
        "full": {
            "note": "",
            "passages": {
                "one": {"row_shifts_um": [4.0], "capillary_numbers": [0.5], "case": {}},
                "two": {
                    "device": "narrow",
                    "cell": "stiff",
                    "row_shifts_um": [4.0],
                    "capillary_numbers": [0.5],
                    "case": {},
                },
            },
        }
    },
}


def plan_of(document, tmp_path, tier="full"):
    path = tmp_path / "small.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    return load_plan(path, tier)


def test_every_committed_study_has_a_plan(root):
    for path in sorted((root / "params/studies").glob("*.json")):
        study = load_study(path)
        for tier in study["tiers"]:
            plan = make_plan(study, tier, CASE_SCHEMA)
            assert plan["runs"], path
            for run in plan["runs"]:
                assert problems(run["case"], CASE_SCHEMA) == []


def test_a_study_with_one_section_asks_for_its_runs_alone(tmp_path):
    plan = plan_of(SMALL, tmp_path)
    assert [run["group"] for run in plan["runs"]] == ["passages", "passages"]
    assert plan["sections"] == ["passages"] and plan["brackets"] == {}


def test_sweeps_take_the_first_device_and_cell_or_those_that_they_name(tmp_path):
    first, second = plan_of(SMALL, tmp_path)["runs"]
    assert (first["labels"]["device"], first["labels"]["cell"]) == ("wide", "soft")
    assert (second["labels"]["device"], second["labels"]["cell"]) == ("narrow", "stiff")
    assert second["case"]["geometry"]["pitch_um"] == 24
    assert second["case"]["cell"]["bending_ratio"] == 0.001


def test_a_cell_starts_between_two_rows_of_its_own_device(tmp_path):
    starts = [run["case"]["cell"]["start"]["x_um"] for run in plan_of(SMALL, tmp_path)["runs"]]
    assert starts == [-20, -12]


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (("tiers", "full", "passages", "two", "device"), "narow", "no 'narow'; did you mean 'narrow'"),
        (("tiers", "full", "passages", "two", "cell"), "hard", "no 'hard'"),
        (
            ("tiers", "full", "uncertainty"),
            {"case": {}, "series": {}, "rows": []},
            "needs the section boundary",
        ),
        (("devices",), {}, "/devices"),
        (("cells", "soft", "type"), "helthy", "/cells/soft/type: there is no cell 'helthy'"),
        (("tiers", "full", "passage"), {}, "/tiers/full/passage: unknown name; did you mean 'passages'"),
    ],
)
def test_what_is_wrong_with_a_study_is_named(place, value, message, tmp_path):
    document = copy.deepcopy(SMALL)
    target = document
    for key in place[:-1]:
        target = target[key]
    target[place[-1]] = value
    with pytest.raises(ValueError, match=message.replace("'", ".")):
        plan_of(document, tmp_path)


def test_a_stretched_cell_has_the_stiffness_and_the_values_of_the_study(tmp_path):
    document = copy.deepcopy(SMALL)
    document["cells"]["stiff"]["shear_modulus_uN_per_m"] = 20.0
    series = {"skalak_denominators": [12], "case": {"stretching": {"method": "static", "forces_pN": [0, 50]}}}
    document["tiers"]["full"]["stretching"] = {"plain": series, "stiff": {"cell": "stiff"} | series}
    runs = [run for run in plan_of(document, tmp_path)["runs"] if run["group"] == "stretching"]
    plain, stiff = (run["case"] for run in runs)
    assert [run["labels"] for run in runs] == [{"series": "plain"}, {"series": "stiff", "cell": "stiff"}]
    assert stiff["stretching"]["shear_modulus_uN_per_m"] == 20.0
    assert stiff["cell"]["bending_ratio"] == 0.001 != plain["cell"]["bending_ratio"]


def test_the_sensitivity_of_a_study_is_that_of_its_own_device_and_cell(tmp_path):
    document = copy.deepcopy(SMALL)
    bracket = {"row_shifts_um": [4.0], "ca_range": [0.1, 1.0], "levels": 1}
    document["tiers"]["full"] |= {
        "boundary": {"case": {}, "series": {"own": bracket | {"device": "narrow", "case": {}}}},
        "sensitivity": {
            "device": "narrow",
            "cell": "stiff",
            "case": {},
            "flow_case": {},
            "points": [{"row_shift_um": 4.0, "capillary_number": 0.5}],
            "choices": {"viscosity_ratio": {"1": {"case": {"cell": {"viscosity_ratio": 1}}}}},
            "boundary": bracket | {"reference": "own", "choices": ["viscosity_ratio"]},
        },
    }
    plan = plan_of(document, tmp_path)
    runs = [run for run in plan["runs"] if run["group"].startswith("sensitivity")]
    assert {run["case"]["geometry"]["pitch_um"] for run in runs} == {24}
    assert {run["case"]["cell"]["bending_ratio"] for run in runs if "cell" in run["case"]} == {0.001}
    bracket = plan["brackets"]["sensitivity/viscosity_ratio/1/d4"]
    assert bracket["case"]["geometry"]["pitch_um"] == 24 and bracket["case"]["cell"]["bending_ratio"] == 0.001
    assert {"device": "narrow", "cell": "stiff"}.items() <= bracket.items()


@pytest.mark.parametrize("section", ["stokes", "uncertainty", "accuracy", "stability", "figures"])
def test_a_section_of_the_print_is_refused_in_another_study_with_the_reason(section, root, tmp_path):
    paper = read_json(root / f"params/studies/{PAPER}.json")["tiers"]["paper"]
    document = copy.deepcopy(SMALL)
    document["tiers"]["full"] |= {name: paper[name] for name in ("streamlines", "boundary", section)}
    message = rf"/tiers/full/{section}: its tables and figures are set against a print.*leave it out or use"
    with pytest.raises(ValueError, match=message):
        plan_of(document, tmp_path)


DLD = Path(__file__).resolve().parents[2] / "build/dld"


@pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")
def test_a_sweep_over_the_pressure_is_one_over_the_capillary_number(tmp_path):
    document = copy.deepcopy(SMALL)
    document["cells"]["soft"]["shear_modulus_uN_per_m"] = 5.3
    one = document["tiers"]["full"]["passages"]["one"]
    one["pressure_gradients_bar_per_m"] = [0.5, 2.0]
    del one["capillary_numbers"]
    low, high, _ = plan_of(document, tmp_path)["runs"]
    length = (16 * 4.8) ** 0.5  # of the wide device, um
    for run, gradient in ((low, 0.5), (high, 2.0)):
        number = run["case"]["cell"]["capillary_number"]
        assert pressure_gradient_bar_per_m(number, 5.3, length, 3.9) == pytest.approx(gradient, rel=1e-6)
        assert "operating" not in run["case"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pressure_gradients_bar_per_m": [1.0]}, "add /cells/soft/shear_modulus_uN_per_m"),
        ({}, "exactly one of capillary_numbers and pressure_gradients_bar_per_m is needed"),
    ],
)
def test_a_sweep_has_one_axis_beside_the_row_shift(change, message, tmp_path):
    document = copy.deepcopy(SMALL)
    one = document["tiers"]["full"]["passages"]["one"]
    del one["capillary_numbers"]
    one |= change
    with pytest.raises(ValueError, match=message):
        plan_of(document, tmp_path)


def test_the_stiffness_of_a_cell_is_that_of_its_type(tmp_path):
    document = copy.deepcopy(SMALL)
    document["cells"]["stiff"] = {"type": "malaria-stiffened"}
    typed = read_json(CELLS / "malaria-stiffened.json")
    plan = plan_of(document, tmp_path)
    assert plan["cells"]["stiff"]["shear_modulus_uN_per_m"] == typed["shear_modulus_uN_per_m"]
    assert plan["cells"]["soft"] == {}


def test_a_named_cell_type_is_laid_under_what_the_study_says(tmp_path):
    (tmp_path / "soft.json").write_text(
        '{"cell": {"bending_ratio": 0.002, "viscosity_ratio": 2}}', encoding="utf-8"
    )
    study = {"devices": {}, "cells": {"mine": {"type": "soft", "cell": {"bending_ratio": 0.003}}}}
    parts = case_parts(study, tmp_path)
    assert parts["cells"]["mine"] == {"cell": {"bending_ratio": 0.003, "viscosity_ratio": 2}}


def test_results_of_studies_and_tiers_have_folders_of_their_own():
    tiers = {"full": {}, "smoke": {}}
    assert results_folder(f"params/studies/{PAPER}.json", "full", tiers) == "results"
    assert results_folder(f"params/studies/{PAPER}.json", "smoke", tiers) == "results/smoke"
    assert results_folder("params/studies/deep.json", "full", tiers) == "results/deep"
    assert results_folder("params/studies/deep.json", "smoke", tiers) == "results/deep/smoke"


@pytest.mark.parametrize("name", ["tables", "figures", "runs", "logs", "quick", "smoke", "fine"])
def test_a_study_with_the_name_of_a_folder_or_tier_of_the_results_is_refused(root, monkeypatch, name):
    monkeypatch.chdir(root)
    with pytest.raises(ValueError, match=f"results/{name} has another use; give the study another name"):
        results_folder(f"params/studies/{name}.json", "full", {"full": {}})


@pytest.mark.parametrize(
    ("study", "tier", "place"),
    [("deep", "tables", "results/deep/tables"), (PAPER, "triangle", "results/triangle")],
)
def test_a_tier_with_the_name_of_another_folder_is_refused(root, monkeypatch, study, tier, place):
    monkeypatch.chdir(root)
    with pytest.raises(ValueError, match=f"/tiers/{tier}: {place} has another use"):
        results_folder(f"params/studies/{study}.json", "full", {"full": {}, tier: {}})


def test_an_unknown_study_is_named_with_the_known_ones(root, monkeypatch):
    monkeypatch.chdir(root)
    with pytest.raises(ValueError, match=r"no study 'tringle'.*did you mean 'triangle'"):
        study_file("tringle")


def test_the_facts_of_a_circle_and_its_pressure_are_those_of_the_paper():
    facts = circle_facts({"pillar_radius_um": 10, "pitch_um": 32, "depth_um": 4.8})
    assert facts["gap_um"] == 12 and facts["length_scale_um"] == pytest.approx(7.5895, abs=1e-4)
    assert pressure_gradient_bar_per_m(1.0, 5.3, facts["length_scale_um"], 3.9) == pytest.approx(
        1.79, abs=0.005
    )


@pytest.mark.parametrize("name", ["triangle", "two-species", "deep"])
def test_the_rules_of_a_study_ask_for_its_page(root, name):
    command = [sys.executable, "-m", "snakemake", "-n", "--quiet", "all", "--config", f"study={name}"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("name", ["triangle", "two-species", "deep"])
def test_the_committed_figures_and_the_page_are_those_of_the_committed_tables(root, call, tmp_path, name):
    results = root / "results" / name
    tables, figures = results / "tables", tmp_path / "figures"
    plan = write_plan(load_plan(root / f"params/studies/{name}.json", "full"), tmp_path / "p")
    inputs = {
        "fig_devices": {"devices": "devices", "lines": "device_lines"},
        "fig_separation": {"table": "streamline_separation"},
        "fig_study_phase_space": {"passages": "passages", "boundary": "phase_boundary"},
    }
    if (tables / "window.csv").exists():
        inputs["fig_window"] = {"window": "window"}
    for figure, given in inputs.items():
        drawn = figures / f"{figure.replace('study_', '')}.pdf"
        call(figure, plan=plan, output=drawn, **{key: tables / f"{file}.csv" for key, file in given.items()})
        for path in (drawn, drawn.with_suffix(".png")):
            assert path.read_bytes() == (results / "figures" / path.name).read_bytes(), path.name
    call("study_page", plan=plan, tables=tables, name=name, output=tmp_path / "README.md")
    assert (tmp_path / "README.md").read_text("utf-8") == (results / "README.md").read_text("utf-8")
