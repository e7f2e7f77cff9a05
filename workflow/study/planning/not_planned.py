"""What was asked for by the name of a file and is in no plan: said in words, with what to ask for instead."""

from pathlib import Path

from study.planning.documents import SCHEMAS, read_json
from study.planning.folders import PAPER, STUDIES
from study.planning.plan import make_plan
from study.planning.tiers import load_study
from study.planning.validation import hint


class NotPlanned(Exception):
    """A run, a bracket or a label that the plan does not have."""


def found(known, name, told, *about):
    """The entry of a dictionary; if there is none, a NotPlanned with what the function `told` says of it."""
    if name not in known:
        raise NotPlanned(told(name, *about))
    return known[name]


def options(study, tier, first):
    """Words of Snakemake that ask for a tier of a study."""
    chosen = ([] if study == PAPER else [f"study={study}"]) + ([] if tier == first else [f"tier={tier}"])
    return f" --config {' '.join(chosen)}" if chosen else ""


def plans_of(run):
    """(study, tier, first tier of the study) of every plan that has a run."""
    schema = read_json(SCHEMAS / "case.schema.json")
    for file in sorted(STUDIES.glob("*.json")):
        try:
            study = load_study(str(file))
            tiers = [
                tier
                for tier in study["tiers"]
                if run in {planned["id"] for planned in make_plan(study, tier, schema)["runs"]}
            ]
        except ValueError:  # another study, with faults of its own
            continue
        yield from ((file.stem, tier, next(iter(study["tiers"]))) for tier in tiers)


def no_such_run(run, study, tier, folder):
    """What to say of a run that a plan does not have."""
    words = f"{folder}/{run}: this run is in no section of tier {tier} of study {Path(study).stem}. "
    call = f"snakemake --cores 2 {folder}/{run}/summary.json"
    calls = [f"{call}{options(*plan)} (tier {plan[1]} of study {plan[0]})" for plan in plans_of(run)]
    if calls:
        return words + "Ask for it where it is planned: " + "; or ".join(calls)
    return words + (
        f"No other study of {STUDIES} plans it either. A run is named by its case and by the model of the "
        "solver. So it is that of a point of a bracket, which the bracket asks for "
        "(brackets/NAME/level-N.json in the folder of the results), or of a case as it was before the study, "
        "a default or the solver changed. The runs that can be asked for stand in plan.json beside the tables"
    )


def no_such_bracket(name, study, tier, known):
    """What to say of a bracket that a plan does not have."""
    return f"bracket {name}: tier {tier} of study {Path(study).stem} has no such bracket; {hint(name, known)}"


def no_such_label(label, bracket, known):
    """What to say of a setting that does not confirm the ends of a bracket."""
    words = f"bracket {bracket} is not confirmed with '{label}'; "
    return words + (hint(label, known) if known else "it is confirmed with nothing")
