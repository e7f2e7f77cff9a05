"""The runs behind a claim: which they are, their cases, and how alike they come out."""

import pandas as pd
import pytest
from study.paper.claim_runs import case_of_run, judged, numbers_in, numbers_of, runs_of_claim
from study.planning.cases import run_id
from study.planning.plan import load_plan


@pytest.fixture(scope="module")
def committed(root):
    return {
        name: pd.read_csv(root / f"results/{name}.csv", dtype=str, keep_default_na=False)
        for name in ("claims", "tables/passages", "tables/streamline_separation", "tables/stretching")
    }


@pytest.fixture(scope="module")
def plan(root):
    return load_plan(root / "params/studies/krueger2014.json", "paper")


def test_every_run_behind_every_claim_has_its_case_in_the_study(committed, plan):
    verdicts = committed["claims"].replace("", None)
    with_runs = verdicts.id[verdicts.runs.notna()]
    assert len(with_runs) >= 20
    for claim in with_runs:
        for run in runs_of_claim(verdicts, claim):
            case = case_of_run(run, committed["tables/passages"], plan)
            assert run_id(case, plan["solver_model"]) == run, claim


def test_a_claim_without_runs_is_named_with_those_that_have_some(committed):
    with pytest.raises(ValueError, match=r"claim=nonsense: no runs .* phase-boundary"):
        runs_of_claim(committed["claims"].replace("", None), "nonsense")


def test_flows_and_stretched_cells_are_compared_with_their_rows(committed):
    flow = committed["tables/streamline_separation"]
    row = flow[flow.run != ""].iloc[0]
    before = numbers_in(flow, row.run, "streamlines")
    summary = {"separation_um": float(row.s_um), "resistance_Pa_s_per_m2": float(row.resistance_Pa_s_per_m2)}
    assert judged(before, numbers_of(summary, "streamlines")) == ("same", [])
    summary["separation_um"] *= 1.003
    assert judged(before, numbers_of(summary, "streamlines")) == ("alike", ["s_um"])
    summary["separation_um"] *= 1.01
    assert judged(before, numbers_of(summary, "streamlines")) == ("other", ["s_um"])
    cells = committed["tables/stretching"]
    assert len(numbers_in(cells, cells.run.iloc[0], "stretching")["axial_um"]) == 3
    assert numbers_in(cells, "0" * 12, "stretching") == {}
