"""The named cell types: each is a case that the solver accepts, and each of its values has a source."""

import json
import os
import subprocess
from pathlib import Path

import pytest
from study.planning.cases import resolved
from study.planning.documents import SCHEMAS, read_json, validated

ROOT = Path(__file__).resolve().parents[2]
DLD = Path(os.environ.get("DLD", ROOT / "build/dld"))
CELLS = sorted((ROOT / "params/cells").glob("*.json"))


@pytest.fixture(params=CELLS, ids=lambda path: path.stem)
def cell(request):
    return validated(request.param, "cell") | {"file": request.param}


def test_the_types_that_the_documents_name_are_there():
    names = {"healthy", "malaria-stiffened", "sickle-like", "rigid-bead", "leukocyte-like-sphere"}
    assert names <= {path.stem for path in CELLS}


def test_a_type_is_named_like_its_file(cell):
    assert cell["name"] == cell["file"].stem


def test_every_value_has_a_source_and_every_source_a_value(cell):
    sourced = {pointer for source in cell["sources"] for pointer in source["values"]}
    values = {f"/cell/{key}" for key in cell["cell"]} | {"/shear_modulus_uN_per_m", "/bending_modulus_J"}
    assert sourced == values


def test_a_value_lies_in_the_range_of_its_source(cell):
    for source in cell["sources"]:
        for pointer in source["values"][:1] if "range" in source else []:
            value = cell
            for key in pointer.split("/")[1:]:
                value = value[key]
            low, high = source["range"]
            if isinstance(value, float | int) and source["certainty"] != "model choice":
                assert low <= value <= high, pointer


def test_the_bending_ratio_is_that_of_the_moduli(cell):
    stiffness = cell["shear_modulus_uN_per_m"] * 1e-6 * (cell["cell"]["radius_um"] * 1e-6) ** 2
    assert cell["cell"]["bending_ratio"] == pytest.approx(cell["bending_modulus_J"] / stiffness, rel=0.02)


@pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")
def test_the_solver_accepts_a_passage_of_the_type(cell, tmp_path):
    depth_um = 9.6 if cell["name"] == "leukocyte-like-sphere" else 4.8
    case = {"scene": "passage", "geometry": {"depth_um": depth_um}, "cell": cell["cell"]}
    path = tmp_path / "case.json"
    path.write_text(json.dumps(case), encoding="utf-8")
    checked = subprocess.run([DLD, "check", path], capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stderr
    assert "no effect" not in checked.stderr
    full = resolved(case, read_json(SCHEMAS / "case.schema.json"))
    assert full["cell"] | cell["cell"] == full["cell"]


def test_a_value_without_a_source_is_found(tmp_path):
    healthy = json.loads((ROOT / "params/cells/healthy.json").read_text(encoding="utf-8"))
    path = tmp_path / "nameless.json"
    healthy["sources"][0].pop("citation")
    del healthy["bending_modulus_J"]
    path.write_text(json.dumps(healthy), encoding="utf-8")
    with pytest.raises(ValueError) as error:
        validated(path, "cell")
    assert "bending_modulus_J" in str(error.value)
    assert "citation" in str(error.value)
