"""Bad files of the study give every problem at once, at the place where it was written."""

import copy
import json
import re

import pytest
from study import plan as planning
from study.validation import OPTIONS, pointer


@pytest.fixture
def raw(root):
    """The study as it stands in its file."""
    return copy.deepcopy(planning.read_json(root / "params/study.json"))


@pytest.fixture
def error_of(tmp_path):
    """The text of the error that a changed study gives."""

    def load(study, tier="paper", **others):
        path = tmp_path / "study.json"
        path.write_text(study if isinstance(study, str) else json.dumps(study), encoding="utf-8")
        with pytest.raises(ValueError) as error:
            planning.load_plan(path, tier, **others)
        assert others or all(line.startswith(f"{path}: /") for line in str(error.value).splitlines())
        return str(error.value)

    return load


def at(study, pointer):
    """The object that holds the last part of a pointer, and that part."""
    *path, key = pointer.strip("/").split("/")
    for part in path:
        study = study[part]
    return study, key


#: (place in the file, wrong value, place of the problem behind it, what is told).
BAD = [
    ("/tiers/paper/pasages", {}, "", "allowed is one of accuracy, boundary,", "did you mean 'passages'?"),
    ("/tiers/paper/note", 3, "", "allowed is a text"),
    ("/tiers/fine/boundary", None, "", "allowed is an object"),
    ("/tiers/smoke", [3], "", "allowed is an object"),
    ("/tiers", 3, "", "allowed is an object"),
    ("/tiers/paper/extends", "fine", "", "remove one `extends` of the circle"),
    ("/tiers/fine/extends", "papre", "", "allowed is one of paper, smoke; did you mean 'paper'?"),
    ("/tiers/fine/exteds", "paper", "", "did you mean 'extends'?"),
    ("/tiers/paper/streamlines/row_shifts_um", [-1], "/0", "above 0; use more than 0"),
    ("/tiers/paper/boundary/series/lattice-0.2/ca_range", [2, 0.1], "", "turn it round: [0.1, 2]"),
    ("/tiers/paper/boundary/series/lattice-0.2/ca_ranges", {"6": [0.8, 0.3]}, "/6", "turn it round"),
    ("/tiers/paper/boundary/series/lattice-0.2/ca_ranges", {"6.6": [0.3, 0.8]}, "/6.6", "one of 6, 6.8"),
    ("/tiers/paper/boundary/mirror/row-shift-0.4/row_shift_range_um", [2, 2], "", "raise the second"),
    ("/tiers/paper/sensitivity/boundary/ca_range", [2, 1], "", "turn it round: [1, 2]"),
    ("/tiers/paper/streamlines/refinement/refined", ["accurat", "paper"], "/0", "did you mean 'accurate'?"),
    ("/tiers/paper/boundary/extrapolated/limit", ["mesh-14", "mesh-15"], "/1", "did you mean 'mesh-14'?"),
    ("/tiers/paper/sensitivity/boundary/reference", "latice-0.4", "", "did you mean 'lattice-0.4'?"),
    ("/tiers/paper/sensitivity/boundary/choices", ["skalak_denominator", "kernl"], "/1", "mean 'kernel'?"),
    ("/tiers/paper/sensitivity/choices/lattice_um/0.2/series", "latice-0.2", "", "mean 'lattice-0.2'?"),
    ("/tiers/paper/accuracy/class_sweeps", ["gird"], "/0", "did you mean 'grid'?"),
    ("/tiers/paper/accuracy/studies/flow/cheap_reference", "wall", "", "allowed is one of central linear"),
    ("/tiers/paper/accuracy/studies/tweezer/methods/static/ladder", ["5", "41"], "/1", "mean '4"),
    ("/tiers/paper/accuracy/studies/tweezer/methods/static/reference", "statc", "", "mean 'static'?"),
    ("/tiers/paper/accuracy/studies/tweezer/methods/static/extends", "couple", "", "mean 'coupled'?"),
    ("/tiers/paper/figures/trajectory_sweep", "gird", "", "did you mean 'grid'?"),
    ("/tiers/paper/figures/array/sweep", "gird", "", "did you mean 'grid'?"),
    ("/tiers/paper/figures/streamline_variant", "papr", "", "did you mean 'paper'?"),
    ("/tiers/paper/figures/law_variants", ["refind"], "/0", "did you mean 'refined'?"),
    ("/tiers/paper/stability/maps/mesh/extends", "bendng", "", "did you mean 'bending'?"),
    ("/tiers/paper/stability/maps/mesh/x/key", "/cell/mesh_frequncy", "", "mean '/cell/mesh_frequency'?"),
    ("/tiers/paper/passages/grid/case", {"fluid": {"wals": 1}}, "/fluid/wals", "did you mean 'walls'?"),
    (
        "/tiers/paper/boundary/case",
        {"fluid": {"walls": "half"}},
        "/fluid/walls",
        "allowed is one of half_way",
    ),
    ("/tiers/paper/stokes/case", {"cell": {"radius_um": "4"}}, "/cell/radius_um", "without quotes"),
]


@pytest.mark.parametrize(("place", "value", "inner", "words"), [(*bad[:3], bad[3:]) for bad in BAD])
def test_a_mistake_is_told_with_its_place_what_is_allowed_and_what_to_change(
    raw, error_of, place, value, inner, words
):
    holder, key = at(raw, place)
    holder[key] = value
    text = error_of(raw)
    line = next(line for line in text.splitlines() if f": {place}{inner} = " in line)
    assert all(word in line for word in words)


