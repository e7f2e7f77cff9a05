"""The plan of a tier: which solver runs it needs, each with its resolved case and its identity.

A run's identity is a hash of its resolved parameters, so two sweeps that ask for the same point share it.
Defaults come from the case schema that the solver prints (`dld schema`), not from a copy.
"""

import hashlib
import json
from itertools import product
from pathlib import Path

from study.planning import meshes, points, stability
from study.planning.arrays import case_parts, with_moduli
from study.planning.brackets import AXES, at_value, off_axis
from study.planning.dld import in_capillary_number
from study.planning.points import merged
from study.planning.validation import (
    chain,
    hint,
    inconsistencies,
    listing,
    load_json,
    misshapen,
    only_with_claims,
    pointer,
    unprintable,
    violations,
    written_at,
)

ROOT = Path(__file__).resolve().parents[3]
SCHEMAS = ROOT / "workflow" / "schemas"
CELLS = ROOT / "params" / "cells"

#: (section, key, keys whose place it takes): two ways of saying the same, of which a case has one.
ALTERNATIVES = [
    ("geometry", "epsilon", ["row_shift_um"]),
    ("geometry", "pillar", ["pillar_shape", "pillar_radius_um"]),
]


def read_json(path):
    """The document of a file that the pipeline wrote itself."""
    return json.loads(Path(path).read_text(encoding="utf-8"))


def problems(document, schema):
    """All violations of a schema, one line each with the JSON pointer of the place."""
    return [f"{pointer(path)}: {text}" for path, text in violations(document, schema)]


def validated(path, schema_name):
    """The document of a file, or a ValueError that lists every violation of its schema."""
    document = load_json(path)
    found = problems(document, read_json(SCHEMAS / f"{schema_name}.schema.json"))
    found += [f"{pointer(path)}: {text}" for path, text in unprintable(document)]
    if found:
        raise ValueError(listing(path, found))
    return document


def with_defaults(value, schema):
    """A value with the defaults of its schema filled in and whole numbers written as the schema's type."""
    if "properties" in schema:
        filled = {}
        for key, part in schema["properties"].items():
            if key in (value or {}):
                filled[key] = with_defaults(value[key], part)
            elif "properties" in part:
                filled[key] = with_defaults({}, part)
            elif "default" in part:
                filled[key] = with_defaults(part["default"], part)
        return filled
    if schema.get("type") == "number":
        return float(value)
    if isinstance(value, list):
        return [with_defaults(item, schema.get("items", {})) for item in value]
    return value


def with_preset(case, case_schema):
    """The case with the settings of its preset (`accuracy`) where it says nothing itself.

    The presets are an annotation of the case schema, so that they are declared in the solver alone.
    """
    accuracy = case_schema["properties"]["accuracy"]
    return merged(accuracy["x-presets"][case.get("accuracy", accuracy["default"])], case)


def _size_by_shape(given, cell):
    """Leaves r to the solver where the shape has a size of its own."""
    if cell["shape"] in ("ellipsoid", "mesh") and "radius_um" not in given:
        del cell["radius_um"]


def resolved(case, case_schema):
    """The case with all defaults, reduced to the sections that its scene reads (an annotation of the schema,
    as the presets are); a ValueError that lists every violation of the schema."""
    found = problems(case, case_schema)
    if found:
        raise ValueError("; ".join(found))
    case = meshes.placed(case)
    if "operating" in case:
        case = in_capillary_number(case)
    full = with_defaults(with_preset(case, case_schema), case_schema)
    _size_by_shape(case.get("cell", {}), full["cell"])
    for section, given, replaced in ALTERNATIVES:
        if given in case.get(section, {}):
            for key in replaced:
                full[section].pop(key, None)
    if "x_um" not in case.get("cell", {}).get("start", {}):
        full["cell"]["start"]["x_um"] = -full["geometry"]["pitch_um"] / 2  # between two rows of any device
    sections = case_schema["properties"]["scene"]["x-sections"][full["scene"]]
    return {"scene": full["scene"]} | {name: full[name] for name in sections}


def run_id(case, solver_model):
    """Identity of a run: the hash of its resolved case."""
    return _fingerprint({"case": meshes.identified(case), "solver_model": solver_model})


#: What a tier has that leaves a part of the study out, once it was found to follow its schema.
LEFT_OUT = {
    "uncertainty": {"case": {}, "series": {}, "rows": []},
    "sensitivity": {
        "case": {},
        "flow_case": {},
        "points": [],
        "choices": {},
        "boundary": {
            "reference": "",
            "choices": [],
            "row_shifts_um": [],
            "ca_range": [0.1, 1.0],
            "levels": 1,
        },
    },
}


def _taken_away(full, overlay, place):
    """`full` without what the overlay gives as null; a ValueError where a null takes nothing away."""
    kept = dict(full)
    for key, value in overlay.items():
        if value is None and key not in full:
            found = (
                f"{pointer([*place, key])}: null takes away what the extended tier has, and it has no '{key}'"
            )
            raise ValueError(f"{found}; {hint(key, full)}")
        if value is None:
            del kept[key]
        elif isinstance(value, dict) and isinstance(full.get(key), dict):
            kept[key] = _taken_away(full[key], value, [*place, key])
    return kept


