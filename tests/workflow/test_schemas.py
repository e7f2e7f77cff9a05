"""The schemas themselves, the files that they check, and their agreement with the solver."""

import contextlib
import json
import os
import subprocess
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from study.planning.cases import resolved
from study.planning.documents import SCHEMAS, problems, read_json
from study.planning.plan import make_plan
from study.planning.tiers import load_study

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "tests/data"
DLD = Path(os.environ.get("DLD", ROOT / "build/dld"))
needs_solver = pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")


def solver(*arguments):
    return subprocess.run([DLD, *arguments], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("name", ["case", "cell", "study", "claims"])
def test_schemas_are_valid_and_of_2020_12(name):
    schema = read_json(SCHEMAS / f"{name}.schema.json")
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    Draft202012Validator.check_schema(schema)


def test_a_misspelt_key_of_the_study_is_found(study, tmp_path):
    study = json.loads(json.dumps(study))
    study["tiers"]["smoke"]["pasages"] = {}
    path = tmp_path / "study.json"
    path.write_text(json.dumps(study), encoding="utf-8")
    with pytest.raises(ValueError, match=r"/tiers/smoke/pasages: unknown name; did you mean 'passages'"):
        load_study(path)


def test_a_tier_that_extends_none_of_the_tiers_is_found(study, tmp_path):
    path = tmp_path / "study.json"
    path.write_text(json.dumps(study | {"tiers": {"fine": {"extends": "papre"}}}), encoding="utf-8")
    with pytest.raises(ValueError, match="/tiers/fine/extends: there is no tier 'papre'; allowed are fine"):
        load_study(path)


def test_a_misspelt_key_of_a_case_is_found():
    schema = read_json(SCHEMAS / "case.schema.json")
    with pytest.raises(ValueError, match="colision"):
        resolved({"scene": "passage", "fluid": {"colision": "bgk"}}, schema)


@needs_solver
def test_the_committed_case_schema_is_the_solvers():
    printed = json.loads(solver("schema").stdout)
    assert printed == read_json(SCHEMAS / "case.schema.json")


@needs_solver
@pytest.mark.parametrize("path", sorted(DATA.glob("good/*.json")), ids=lambda path: path.stem)
def test_good_cases_pass_both(path):
    schema = read_json(SCHEMAS / "case.schema.json")
    assert problems(read_json(path), schema) == []
    assert solver("check", path).returncode == 0


@needs_solver
@pytest.mark.parametrize("path", sorted(DATA.glob("bad/*.json")), ids=lambda path: path.stem)
def test_bad_cases_fail_both(path):
    schema = read_json(SCHEMAS / "case.schema.json")
    with contextlib.suppress(json.JSONDecodeError):  # not JSON at all: the solver has to say so too
        assert problems(read_json(path), schema)
    assert solver("check", path).returncode == 2


@needs_solver
@pytest.mark.parametrize("path", sorted(DATA.glob("inconsistent/*.json")), ids=lambda path: path.stem)
def test_inconsistent_cases_pass_the_schema_and_fail_the_solver(path):
    schema = read_json(SCHEMAS / "case.schema.json")
    assert problems(read_json(path), schema) == []
    assert solver("check", path).returncode == 2


@needs_solver
def test_the_solver_accepts_every_case_of_the_study(study, tmp_path):
    schema = read_json(SCHEMAS / "case.schema.json")
    for tier in study["tiers"]:
        for run in {run["id"]: run for run in make_plan(study, tier, schema)["runs"]}.values():
            path = tmp_path / f"{run['id']}.json"
            path.write_text(json.dumps(run["case"]), encoding="utf-8")
            # Some points of the maps and of the sensitivity study are there because they fail.
            done = solver("check", path, "--force")
            assert done.returncode == 0, (tier, run["group"], run["labels"], done.stdout, done.stderr)
