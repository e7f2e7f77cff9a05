"""The plan of a tier: which solver runs it needs, each with its resolved case and its identity."""

from itertools import product
from pathlib import Path

from study.planning import points, stability
from study.planning.arrays import case_parts, with_moduli
from study.planning.brackets import AXES, at_value, off_axis
from study.planning.cases import fingerprint, radius_um, resolved, run_id
from study.planning.documents import SCHEMAS, read_json
from study.planning.points import merged
from study.planning.tiers import load_study
from study.planning.validation import hint, listing

CELLS = Path(__file__).resolve().parents[3] / "params" / "cells"

#: (section, source of runs known beforehand), in the order of the plan.
SOURCES = [
    ("streamlines", points.streamlines),
    ("stokes", points.stokes),
    ("stretching", points.stretching),
    ("passages", points.passages),
    ("sensitivity", points.sensitivity),
    ("stability", stability.maps),
    ("stability", stability.long_run),
]

#: The same for brackets, whose runs come while they narrow.
BRACKET_SOURCES = [
    ("boundary", points.boundary_brackets),
    ("sensitivity", points.sensitivity_brackets),
    ("uncertainty", points.uncertainty_brackets),
]

#: Last, so that the brackets do not wait for runs that only the targets `uncertainty` and `accuracy` need.
LAST_SOURCES = [
    ("uncertainty", points.uncertainty_cells),
    ("accuracy", points.accuracy),
    ("accuracy", points.settings_check),
]


class _Planner:
    """Resolves and names the runs of a tier."""

    def __init__(self, case_schema):
        self.case_schema, self.solver_model = case_schema, case_schema["x-solver-model"]

    def all_of(self, sources, tier):
        """The runs of some sources; a ValueError that lists every case that is none."""
        runs, found = [], []
        for group, labels, overlay in (point for source in sources for point in source(tier)):
            try:
                runs.append(self.run(group, labels, overlay))
            except ValueError as error:
                found.append(
                    f"{group} {' '.join(f'{key}={value}' for key, value in labels.items())}: {error}"
                )
        if found:
            raise ValueError(listing("cases of the study that the solver would refuse", found))
        return runs

    def run(self, group, labels, overlay):
        case = resolved(overlay, self.case_schema)
        return {"id": run_id(case, self.solver_model), "group": group, "labels": labels, "case": case}

    def bracket(self, name, definition, overlay, static):
        """Definition of a bracket, with the runs of the plan that lie on its axis as its known points."""
        axis, ends = definition["axis"], definition.pop("ends")
        group = "uncertainty" if definition["kind"] == "uncertainty" else "boundary"
        run = self.run(group, {"sweep": f"boundary/{definition['series']}", "bracket": name}, overlay)
        case = run["case"]
        runs = [run | {"case": at_value(case, axis, end)} for end in ends]
        runs = [end | {"id": run_id(end["case"], self.solver_model)} for end in runs]
        section, key = AXES[axis]
        on_axis = static.get(fingerprint(off_axis(case, axis)), {})
        known = on_axis | {end["case"][section][key]: end["id"] for end in runs}
        known = {value: run for value, run in known.items() if ends[0] <= value <= ends[1]}
        confirm = {
            label: resolved(merged(overlay, part), self.case_schema)
            for label, part in definition["confirm"].items()
        }
        whole = definition | {"name": name, "case": case, "confirm": confirm, "known": sorted(known.items())}
        return whole | {"identity": fingerprint(whole | {"solver_model": self.solver_model})}, runs


def _by_line(passages, axis):
    """Runs by the line along the axis on which they lie: {line: {value: id}}."""
    section, key = AXES[axis]
    lines = {}
    for run in passages:
        line = lines.setdefault(fingerprint(off_axis(run["case"], axis)), {})
        if key in run["case"][section]:
            line[run["case"][section][key]] = run["id"]
    return lines


def _present(tier, sources):
    """The sources whose section the tier has."""
    return [source for section, source in sources if section in tier]


def make_plan(study, tier_name, case_schema):
    """The plan of a tier: its settings, its runs (id, group, labels, resolved case) and its brackets."""
    if tier_name not in study["tiers"]:
        raise ValueError(f"there is no tier '{tier_name}'; {hint(tier_name, study['tiers'])}")
    tier = study["tiers"][tier_name] | case_parts(study, CELLS)
    planner = _Planner(case_schema)
    runs = planner.all_of(_present(tier, SOURCES), tier)
    passages = [run for run in runs if run["case"]["scene"] == "passage"]
    static = {axis: _by_line(passages, axis) for axis in AXES}
    brackets = {}
    for source in _present(tier, BRACKET_SOURCES):
        for name, definition, overlay in source(tier):
            found = planner.bracket(name, definition, overlay, static[definition["axis"]])
            brackets[name] = found[0]
            runs += found[1]
    runs += planner.all_of(_present(tier, LAST_SOURCES), tier)
    return {
        "study": study["title"],
        "purpose": study["purpose"],
        "tier": tier_name,
        "note": tier["note"],
        "solver_model": planner.solver_model,
        "devices": tier["devices"],
        "cells": with_moduli(study["cells"], tier),
        "radius_um": {name: radius_um(part, case_schema) for name, part in tier["cells"].items()},
        "sections": [name for name in tier if name in points.SECTIONS],
        "refinement": tier.get("streamlines", {}).get("refinement", {}),
        "uncertainty": tier.get("uncertainty", {}).get("rows", []),
        **{name: tier[name] for name in ("sensitivity", "accuracy", "figures") if name in tier},
        "brackets": brackets,
        "runs": runs,
    }


def plan_points(tier, plan, case_schema):
    """(words, overlay, identity) of every point of a tier: what it is called, what it says itself, its run.

    The values of the tier go into the overlays as they are, so that they can carry marks of where they come
    from.
    """
    for group, labels, overlay in (
        point for source in _present(tier, SOURCES + LAST_SOURCES) for point in source(tier)
    ):
        words = " ".join([group, *(f"{key}={value}" for key, value in labels.items())])
        yield words, overlay, run_id(resolved(overlay, case_schema), plan["solver_model"])
    for name, definition, overlay in (
        point for source in _present(tier, BRACKET_SOURCES) for point in source(tier)
    ):
        (section, key), (low, high) = AXES[definition["axis"]], definition["ends"]
        step = [low + definition["step"]] if "step" in definition else []
        for value, part in product((low, high, *step), ({}, *definition["confirm"].values())):
            point = merged(overlay, part, {section: {key: value}})
            yield f"bracket {name}", point, run_id(resolved(point, case_schema), plan["solver_model"])


def load_plan(study_path, tier_name):
    """The plan of a tier straight from the study's file."""
    return make_plan(load_study(study_path), tier_name, read_json(SCHEMAS / "case.schema.json"))
