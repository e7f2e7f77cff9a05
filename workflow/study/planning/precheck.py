"""What the solver says of the cases of a plan before any of them runs (`dld resolve`): which it would refuse,
at their place in the file of the study, and what each will take."""

import hashlib
import json
from pathlib import Path

from study.planning.arrays import case_parts
from study.planning.brackets import at_value
from study.planning.cases import run_id
from study.planning.dld import answers
from study.planning.dld import words as words_of
from study.planning.documents import read_json
from study.planning.plan import CELLS, plan_points
from study.planning.tiers import expanded
from study.planning.validation import listing, load_json, pointer


class _Placed:
    """A value of a JSON file that knows where it stands there."""

    place = None


class _Whole(_Placed, int):
    pass


class _Number(_Placed, float):
    pass


class _Text(_Placed, str):
    pass


def placed(value, path=()):
    """A JSON value whose numbers and texts know their JSON pointer."""
    if isinstance(value, dict):
        return {key: placed(item, (*path, key)) for key, item in value.items()}
    if isinstance(value, list):
        return [placed(item, (*path, number)) for number, item in enumerate(value)]
    if isinstance(value, bool) or value is None:
        return value
    known = {str: _Text, int: _Whole, float: _Number}[type(value)](value)
    known.place = pointer(path)
    return known


def place_in(overlay, case_pointer):
    """Where a value of an overlay was written; None for a default or a value that was computed."""
    value = overlay
    for key in case_pointer.strip("/").split("/"):
        value = value.get(key) if isinstance(value, dict) else None
    return getattr(value, "place", None)


def bracket_cases(definition):
    """Cases of a bracket beside the ends of its range: its first step, where it goes by steps, and the ends
    with the settings that confirm them."""
    axis, values = definition["axis"], [value for value, _ in definition["known"]]
    found = (
        [at_value(definition["case"], axis, values[0] + definition["step"])] if "step" in definition else []
    )
    for case in definition["confirm"].values():
        found += [at_value(case, axis, value) for value in (values[0], values[-1])]
    return found


def cases_of(plan):
    """{identity: resolved case} of everything that a plan may ask the solver for, short of the inner points
    of its brackets."""
    found = {run["id"]: run["case"] for run in plan["runs"]}
    for definition in plan["brackets"].values():
        for case in (*bracket_cases(definition), *definition["confirm"].values()):
            found[run_id(case, plan["solver_model"])] = case
    return found


def refusals(study_path, plan, case_schema, refused):
    """One line for each thing that the solver refuses, with the place in the file of the study that it comes
    from and the first run that asks for it; `refused` are the problems by identity of the run."""
    document = placed(load_json(study_path))
    tier = expanded(document["tiers"], plan["tier"]) | case_parts(document, CELLS)
    found, counts = {}, {}
    for words, overlay, identity in plan_points(tier, plan, case_schema):
        for problem in refused.get(identity, ()):
            place = place_in(overlay, problem["pointer"])
            key = (place, words_of(problem))
            found.setdefault(key, words)
            counts[key] = counts.get(key, 0) + 1
    lines = []
    for (place, text), words in found.items():
        more = counts[place, text] - 1
        asked_by = f"asked for by {words}" + (f" and {more} more" if more else "")
        lines.append(f"{place or '/tiers/' + plan['tier']}: {text} ({asked_by})")
    return lines


def is_current(dld, sources):
    """Is the solver there and not older than what it is made from?"""
    file = Path(dld)
    made = file.stat().st_mtime if file.exists() else 0
    return made > 0 and all(Path(source).stat().st_mtime <= made for source in sources)


def seconds_of_runs(study_path, plan, case_schema, dld, kept):
    """Seconds on one core that each case of a plan is expected to take, {identity: seconds}.

    A ValueError lists every case that the solver refuses. The answer is kept in the file `kept` and taken
    from there while cases and solver are the same.
    """
    cases = cases_of(plan)
    state = Path(dld).stat()
    key = json.dumps([sorted(cases), state.st_mtime_ns, state.st_size])
    key = hashlib.sha256(key.encode()).hexdigest()
    if Path(kept).exists() and (before := read_json(kept))["key"] == key:
        return before["seconds"]
    found = dict(zip(cases, answers(list(cases.values()), dld), strict=True))
    refused = {one: answer["problems"] for one, answer in found.items() if answer["problems"]}
    if refused:
        lines = refusals(study_path, plan, case_schema, refused)
        raise ValueError(listing(f"{study_path}: cases that the solver refuses", lines))
    seconds = {one: answer["expected_cost"]["seconds_on_one_core"] for one, answer in found.items()}
    Path(kept).parent.mkdir(parents=True, exist_ok=True)
    Path(kept).write_text(json.dumps({"key": key, "seconds": seconds}) + "\n", encoding="utf-8")
    return seconds