def expanded(tiers, name):
    """A tier with what it does not say itself taken from the tier that it `extends`, and without what it
    gives as null."""
    *own, first = chain(tiers, name)
    full = tiers[first]
    for part in reversed(own):
        full = _taken_away(full, tiers[part], ["tiers", part])
        full = merged(full, _without_nulls(tiers[part]))
    return {key: value for key, value in full.items() if key != "extends"}


def _without_nulls(overlay):
    return {
        key: _without_nulls(value) if isinstance(value, dict) else value
        for key, value in overlay.items()
        if value is not None
    }


def load_study(path):
    """The study of a file with every tier in full; a ValueError that lists all that is wrong with it, at the
    place where it stands in the file."""
    study = load_json(path)
    found = [f"{pointer(place)}: {text}" for place, text in misshapen(study)]
    if found:
        raise ValueError(listing(path, found))
    tiers = study["tiers"]
    try:
        in_full = study | {"tiers": {name: expanded(tiers, name) for name in tiers}}
    except ValueError as error:
        raise ValueError(listing(path, [str(error)])) from None
    found = list(violations(in_full, read_json(SCHEMAS / "study.schema.json")))
    if not found:  # only a study that follows its schema has the names and ranges that are compared
        if "claims" in study:  # the rules of the print ask every tier for these
            in_full["tiers"] = {name: LEFT_OUT | tier for name, tier in in_full["tiers"].items()}
        found = [
            (["tiers", name, *place], text)
            for name, tier in in_full["tiers"].items()
            for place, text in (
                *inconsistencies(tier, study["devices"], study["cells"]),
                *(() if "claims" in study else only_with_claims(tier)),
            )
        ]
    if found:  # what a tier takes from another is wrong once, where it is written
        placed = {pointer(written_at(tiers, place)): text for place, text in reversed(found)}
        raise ValueError(listing(path, [f"{place}: {text}" for place, text in reversed(placed.items())]))
    return in_full


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
        on_axis = static.get(_fingerprint(off_axis(case, axis)), {})
        known = on_axis | {end["case"][section][key]: end["id"] for end in runs}
        known = {value: run for value, run in known.items() if ends[0] <= value <= ends[1]}
        confirm = {
            label: resolved(merged(overlay, part), self.case_schema)
            for label, part in definition["confirm"].items()
        }
        whole = definition | {"name": name, "case": case, "confirm": confirm, "known": sorted(known.items())}
        return whole | {"identity": _fingerprint(whole | {"solver_model": self.solver_model})}, runs


def _fingerprint(value):
    """The first 12 hexadecimal digits of the hash of a JSON value."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def radius_um(part, case_schema):
    """Radius r of a cell, um, from its part of a case; None where the solver takes it from a mesh."""
    cell = with_defaults(part["cell"], case_schema["properties"]["cell"])
    _size_by_shape(part["cell"], cell)
    return meshes.radius_um(cell)


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
#: Last, so that the brackets do not wait for runs that only the target `accuracy` needs.
LAST_SOURCES = [("accuracy", points.accuracy), ("accuracy", points.settings_check)]


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


def study_brackets(plan):
    """The brackets of the study by name; those of the target `uncertainty` are not among them."""
    return {name: found for name, found in plan["brackets"].items() if found["kind"] != "uncertainty"}


def _by_line(passages, axis):
    """Runs by the line along the axis on which they lie: {line: {value: id}}."""
    section, key = AXES[axis]
    lines = {}
    for run in passages:
        line = lines.setdefault(_fingerprint(off_axis(run["case"], axis)), {})
        if key in run["case"][section]:
            line[run["case"][section][key]] = run["id"]
    return lines


def load_plan(study_path, tier_name):
    """The plan of a tier straight from the study's file."""
    return make_plan(load_study(study_path), tier_name, read_json(SCHEMAS / "case.schema.json"))


def _plan_lines(name, value):
    """One entry of the plan; lists and dictionaries have one element a line, so that plans compare well."""
    if isinstance(value, list):
        inner = ",\n".join(json.dumps(item) for item in value)
        return f"{json.dumps(name)}: [\n{inner}\n]"
    if isinstance(value, dict):
        inner = ",\n".join(f"{json.dumps(key)}: {json.dumps(item)}" for key, item in value.items())
        return f"{json.dumps(name)}: {{\n{inner}\n}}"
    return f"{json.dumps(name)}: {json.dumps(value)}"


def write_plan(plan, path):
    """Writes the plan unless the file has it already, so that its time is that of its last change; returns
    the path."""
    text = "{\n" + ",\n".join(_plan_lines(name, value) for name, value in plan.items()) + "\n}\n"
    file = Path(path)
    if not file.exists() or file.read_text(encoding="utf-8") != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        part = file.with_suffix(".part")
        part.write_text(text, encoding="utf-8")
        part.replace(file)
    return path


def ids(plan, *groups):
    """Identities of the runs of the given groups, each once, in the order of the plan."""
    return list(dict.fromkeys(run["id"] for run in plan["runs"] if run["group"] in groups))
