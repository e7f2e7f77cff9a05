"""Names and texts of study and claims that would be a command, a path, a wildcard, a page or LaTeX."""

import copy
import json
import re

import pytest
from jinja2 import Environment, FileSystemLoader
from study.analysis.tables import in_markdown
from study.paper.claims_page import in_order
from study.paper.manuscript import typeset
from study.planning.documents import SCHEMAS, problems, read_json, validated

HOSTILE = [
    "$(touch x)",
    "`touch x`",
    "a; touch x",
    "a && b",
    "a | b",
    "a > b",
    "../../x",
    "/etc/x",
    "a\nb",
    "a\n",
    "{run}",
    "{{ 7 * 7 }}",
    "{% raw %}",
    "'",
    '"',
    "<script>alert(1)</script>",
    "</script><b>",
    "[x](javascript:alert(1))",
    "\\input{/etc/passwd}",
    "$x^2$ \\write18{x}",
]


def in_a_tier(tier, name):
    """The tier with the name in every place of a name or a text, one after the other."""
    first = next(iter(tier["accuracy"]["studies"]["passages"]["methods"].values()))
    places = [
        (["passages"], tier["passages"]["grid"]),
        (["boundary", "series"], tier["boundary"]["series"]["default"]),
        (["boundary", "mirror"], next(iter(tier["boundary"]["mirror"].values()))),
        (["streamlines", "variants"], {"case": {}}),
        (["streamlines", "refinement"], ["accurate", "accurate-0.4"]),
        (["stretching"], tier["stretching"]["static"]),
        (["sensitivity", "choices"], {"4": {"case": {}}}),
        (["sensitivity", "choices", "skalak_denominator"], {"case": {}}),
        (["stability", "maps"], tier["stability"]["maps"]["precision"]),
        (["stability", "long_run"], tier["stability"]["long_run"]["coarse"]),
        (["figures", "animations"], 1.2),
        (["accuracy", "studies", "passages", "points"], {}),
        (["accuracy", "studies", "passages", "ladder"], {}),
        (["accuracy", "studies", "passages", "methods"], first),
    ]
    for path, value in places:
        changed = copy.deepcopy(tier)
        part = changed
        for key in path:
            part = part[key]
        part[name] = value
        yield "/".join(path), changed
    for path in (["note"], ["uncertainty", "rows", 0, "cause"], ["uncertainty", "rows", 0, "setting"]):
        changed = copy.deepcopy(tier)
        part = changed
        for key in path[:-1]:
            part = part[key]
        part[path[-1]] = name
        yield "/".join(map(str, path)), changed


@pytest.mark.parametrize("text", HOSTILE)
def test_no_name_or_text_of_the_study_has_more_than_plain_letters(study, text):
    schema = read_json(SCHEMAS / "study.schema.json")
    smoke = study["tiers"]["smoke"]
    assert problems({"solver_model": 1, "tiers": {text: smoke}}, schema)
    for place, tier in in_a_tier(smoke, text):
        assert problems({"solver_model": 1, "tiers": {"t": tier}}, schema), place


@pytest.fixture(scope="module")
def page(root):
    """The rows of verdicts of the report's template."""
    folder = root / "workflow/templates"
    source = (folder / "report.html.j2").read_text(encoding="utf-8")
    part = source[source.index("{% for row in verdicts %}") :].split("</tbody>")[0]
    return Environment(loader=FileSystemLoader(folder), autoescape=True).from_string(part)


@pytest.mark.parametrize("text", HOSTILE)
def test_a_text_of_a_claim_is_shown_and_obeyed_nowhere(page, text):
    names = ["id", "claim", "where", "paper_value", "unit", "measured", "note", "explanation", "grounds"]
    row = dict.fromkeys([*names, "verdict"], text)
    shown = page.render(verdicts=[row | {"id": "x", "verdict": "NOT RUN"}])
    assert "<script" not in shown and "</script" not in shown and "<b>" not in shown
    assert "49" not in shown
    cell = in_markdown(text)
    assert not re.search(r"<|\]\(|\n|(?<!\\)\|", cell)
    lines = in_order([row])
    assert all(len(re.findall(r"(?<!\\)\|", line)) == 6 for line in lines)
    latex = typeset(text)
    for command in re.findall(r"\\[A-Za-z]+", latex):
        assert command in (r"\textbackslash", r"\textasciicircum", r"\textasciitilde"), latex


@pytest.mark.parametrize("text", HOSTILE)
def test_an_id_of_a_claim_is_plain_and_no_text_has_control_characters(root, tmp_path, text):
    claims = read_json(root / "params/claims.json")
    changed = copy.deepcopy(claims)
    changed["claims"][0]["id"] = text
    path = tmp_path / "claims.json"
    path.write_text(json.dumps(changed), encoding="utf-8")
    with pytest.raises(ValueError, match="/claims/0/id"):
        validated(path, "claims")
    claims["claims"][0]["claim"] = text + "\x1b[2J and more"
    path.write_text(json.dumps(claims), encoding="utf-8")
    with pytest.raises(ValueError, match=r"/claims/0/claim: .*control characters"):
        validated(path, "claims")
