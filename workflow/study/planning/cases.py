"""A case in full, and the name of its run.

Defaults come from the case schema that the solver prints (`dld schema`), not from a copy. A run's identity is
a hash of its resolved parameters, so two sweeps that ask for the same point share it.
"""

import hashlib
import json

from study.planning import meshes
from study.planning.dld import in_capillary_number
from study.planning.documents import problems
from study.planning.points import merged

#: (section, key, keys whose place it takes): two ways of saying the same, of which a case has one.
ALTERNATIVES = [
    ("geometry", "epsilon", ["row_shift_um"]),
    ("geometry", "pillar", ["pillar_shape", "pillar_radius_um"]),
]


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


def fingerprint(value):
    """The first 12 hexadecimal digits of the hash of a JSON value."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def run_id(case, solver_model):
    """Identity of a run: the hash of its resolved case."""
    return fingerprint({"case": meshes.identified(case), "solver_model": solver_model})


def radius_um(part, case_schema):
    """Radius r of a cell, um, from its part of a case; None where the solver takes it from a mesh."""
    cell = with_defaults(part["cell"], case_schema["properties"]["cell"])
    _size_by_shape(part["cell"], cell)
    return meshes.radius_um(cell)
