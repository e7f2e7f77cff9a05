"""The order of the jobs: the most work behind a job comes first, and it is near what passages took."""

import pandas as pd
import pytest
from study.plan import load_plan
from study.schedule import bracket_priority, expected_updates, run_priorities


@pytest.fixture(scope="module")
def plan(root):
    return load_plan(root / "params/studies/krueger2014.json", "paper")


def test_the_expected_work_is_that_of_the_committed_passages_to_a_factor_of_three(root, plan):
    table = pd.read_csv(root / "results/tables/passages.csv").drop_duplicates("run").set_index("run")
    cases = {run["id"]: run["case"] for run in plan["runs"] if run["id"] in table.index}
    ratio = pd.Series({run: table.node_updates[run] / expected_updates(case) for run, case in cases.items()})
    for dx, group in ratio.groupby(table.dx_um.reindex(ratio.index)):
        assert 1 / 3 < group.median() < 3, dx


def test_a_run_that_a_bracket_begins_with_has_the_priority_of_the_chain(plan):
    priorities = run_priorities(plan)
    assert set(priorities) == {run["id"] for run in plan["runs"]}
    for bracket in plan["brackets"].values():
        levels = [bracket_priority(bracket, level) for level in range(bracket["levels"] + 1)]
        assert levels == sorted(levels, reverse=True) and levels[-1] > 0
        assert all(priorities[run] >= levels[0] for _, run in bracket["known"])


def test_the_longest_chain_is_on_the_finest_lattice(plan):
    longest = max(plan["brackets"].values(), key=lambda bracket: bracket_priority(bracket, 0))
    spacings = [bracket["case"]["fluid"]["lattice_spacing_um"] for bracket in plan["brackets"].values()]
    assert longest["case"]["fluid"]["lattice_spacing_um"] == min(spacings)
