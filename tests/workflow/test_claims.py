"""The claims file is complete, its criteria are derived, and every claim has a check or says what it waits
for."""

import json
import math
import re

import pandas as pd
import pytest
from study.analysis.boundary import PARAMETERS, critical_capillary_number
from study.paper import claims_boundary, claims_classes, claims_extent, claims_flow  # noqa: F401 (register checks)
from study.paper.claims import CHECKS, load_claims
from study.paper.grades import OTHERWISE
from study.planning.documents import read_json, validated
from study.planning.plan import load_plan

#: By what matters most: boundary, classes, D_perp, tweezer, separation law, flow, units.
PAPER = [
    "phase-boundary",
    "eps-5-all-displaced",
    "eps-11-soft-zigzag",
    "eps-13-zigzag",
    "eps-17-stiff-displaced",
    "eps-20-22-all-zigzag",
    "window",
    "design-example",
    "slow-near-boundary",
    "d-perp-6.8",
    "collapse",
    "tweezer-master-curve",
    "sharp-separation",
    "a-priori",
    "open-symbols",
    "tweezer",
    "separation-law",
    "table-1",
    "resistance",
    "stokes-linear",
    "stokes-mirror",
    "inertia",
    "reynolds",
    "device-pressure",
    "cell-area",
    "unit-conversion",
]
#: Claims whose statement has no number that could be another one.
WITHOUT_NUMBER = {"eps-5-all-displaced", "eps-17-stiff-displaced", "eps-20-22-all-zigzag"}
WITHOUT_NUMBER |= {"unit-conversion"}
#: Where the paper's statements exclude one another.
CONTRADICTED = {"phase-boundary", "eps-11-soft-zigzag", "eps-17-stiff-displaced", "reynolds"}
CONTRADICTED |= {"unit-conversion"}


@pytest.fixture
def claims(root):
    return load_claims(root / "params/claims.json")


def test_the_file_follows_its_schema_and_has_every_claim_of_the_paper_once_in_order(root):
    claims = validated(root / "params/claims.json", "claims")["claims"]
    assert [claim["id"] for claim in claims] == PAPER


def test_every_claim_has_a_check(claims):
    assert set(CHECKS) == set(claims)


def test_tolerances_name_the_parts_of_their_values(claims):
    for claim in claims.values():
        if isinstance(claim["tolerance"], dict):
            assert set(claim["tolerance"]) == set(claim["value"]), claim["id"]


def test_claims_with_another_number_or_a_contradiction_are_the_ones_that_can_have_it(claims):
    assert {name for name, claim in claims.items() if "holds" not in claim} == WITHOUT_NUMBER
    assert {name for name, claim in claims.items() if "contradictions" in claim} == CONTRADICTED


@pytest.mark.parametrize("missing", ["number", "limit", "reason"])
def test_a_limit_states_its_number_and_reason(root, missing, tmp_path):
    text = (root / "params/claims.json").read_text(encoding="utf-8")
    path = tmp_path / "claims.json"
    path.write_text(text.replace(f'"{missing}"', f'"not_{missing}"'), encoding="utf-8")
    with pytest.raises(ValueError, match=f"not_{missing}"):
        validated(path, "claims")


def test_limits_in_ca_follow_from_what_the_printed_boundary_resolves(claims):
    law = [claims["phase-boundary"]["value"][name] for name in PARAMETERS]
    resolved = claims["phase-boundary"]["tolerance"]

    def ends(shift):
        return [critical_capillary_number(shift + step, law) for step in (resolved, -resolved)]

    for name, shift in (("eps-11-soft-zigzag", 4.4), ("eps-13-zigzag", 5.2)):
        low, high = ends(shift)
        assert claims[name]["holds"]["limit"] == pytest.approx((high - low) / 2, abs=0.005), name
    said = claims["eps-11-soft-zigzag"]["contradictions"][0]["value"]
    assert [said["displaced_to"], said["zigzag_from"]] == pytest.approx(ends(4.4), abs=5e-4)
    assert said["zigzag_from"] < 1.0  # so it excludes the claim


def test_contradicting_statements_follow_from_what_is_printed(claims):
    spacing, viscosity, nu, length = 0.4e-6, 1e-3, 1 / 6, math.sqrt(30 * 12)
    resistance = claims["resistance"]["value"]["mean"] * spacing**2 / viscosity * nu  # lattice units
    said = claims["reynolds"]["contradictions"][0]
    assert said["value"] == pytest.approx(9.36e-5 / resistance * length / nu, abs=5e-4)
    share = claims["resistance"]["holds"]["limit"] / 100
    assert said["tolerance"] == pytest.approx(share * said["value"], abs=5e-4)
    gradients = claims["unit-conversion"]["contradictions"][0]["value"]["pressure_gradient_bar_per_m"]
    per_number = 5.3e-6 / (math.sqrt(12e-6 * 4.8e-6) * 3.9e-6) / 1e5
    assert gradients == pytest.approx([0.1 * per_number, 1.5 * per_number], rel=2e-3)


def test_the_limit_of_the_master_curve_is_the_error_bar_of_the_experiment(root, claims):
    table = pd.read_csv(root / "params/experiment/tweezer_experiment.csv", comment="#")
    rows = table[(table.set == "SURESH2005_FIG7") & table.F_pN.between(1, 100)]
    assert claims["tweezer-master-curve"]["holds"]["limit"] == pytest.approx(rows.DT_err_um.mean(), abs=0.05)


def test_every_explanation_is_without_numbers_of_its_own(claims):
    for name, claim in claims.items():
        words = re.sub("|".join(map(re.escape, claims)), "", claim["otherwise"])
        words = re.sub(r"ca-\d\.\d", "", words)  # a reading
        assert not re.search(r"\d\.\d", words), name


def test_every_claim_that_does_not_come_out_is_explained(root, call, tmp_path, claims):
    plan = load_plan(root / "params/studies/krueger2014.json", "paper")
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    given = {"claims": root / "params/claims.json", "tables": root / "results/tables"}
    given["plan"] = tmp_path / "plan.json"
    experiment = root / "params/experiment/tweezer_experiment.csv"
    call("claims_table", **given, experiment=experiment, csv=tmp_path / "c.csv", markdown=tmp_path / "c.md")
    verdicts = pd.read_csv(tmp_path / "c.csv").fillna("").set_index("id")
    assert list(verdicts.index) == PAPER
    for name, row in verdicts.iterrows():
        assert row.explanation == (claims[name]["otherwise"] if row.verdict in OTHERWISE else ""), name


def test_readings_are_declared_as_the_pipeline_needs_them(root):
    readings = {one["id"]: one for one in read_json(root / "params/claims.json")["readings"]}
    assert list(readings)[:2] == ["default", "corrected"]
    for name, factor in (("ca-1.6", 1.6), ("ca-1.6-corrected", 1.6), ("default", None), ("corrected", None)):
        assert readings[name].get("capillary_factor") == factor
    for name in ("ca-1.6", "ca-1.6-corrected"):
        base = readings["corrected" if name.endswith("corrected") else "default"]
        assert [readings[name][key] for key in ("sweep", "series")] == [base["sweep"], base["series"]]
