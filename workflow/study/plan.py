"""The plan of a tier: which solver runs it needs, each with its resolved case and its identity.

A run's identity is a hash of its resolved parameters, so two sweeps that ask for the same point share it.
Defaults come from the case schema that the solver prints (`dld schema`), not from a copy.
"""

import hashlib
import json
from itertools import product
from pathlib import Path

from jsonschema import Draft202012Validator

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "workflow" / "schemas"

#: Sections of a case that a scene reads; the others would only split identical runs.
SECTIONS = {
    "streamlines": ["geometry", "fluid", "stop", "output"],
    "passage": ["geometry", "fluid", "cell", "coupling", "stop", "output"],
    "stretching": ["geometry", "fluid", "cell", "coupling", "stop", "stretching", "output"],
    "shear": ["fluid", "cell", "coupling", "stop", "shear", "output"],
    "channel": ["geometry", "fluid", "stop", "channel", "output"],
}


def read_json(path):
    return json.loads(Path(path).read_text(encoding="utf-8"))


def problems(document, schema):
    """All violations of a schema, one line each with the JSON pointer of the place."""
    errors = sorted(Draft202012Validator(schema).iter_errors(document), key=lambda e: list(map(str, e.path)))
    return ["/" + "/".join(map(str, error.path)) + ": " + error.message for error in errors]


def validated(path, schema_name):
    """The document of a file, or a ValueError that lists every violation of its schema."""
    document = read_json(path)
    found = problems(document, read_json(SCHEMAS / f"{schema_name}.schema.json"))
    if found:
        raise ValueError(f"{path} does not follow the {schema_name} schema:\n  " + "\n  ".join(found))
    return document


def merged(*overlays):
    """Nested dictionaries laid over one another; the last one wins, leaf by leaf."""
    result = {}
    for overlay in overlays:
        for key, value in overlay.items():
            if isinstance(value, dict):
                result[key] = merged(result.get(key, {}), value)
            else:
                result[key] = value
    return result


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


def resolved(case, case_schema):
    """The case with all defaults, reduced to the sections that its scene reads."""
    found = problems(case, case_schema)
    if found:
        raise ValueError("a case of the study does not follow the case schema:\n  " + "\n  ".join(found))
    full = with_defaults(case, case_schema)
    if "epsilon" in case.get("geometry", {}):
        full["geometry"].pop("row_shift_um", None)
    return {"scene": full["scene"]} | {name: full[name] for name in SECTIONS[full["scene"]]}


def run_id(case, solver_model):
    """Identity of a run: the first 12 hexadecimal digits of the hash of its resolved case."""
    text = json.dumps({"case": case, "solver_model": solver_model}, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def _streamlines(tier):
    part = tier["streamlines"]
    for name, variant in part["variants"].items():
        for shift in variant.get("row_shifts_um", part["row_shifts_um"]):
            shifted = {"scene": "streamlines", "geometry": {"row_shift_um": shift}}
            labels = {"variant": name, "row_shift_um": shift}
            yield "streamlines", labels, merged(part["case"], variant["case"], shifted)


def _stokes(tier):
    part = tier["stokes"]
    for shift, force in product(part["row_shifts_um"], part["force_densities"]):
        point = {"geometry": {"row_shift_um": shift}, "fluid": {"force_density": force}}
        labels = {"row_shift_um": shift, "force_density": force}
        yield "stokes", labels, merged(part["case"], point, {"scene": "streamlines"})


def _stretching(tier):
    for name, part in tier["stretching"].items():
        for denominator in part["skalak_denominators"]:
            point = {"scene": "stretching", "cell": {"skalak_denominator": denominator}}
            yield "stretching", {"series": name}, merged(part["case"], point)


def _passages(tier):
    for name, part in tier["passages"].items():
        for shift, capillary in product(part["row_shifts_um"], part["capillary_numbers"]):
            point = {"geometry": {"row_shift_um": shift}, "cell": {"capillary_number": capillary}}
            yield "passages", {"sweep": name}, merged(part["case"], point, {"scene": "passage"})


def make_plan(study, tier_name, case_schema):
    """The plan of a tier: its settings and the list of its runs (id, group, labels, resolved case)."""
    if tier_name not in study["tiers"]:
        raise ValueError(f"there is no tier '{tier_name}'; the tiers are {', '.join(sorted(study['tiers']))}")
    tier = study["tiers"][tier_name]
    runs = []
    for points in (_streamlines, _stokes, _stretching, _passages):
        for group, labels, case in points(tier):
            full = resolved(case, case_schema)
            runs.append(
                {"id": run_id(full, study["solver_model"]), "group": group, "labels": labels, "case": full}
            )
    return {
        "tier": tier_name,
        "note": tier["note"],
        "refinement": tier["streamlines"]["refinement"],
        "figures": tier["figures"],
        "runs": runs,
    }


def load_plan(study_path, tier_name):
    """The plan of a tier straight from the study's file."""
    study = validated(study_path, "study")
    return make_plan(study, tier_name, read_json(SCHEMAS / "case.schema.json"))


def ids(plan, *groups):
    """Identities of the runs of the given groups, each once, in the order of the plan."""
    return list(dict.fromkeys(run["id"] for run in plan["runs"] if run["group"] in groups))
