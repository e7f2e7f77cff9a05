"""The time to go: jobs in words, what is learned from the jobs that are done, the line and the table."""

import pytest
from conftest import ROOT
from study.planning.plan import load_plan
from study.planning.progress import BELIEF, NEEDED, Job, Progress, described, duration, with_index


@pytest.fixture(scope="module")
def plan():
    plan = load_plan(ROOT / "params/studies/krueger2014.json", "quick")
    return with_index(plan, {run["id"]: 7.5 for run in plan["runs"]})


def solver_jobs(*seconds, chain=""):
    progress = Progress(cores=2)
    for number, expected in enumerate(seconds):
        progress.add(number, Job("passages", f"run {number}", expected, "passage", chain))
    return progress


def test_jobs_are_named_by_what_they_are(plan):
    run = next(run for run in plan["runs"] if run["labels"].get("sweep") == "grid")
    job = described("solve", {"run": run["id"]}, plan)
    assert (job.stage, job.name) == ("passages", "d = 2 Ca = 0.1")
    flow = next(run for run in plan["runs"] if run["group"] == "stokes")
    assert described("solve", {"run": flow["id"]}, plan).stage == "flows without a cell"
    assert described("figure_film", {}, plan).name == "figure film"
    assert job.seconds == 7.5


def test_the_first_estimate_is_the_expected_work_over_the_cores():
    assert solver_jobs(100.0, 100.0).left(0.0) == pytest.approx(100.0)


def test_a_machine_of_half_the_speed_is_known_after_some_runs():
    progress = solver_jobs(*[100.0] * 20)
    for number in range(10):
        progress.start(number, 0.0)
        progress.finish(number, 200.0)
    assert progress.factor("passage") == pytest.approx((2000 + BELIEF) / (1000 + BELIEF))
    assert progress.left(200.0) == pytest.approx(1000.0, rel=0.02)
    assert progress.line(200.0, lambda moment: f"at {moment:.0f}").startswith(
        "jobs 10 of 20, about 16 min left"
    )


def test_a_running_job_counts_for_what_it_still_takes():
    progress = solver_jobs(100.0)
    progress.start(0, 0.0)
    assert progress.left(60.0) == pytest.approx(20.0)
    assert progress.left(500.0) == pytest.approx(5.0)  # it takes longer than expected, and is not over
    assert "run 0 running" in progress.line(60.0, str)


def test_levels_of_a_bracket_wait_for_one_another_and_may_need_nothing():
    progress = solver_jobs(100.0, 100.0, chain="default/d6")
    assert progress.left(0.0) == pytest.approx(200.0 * NEEDED)
    progress.start(0, 0.0)
    progress.finish(0, 0.5)  # it asked for nothing, which says nothing of the machine
    assert progress.factor("passage") == 1.0
    assert progress.left(1.0) == pytest.approx(100.0 * 3 * NEEDED / 4)


def test_the_table_has_a_line_for_every_stage_and_the_estimate():
    progress = solver_jobs(60.0, 60.0)
    progress.add("t", Job("tables", "claims", 2.0))
    assert progress.table() == [
        "passages      2 jobs           about 2 min of one core",
        "tables        1 jobs    less than a minute of one core",
        "3 jobs, about 1 min on 2 cores",
    ]


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(5, "less than a minute"), (130, "about 2 min"), (7800, "about 2 h 10 min"), (86400, "about 24 h")],
)
def test_times_are_told_no_finer_than_they_are_known(seconds, words):
    assert duration(seconds) == words
