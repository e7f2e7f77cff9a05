"""The claims file is complete, and every claim has a check or says what it waits for."""

import re

import pandas as pd
from study import claims_classes, claims_extent, claims_flow  # noqa: F401 (they register their checks)
from study.claims import CHECKS, load_claims
from study.plan import validated

PAPER = [
    "stokes-linear",
    "stokes-mirror",
    "reynolds",
    "resistance",
    "device-pressure",
    "table-1",
    "separation-law",
    "cell-area",
    "tweezer",
    "unit-conversion",
    "eps-5-all-displaced",
    "eps-11-soft-zigzag",
    "eps-13-zigzag",
    "eps-17-stiff-displaced",
    "eps-20-22-all-zigzag",
    "phase-boundary",
    "window",
    "design-example",
    "slow-near-boundary",
    "d-perp-6.8",
    "sharp-separation",
    "collapse",
    "open-symbols",
    "tweezer-master-curve",
    "a-priori",
    "inertia",
]


def test_the_file_follows_its_schema_and_has_every_claim_of_the_paper_once(root):
    claims = validated(root / "params/claims.json", "claims")["claims"]
    assert [claim["id"] for claim in claims] == PAPER


def test_every_claim_has_a_check(root):
    assert set(CHECKS) == set(load_claims(root / "params/claims.json"))


def test_tolerances_name_the_parts_of_their_values(root):
    for claim in load_claims(root / "params/claims.json").values():
        if isinstance(claim["tolerance"], dict):
            assert set(claim["tolerance"]) == set(claim["value"]), claim["id"]


def test_every_claim_that_does_not_come_out_is_explained_without_numbers_of_its_own(root):
    claims = load_claims(root / "params/claims.json")
    verdicts = pd.read_csv(root / "results/claims.csv").fillna("").set_index("id")
    for name, row in verdicts.iterrows():
        explained = row.verdict == "NOT REPRODUCED"
        assert bool(row.explanation) == explained, name
        if explained:
            assert row.explanation == claims[name]["otherwise"], name
            words = re.sub("|".join(map(re.escape, claims)), "", row.explanation)
            assert not re.search(r"\d\.\d", words), name
