"""The attacks of tests/attacks that take fractions of a second; `bash workflow/test-deep` tries all."""

import json
import sys

from conftest import ROOT
from short_passage import DLD, needs_solver

sys.path.insert(0, str(ROOT / "tests/attacks"))

from attack import all_rows, judged, outcomes
from document import faults_page


@needs_solver
def test_what_was_attacked_holds():
    found = {outcome.row["what"]: outcome.faults for outcome in outcomes(True, str(DLD))}
    assert found
    assert not {what: faults for what, faults in found.items() if faults}


def test_there_are_at_least_200_attacks_by_hand():
    assert sum("kind" not in row for row in all_rows(False)) >= 200


def test_a_wrong_answer_is_noticed(tmp_path):
    (tmp_path / "summary.json").write_text(json.dumps({"status": "converged", "film_um": 4e299}))
    (tmp_path / "left").touch()
    row = {"exit": 0, "says": ["place"], "labels": ["undecided"], "no_number_above": 1e15, "absent": ["left"]}
    faults = judged(row, tmp_path, 1, "unexpected failure", {"case.json": b"{}"})
    assert len(faults) == 6
    assert len(judged(row, tmp_path, 0, "place", {})) == 3


def test_the_page_shows_what_is_open_and_escapes_it():
    class Row:
        def __init__(self, what, faults):
            self.row = {"what": what, "group": "a", "times": 2}
            self.faults, self.held = faults, not faults

    page = faults_page([Row("<b>|x", []), Row("y", ["exit code 1"])])
    assert "2 attacks, 4 tries: 1 attacks (2 tries) held, 1 are open." in page
    assert "| a | \\<b\\>\\|x | 2 | held |" in page and "| a | y | 2 | open: exit code 1 |" in page