def test_a_case_that_is_wrong_as_a_whole_is_told_at_its_sweep(raw, error_of):
    paper = raw["tiers"]["paper"]
    paper["passages"]["grid"]["capillary_numbers"].append(2e6)
    paper["stability"]["maps"]["mesh"]["x"]["values"] = [2.5]
    paper["boundary"]["series"]["half-force"]["case"]["geometry"] = {"epsilon": 0.1}
    paper["sensitivity"]["case"]["geometry"] = {"epsilon": 0.1}
    lines = error_of(raw).splitlines()
    for place, value in (
        (
            "passages/grid",
            "/cell/capillary_number = 2000000.0: allowed is a number above 0 and at most 1e+06",
        ),
        ("stability/maps/mesh", "/cell/mesh_frequency = 2.5: allowed is a whole number"),
        ("boundary/series/half-force", "/geometry = epsilon and row_shift_um"),
        ("sensitivity/choices", "/geometry = epsilon and row_shift_um"),
    ):
        assert any(f": /tiers/paper/{place} = a case with {value}" in line for line in lines), place
    assert len(lines) == 4


def test_all_mistakes_are_told_at_once_and_inherited_ones_once(raw, error_of):
    paper = raw["tiers"]["paper"]
    paper["pasages"] = {}
    paper["boundary"]["seres"] = {}
    raw["solver_mode"] = 1
    text = error_of(raw)
    for pointer in ("/tiers/paper/pasages", "/tiers/paper/boundary/seres", "/solver_mode"):
        assert text.count(f"{pointer} = ") == 1, pointer  # and not again in the tier that extends this one
    assert "/tiers/fine" not in text


def test_problems_of_every_kind_and_file_are_told_together(raw, error_of, tmp_path):
    paper = raw["tiers"]["paper"]
    paper["pasages"] = {}
    paper["boundary"]["series"]["lattice-0.2"]["ca_range"] = [2, 0.1]
    paper["figures"]["trajectory_sweep"] = "gird"
    paper["passages"]["grid"]["case"]["fluid"] = {"walls": "half-way"}
    paper["streamlines"]["row_shifts_um"].append(6000)
    del paper["stokes"]["case"]
    raw["tiers"]["smoke"]["extends"] = "papre"
    claims = tmp_path / "claims.json"
    claims.write_text('{"source": "T", "source": "T", "clams": []}', encoding="utf-8")
    options = {"teir": "smoke", "tier": "ful", "sample": 0}
    lines = error_of(raw, claims_path=claims, options=options).splitlines()
    assert sorted(line.split(" = ")[0].split(": m")[0].removeprefix(str(tmp_path)) for line in lines) == [
        "--config: /sample",
        "--config: /teir",
        "--config: /tier",
        "/claims.json: /claims",
        "/claims.json: /clams",
        "/claims.json: /source",
        "/study.json: /tiers/paper/boundary/series/lattice-0.2/ca_range",
        "/study.json: /tiers/paper/figures/trajectory_sweep",
        "/study.json: /tiers/paper/pasages",
        "/study.json: /tiers/paper/passages/grid/case/fluid/walls",
        "/study.json: /tiers/paper/stokes/case",
        *(
            f"/study.json: /tiers/paper/streamlines/variants/{name}"
            for name in sorted(paper["streamlines"]["variants"])
        ),
        "/study.json: /tiers/smoke/extends",
    ]


def test_a_value_that_is_wrong_in_another_tier_alone_is_told_where_it_is_written(raw, error_of):
    series = raw["tiers"]["fine"]["boundary"]["series"]["lattice-0.2"]
    series["row_shifts_um"] = [6.0]
    line = error_of(raw)
    assert "/tiers/paper/boundary/series/lattice-0.2/ca_ranges/6.8 = " in line and "tier 'fine'" in line
    series["row_shifts_um"] = [6.0, 6.8]
    raw["tiers"]["paper"]["boundary"]["series"]["lattice-0.2"]["ca_range"] = series["ca_range"] = [2, 1]
    assert len(error_of(raw).splitlines()) == 2  # each tier writes it


def test_methods_that_extend_one_another_in_a_circle_are_told(raw, error_of):
    methods = raw["tiers"]["paper"]["accuracy"]["studies"]["passages"]["methods"]
    first, second = list(methods)[:2]
    methods[first]["extends"], methods[second]["extends"] = second, first
    text = error_of(raw)
    for method in (first, second):
        assert f"/tiers/paper/accuracy/studies/passages/methods/{method}/extends = " in text


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"a": 1,\n "b" 2}', "bad.json: /: allowed is JSON; line 2, column 6"),
        ('{"a": [{"b": 1, "b": 2}]}', "bad.json: /a/0/b = 2: allowed is each name once"),
        ('{"source": NaN, "claims": []}', "bad.json: /source = NaN: allowed is a text"),
        (b"\xff", "bad.json: /: allowed is a readable file in UTF-8"),
        (None, "bad.json: /: allowed is a readable file in UTF-8"),
        ("[]", "bad.json: / = []: allowed is an object"),
    ],
)
def test_a_file_that_is_no_json_is_told_with_its_name(tmp_path, text, words):
    path = tmp_path / "bad.json"
    if text is not None:
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ValueError) as error:
        planning.validated(path, "claims")
    assert words in str(error.value)


def test_the_snakefile_checks_claims_and_options_before_any_run(root):
    assert "load_plan(STUDY, TIER, CLAIMS, config)" in (root / "Snakefile").read_text(encoding="utf-8")


def test_every_option_that_a_rule_reads_is_known(root):
    rules = [root / "Snakefile", *(root / "workflow/rules").glob("*.smk")]
    read = {
        name
        for path in rules
        for name in re.findall(r'config\.get\("(\w+)"', path.read_text(encoding="utf-8"))
    }
    assert read <= set(OPTIONS)


def test_names_with_a_slash_are_escaped_in_pointers():
    assert pointer(["a/b", "c~d", 0]) == "/a~1b/c~0d/0"
