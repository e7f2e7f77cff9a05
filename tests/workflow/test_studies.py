"""Studies: files of their own, with the sections that they have and no others."""

import copy
import json
import subprocess
import sys

import pytest
from study.analysis.devices import circle_facts, pressure_gradient_bar_per_m
from study.planning.arrays import case_parts
from study.planning.documents import SCHEMAS, problems, read_json
from study.planning.folders import PAPER, results_folder, study_file
from study.planning.plan import load_plan, make_plan
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
    with pytest.raises(ValueError, match="results/tables has another use"):
        results_folder("params/studies/tables.json", "full", tiers)


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
