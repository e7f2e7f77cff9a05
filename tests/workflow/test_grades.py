"""Grades: at their edges, in words, counted and on the page."""

import pytest
from claim_tables import DEFAULT
from study.paper.claims import Finding
from study.paper.claims_page import page
from study.paper.grades import (
    CONTRADICTS,
    GRADES,
    HOLDS,
    NOT_DECIDED,
    NOT_REPRODUCED,
    NOT_RUN,
    REPRODUCED,
    counted,
    graded,
)

OTHER = {"id": "other", "series": "other", "description": "what else it could be"}
CLAIM = {
    "where": "Section 3.1",
    "holds": {"number": "the length", "limit": 0.4, "unit": "um"},
    "contradictions": [
        {"id": "first", "statement": "the length is another", "where": "Eq. (1)"},
        {"id": "second", "statement": "there is no length", "where": "Fig. 2"},
    ],
}


def finding(reproduced=False, difference=None, holding=()):
    return Finding(reproduced, "measured", difference=difference, holding=holding)


@pytest.mark.parametrize(
    ("found", "grade"),
    [
        (finding(reproduced=True), REPRODUCED),
        (finding(reproduced=True, difference=9.0, holding=("first",)), REPRODUCED),
        (finding(difference=0.0), HOLDS),
        (finding(difference=0.4), HOLDS),
        (finding(difference=4.4 - 4.0), HOLDS),  # 0.4 but for rounding
        (finding(difference=0.4001), NOT_REPRODUCED),
        (finding(difference=float("nan")), NOT_REPRODUCED),
        (finding(), NOT_REPRODUCED),
        (finding(holding=("second",)), CONTRADICTS),
        (finding(difference=0.5, holding=("first",)), CONTRADICTS),
        (finding(difference=0.3, holding=("first",)), HOLDS),
    ],
)
def test_the_grade_follows_from_the_finding(found, grade):
    assert graded(CLAIM, found)[0] == grade


def test_a_claim_without_a_limit_or_a_contradiction_has_neither_grade():
    assert graded({"where": "here"}, finding(difference=0.0)) == (NOT_REPRODUCED, "")


def test_the_row_says_by_how_much_and_which_statements_hold():
    assert graded(CLAIM, finding(difference=0.1234))[1] == "differs by 0.123 um, limit 0.4 um"
    assert graded(CLAIM, finding(difference=1.5))[1] == "differs by 1.5 um, limit 0.4 um"
    assert graded(CLAIM, finding(reproduced=True, difference=0.1))[1] == ""
    assert graded(CLAIM, finding(holding=("second",)))[1] == (
        "holds: there is no length (Fig. 2); "
        "does not hold: the claim (Section 3.1); the length is another (Eq. (1))"
    )


def test_every_grade_is_counted_in_its_order():
    text = counted([HOLDS, NOT_RUN, HOLDS])
    assert text.startswith("0 REPRODUCED, 2 HOLDS WITH ANOTHER VALUE, 0 PRINT CONTRADICTS ITSELF, ")
    assert text.endswith("0 NOT DECIDED, 1 NOT RUN")
    assert len(text.split(", ")) == len(GRADES)


def row(name, verdict, other, **more):
    texts = dict.fromkeys(
        ["where", "unit", "reason", "paper_value", "tolerance", "limit", "limit_reason"], ""
    )
    texts |= {"id": name, "claim": f"claim {name}", "verdict": verdict, "verdict_other": other, "runs": ""}
    return texts | {"grounds": "", "measured": "", "note": "", "explanation": ""} | more


def test_the_page_begins_with_the_counts_and_has_the_claims_in_their_order():
    rows = [
        row("b", HOLDS, NOT_RUN, measured="1.3", paper_value="1.2", unit="um", grounds="differs by 0.1 um"),
        row("a", REPRODUCED, NOT_REPRODUCED, measured="0.5", explanation="why"),
        row("c", NOT_DECIDED, HOLDS, note="it diverged"),
    ]
    lines = page(rows, [DEFAULT, OTHER], "smoke").splitlines()
    assert lines[2].startswith(
        "| reading | reproduced | holds with another value | print contradicts itself |"
    )
    assert lines[4] == "| `default` | 1 | 1 | 0 | 0 | 1 | 0 | what the verdicts rest on |"
    assert lines[5] == "| `other` | 0 | 1 | 0 | 1 | 0 | 1 | what else it could be |"
    assert lines[9:14] == [
        "| claim | paper | measured | verdict | why |",
        "|---|---|---|---|---|",
        "| claim b (`b`) | 1.2 um | 1.3 | **HOLDS WITH ANOTHER VALUE**, differs by 0.1 um |  |",
        "| claim a (`a`) |  | 0.5 | **REPRODUCED** | why |",
        "| claim c (`c`) |  |  | **NOT DECIDED** | it diverged |",
    ]
    assert "| b | holds |  |" in lines and "| a | reproduced | not |" in lines
