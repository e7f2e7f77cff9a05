"""The claims file is complete, and every claim has a check or says what it waits for."""

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
