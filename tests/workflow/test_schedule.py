"""The order of the jobs: the most work behind a job comes first, and it is near what passages took."""

import pandas as pd
import pytest
from short_passage import DLD, needs_solver
from study.planning.dld import answers
from study.planning.documents import SCHEMAS, read_json
from study.planning.plan import load_plan
from study.planning.precheck import seconds_of_runs
from study.planning.schedule import bracket_priority, case_priority, run_priorities

pytestmark = needs_solver


@pytest.fixture(scope="module")
def plan(root):
    return load_plan(root / "params/studies/krueger2014.json", "paper")


@pytest.fixture(scope="module")
def seconds(root, plan, tmp_path_factory):
    kept, schema = tmp_path_factory.mktemp("kept") / "seconds.json", read_json(SCHEMAS / "case.schema.json")
    return seconds_of_runs(root / "params/studies/krueger2014.json", plan, schema, DLD, kept)


def test_the_expected_work_is_that_of_the_committed_passages_to_a_factor_of_three(root, plan):
    table = pd.read_csv(root / "results/tables/passages.csv").drop_duplicates("run").set_index("run")
    cases = {run["id"]: run["case"] for run in plan["runs"] if run["id"] in table.index}
    expected = [answer["expected_cost"]["node_updates"] for answer in answers(list(cases.values()), DLD)]
    ratio = table.node_updates[list(cases)] / expected
    for dx, group in ratio.groupby(table.dx_um.reindex(ratio.index)):
        assert 1 / 3 < group.median() < 3, dx


def test_a_run_that_a_bracket_begins_with_has_the_priority_of_the_chain(plan, seconds):
    priorities = run_priorities(plan, seconds)
    assert set(priorities) == {run["id"] for run in plan["runs"]}
    for bracket in plan["brackets"].values():
        levels = [bracket_priority(bracket, level, plan, seconds) for level in range(bracket["levels"] + 1)]
        assert levels == sorted(levels, reverse=True) and levels[-1] > 0
        assert all(priorities[run] >= levels[0] for _, run in bracket["known"])
        assert all(case_priority(case, plan, seconds) > 0 for case in bracket["confirm"].values())


def test_without_a_solver_every_job_has_the_same_priority(plan):
    assert set(run_priorities(plan, {}).values()) == {0}


def test_the_longest_chain_is_on_the_finest_lattice(plan, seconds):
    def behind(bracket):
        return bracket_priority(bracket, 0, plan, seconds)

    longest = max(plan["brackets"].values(), key=behind)
    spacings = [bracket["case"]["fluid"]["lattice_spacing_um"] for bracket in plan["brackets"].values()]
    assert longest["case"]["fluid"]["lattice_spacing_um"] == min(spacings)
