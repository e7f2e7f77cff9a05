"""A file that no plan has is refused in words that say what to ask for."""

import pytest
from study.planning.documents import SCHEMAS, read_json
from study.planning.not_planned import NotPlanned, found, no_such_bracket, no_such_label, no_such_run, options
from study.planning.plan import make_plan

STUDY = "params/studies/krueger2014.json"


@pytest.fixture(autouse=True)
def here(root, monkeypatch):
    monkeypatch.chdir(root)


@pytest.fixture(scope="session")
def smoke(study):
    schema = read_json(SCHEMAS / "case.schema.json")
    return make_plan(study, "smoke", schema), make_plan(study, "paper", schema)


def test_a_run_of_another_tier_is_told_with_the_call_that_makes_it(smoke):
    here, paper = ({run["id"] for run in plan["runs"]} for plan in smoke)
    run = sorted(here - paper)[0]
    told = no_such_run(run, STUDY, "paper", "results/runs")
    assert told.startswith(
        f"results/runs/{run}: this run is in no section of tier paper of study krueger2014."
    )
    assert f"snakemake --cores 2 results/runs/{run}/summary.json --config tier=smoke" in told


def test_a_run_of_no_plan_is_told():
    told = no_such_run("0" * 12, STUDY, "paper", "results/runs")
    assert "No other study of params/studies plans it" in told and "plan.json" in told


def test_the_words_of_a_call_name_study_and_tier():
    assert options("krueger2014", "paper", "paper") == ""
    assert options("triangle", "smoke", "full") == " --config study=triangle tier=smoke"


def test_an_unknown_bracket_and_label_are_told_with_the_nearest(smoke):
    brackets = smoke[0]["brackets"]
    assert "did you mean 'default/d4'?" in no_such_bracket("default/d44", STUDY, "smoke", brackets)
    assert "did you mean 'fine'?" in no_such_label("fin", "default/d4", {"fine": {}})
    assert "with nothing" in no_such_label("fin", "default/d4", {})


def test_what_is_known_is_found_and_nothing_is_told_for_it():
    def told(name, place):
        return f"no {name} in {place}"

    assert found({"a": 1}, "a", told, "b") == 1
    with pytest.raises(NotPlanned, match=r"^no a in b$"):
        found({}, "a", told, "b")
