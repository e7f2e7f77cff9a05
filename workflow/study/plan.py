"""The plan of a tier: which solver runs it needs, each with its resolved case and its identity.

A run's identity is a hash of its resolved parameters, so two sweeps that ask for the same point share it.
Defaults come from the case schema that the solver prints (`dld schema`), not from a copy.
"""

import hashlib
import json
from itertools import product
from pathlib import Path

from study import points, stability
from study.brackets import AXES, at_value, off_axis
from study.dld import in_capillary_number
from study.points import merged
from study.validation import (
    chain,
    hint,
    inconsistencies,
    listing,
    load_json,
    misshapen,
    pointer,
    violations,
    written_at,
)

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "workflow" / "schemas"

#: Where the runs of a tier come from, before and after its brackets, and its brackets.
SOURCES = (points.streamlines, points.stokes, points.stretching, points.passages, points.sensitivity)
SOURCES += (stability.maps, stability.long_run)
BRACKET_SOURCES = (points.boundary_brackets, points.sensitivity_brackets, points.uncertainty_brackets)
LAST_SOURCES = (points.accuracy, points.settings_check)


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


def resolved(case, case_schema):
    """The case with all defaults, reduced to the sections that its scene reads (an annotation of the schema,
    as the presets are); a ValueError that lists every violation of the schema."""
    found = problems(case, case_schema)
    if found:
        raise ValueError("; ".join(found))
    if "operating" in case:
        case = in_capillary_number(case)
    full = with_defaults(with_preset(case, case_schema), case_schema)
    if "epsilon" in case.get("geometry", {}):
        full["geometry"].pop("row_shift_um", None)
    sections = case_schema["properties"]["scene"]["x-sections"][full["scene"]]
    return {"scene": full["scene"]} | {name: full[name] for name in sections}


def run_id(case, solver_model):
    """Identity of a run: the hash of its resolved case."""
    return _fingerprint({"case": case, "solver_model": solver_model})


def expanded(tiers, name):
    """A tier with what it does not say itself taken from the tier that it `extends`."""
    full = merged(*(tiers[part] for part in reversed(chain(tiers, name))))
    full.pop("extends", None)
    return full


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
        found = [
            (["tiers", name, *place], text)
            for name, tier in in_full["tiers"].items()
            for place, text in inconsistencies(tier)
        ]
    if found:  # what a tier takes from another is wrong once, where it is written
        placed = {pointer(written_at(tiers, place)): text for place, text in reversed(found)}
        raise ValueError(listing(path, [f"{place}: {text}" for place, text in reversed(placed.items())]))
    return in_full


class _Planner:
    """Resolves and names the runs of a tier."""

    def __init__(self, case_schema, solver_model):
        self.case_schema, self.solver_model = case_schema, solver_model

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


def make_plan(study, tier_name, case_schema):
    """The plan of a tier: its settings, its runs (id, group, labels, resolved case) and its brackets."""
    if tier_name not in study["tiers"]:
        raise ValueError(f"there is no tier '{tier_name}'; {hint(tier_name, study['tiers'])}")
    tier = study["tiers"][tier_name]
    planner = _Planner(case_schema, study["solver_model"])
    runs = planner.all_of(SOURCES, tier)
    passages = [run for run in runs if run["case"]["scene"] == "passage"]
    static = {axis: _by_line(passages, axis) for axis in AXES}
    brackets = {}
    for source in BRACKET_SOURCES:
        for name, definition, overlay in source(tier):
            found = planner.bracket(name, definition, overlay, static[definition["axis"]])
            brackets[name] = found[0]
            runs += found[1]
    # Last, so that the brackets do not wait for runs that only the target `accuracy` needs.
    runs += planner.all_of(LAST_SOURCES, tier)
    return {
        "tier": tier_name,
        "note": tier["note"],
        "solver_model": study["solver_model"],
        "refinement": tier["streamlines"]["refinement"],
        "uncertainty": tier["uncertainty"]["rows"],
        "sensitivity": tier["sensitivity"],
        "accuracy": tier["accuracy"],
        "figures": tier["figures"],
        "brackets": brackets,
        "runs": runs,
    }


def plan_points(tier, plan, case_schema):
    """(words, overlay, identity) of every point of a tier: what it is called, what it says itself, its run.

    The values of the tier go into the overlays as they are, so that they can carry marks of where they come
    from.
    """
    for group, labels, overlay in (point for source in SOURCES + LAST_SOURCES for point in source(tier)):
        words = " ".join([group, *(f"{key}={value}" for key, value in labels.items())])
        yield words, overlay, run_id(resolved(overlay, case_schema), plan["solver_model"])
    for name, definition, overlay in (point for source in BRACKET_SOURCES for point in source(tier)):
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
