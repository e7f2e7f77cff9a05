"""Bad files of the study give every problem at once, at the place where it was written."""

import copy
import json

import pytest
from study.planning.documents import read_json
from study.planning.plan import load_plan
from study.planning.validation import load_json


@pytest.fixture
def raw(root):
    """The study as it stands in its file."""
    return copy.deepcopy(read_json(root / "params/studies/krueger2014.json"))


@pytest.fixture
def error_of(tmp_path):
    """The text of the error that a changed study gives."""

    def load(study, tier="paper"):
        path = tmp_path / "study.json"
        path.write_text(study if isinstance(study, str) else json.dumps(study), encoding="utf-8")
        with pytest.raises(ValueError) as error:
            load_plan(path, tier)
        assert str(path) in str(error.value) or "cases of the study" in str(error.value)
        return str(error.value)

    return load


def at(study, pointer):
    """The object that holds the last part of a pointer, and that part."""
    *path, key = pointer.strip("/").split("/")
    for part in path:
        study = study[int(part) if isinstance(study, list) else part]
    return study, key


BAD = [
    ("/tiers/paper/pasages", {}, "/tiers/paper/pasages: unknown name; did you mean 'passages'?"),
    ("/tiers/paper/boundary/series/default/ca_range", [2, 0.1], "the smaller end comes first"),
    ("/tiers/paper/boundary/series/default/ca_ranges", {"6": [0.8, 0.3]}, "ca_ranges/6: [0.8, 0.3]"),
    ("/tiers/paper/uncertainty/series/mesh-14/ca_ranges", {"6.4": [0.3, 0.8]}, "has no row shift 6.4"),
    ("/tiers/paper/figures/array/variant", "papr", "did you mean 'paper'?"),
    ("/tiers/paper/accuracy/studies/tweezer/methods/static/reference", "statik", "did you mean 'static'?"),
    (
        "/tiers/paper/accuracy/studies/tweezer/references/static/methods",
        ["statik"],
        "there is no 'statik'; did",
    ),
    ("/tiers/paper/streamlines/refinement/refined", ["accurat", "accurate-0.4"], "did you mean 'accurate'?"),
    ("/tiers/paper/uncertainty/rows/0/series", "referense", "did you mean 'reference'?"),
    ("/tiers/paper/uncertainty/rows/0/reference", "corected", "did you mean 'corrected'?"),
    ("/tiers/paper/sensitivity/boundary/reference", "defaut", "did you mean 'default'?"),
    ("/tiers/paper/sensitivity/boundary/choices", ["kernl"], "choices/0: there is no 'kernl'"),
    ("/tiers/paper/figures/trajectory_sweep", "gird", "did you mean 'grid'?"),
    ("/tiers/paper/figures/streamline_variant", "papr", "did you mean 'paper'?"),
    ("/tiers/paper/accuracy/class_sweeps", ["gird"], "class_sweeps/0: there is no 'gird'"),
    ("/tiers/paper/stability/maps/mesh/extends", "bendng", "did you mean 'bending'?"),
    ("/tiers/paper/extends", "fine", "extends this tier, directly or not"),
    ("/tiers/smoke", 3, "/tiers/smoke: an object is needed"),
    ("/tiers", [], "/tiers: an object is needed"),
    ("/tiers/fine/extends", ["paper"], "/tiers/fine/extends: the name of a tier is needed"),
    ("/tiers/paper/boundary", 3, "/tiers/paper/boundary: 3 is not of type 'object'"),
]


@pytest.mark.parametrize(("pointer", "value", "words"), BAD, ids=[pointer for pointer, _, _ in BAD])
def test_a_mistake_is_told_with_its_place_and_what_was_meant(raw, error_of, pointer, value, words):
    holder, key = at(raw, pointer)
    holder[key] = value
    text = error_of(raw)
    assert words in text
    if "extends" not in pointer:
        assert pointer in text


def test_all_mistakes_are_told_at_once_and_inherited_ones_once(raw, error_of):
    paper = raw["tiers"]["paper"]
    paper["pasages"] = {}
    paper["boundary"]["seres"] = {}
    raw["solver_mode"] = 1
    text = error_of(raw)
    for pointer in ("/tiers/paper/pasages", "/tiers/paper/boundary/seres", "/solver_mode"):
        assert text.count(f"{pointer}: ") == 1, pointer  # and not again in the tier that extends this one
    assert "/tiers/fine" not in text


def test_all_cases_that_the_solver_would_refuse_are_told_at_once(raw, error_of):
    paper = raw["tiers"]["paper"]
    paper["passages"]["grid"]["case"]["fluid"] = {"colision": "bgk"}
    paper["streamlines"]["variants"]["paper"]["case"]["fluid"]["walls"] = "half-way"
    text = error_of(raw)
    assert "/fluid/colision: unknown name; did you mean 'collision'?" in text and "sweep=grid" in text
    assert "variant=paper" in text and "did you mean 'half_way'?" in text


def test_methods_that_extend_one_another_in_a_circle_are_told(raw, error_of):
    methods = raw["tiers"]["paper"]["accuracy"]["studies"]["passages"]["methods"]
    first, second = list(methods)[:2]
    methods[first]["extends"], methods[second]["extends"] = second, first
    assert "the methods extend one another in a circle" in error_of(raw)


def test_bad_syntax_and_keys_given_twice_name_the_file(tmp_path):
    path = tmp_path / "bad.json"
    path.write_text('{"a": 1,\n "b" 2}', encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.json, line 2, column 6"):
        load_json(path)
    path.write_text('{"a": NaN}', encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.json: NaN is no number"):
        load_json(path)
    path.write_text('{"a": {"b": 1, "b": 2}}', encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.json: 'b' given twice"):
        load_json(path)
