"""What is wrong with the files of the study, all of it at once: place, value, what is allowed, what to
change."""

import difflib
import json
from pathlib import Path

from jsonschema import Draft202012Validator


def load_json(path):
    """The document of a JSON file; a ValueError that names the file and the place of bad syntax, or a key
    that is given twice, of which JSON would silently keep the last, or a NaN, which no number here may be."""

    def once(pairs):
        keys = [key for key, _ in pairs]
        twice = sorted({key for key in keys if keys.count(key) > 1})
        if twice:
            raise ValueError(f"{path}: {', '.join(map(repr, twice))} given twice in one object; keep one")
        return dict(pairs)

    def no_number(name):
        raise ValueError(f"{path}: {name} is no number of JSON; give a finite one")

    text = Path(path).read_text(encoding="utf-8")
    try:
        return json.loads(text, object_pairs_hook=once, parse_constant=no_number)
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise ValueError(f"{path}, {place}: {error.msg}") from None


def hint(name, known):
    """What to write instead of an unknown name: the nearest known one, or all of them."""
    near = difflib.get_close_matches(str(name), list(map(str, known)), 1)
    return f"did you mean '{near[0]}'?" if near else f"allowed are {', '.join(sorted(map(str, known)))}"


def unprintable(document, path=()):
    """(path, text) of every name and text with a control character, which a terminal or a page would obey."""
    if isinstance(document, dict):
        for key, value in document.items():
            yield from unprintable(key, [*path, key.encode("unicode_escape").decode()])
            yield from unprintable(value, [*path, key])
    elif isinstance(document, list):
        for number, value in enumerate(document):
            yield from unprintable(value, [*path, number])
    elif isinstance(document, str) and any(ord(letter) < 32 or ord(letter) == 127 for letter in document):
        yield path, f"{document!r}: control characters are not allowed; leave them out"


def pointer(path):
    """The JSON pointer of a place."""
    return "/" + "/".join(map(str, path))


def violations(document, schema):
    """(path, text) of all violations of a schema; unknown names with the nearest known one."""
    for error in sorted(
        Draft202012Validator(schema).iter_errors(document), key=lambda e: list(map(str, e.path))
    ):
        path = list(error.path)
        if error.validator == "additionalProperties" and "properties" in error.schema:
            known = error.schema["properties"]
            for name in sorted(set(error.instance) - set(known)):
                yield [*path, name], f"unknown name; {hint(name, known)}"
        elif error.validator == "enum":
            yield path, f"{error.message}; {hint(error.instance, error.validator_value)}"
        else:
            yield path, error.message


def misshapen(study):
    """(path, text) of what keeps the tiers from being laid over one another: what is no object, or extends no
    name."""
    if not isinstance(study, dict):
        yield [], "an object is needed"
    elif not isinstance(study.get("tiers"), dict):
        yield ["tiers"], "an object is needed, a tier for each name"
    else:
        for name, tier in study["tiers"].items():
            if not isinstance(tier, dict):
                yield ["tiers", name], "an object is needed"
            elif not isinstance(tier.get("extends", ""), str):
                yield ["tiers", name, "extends"], "the name of a tier is needed"


def chain(tiers, name):
    """Names of a tier and of those that it extends, nearest first; a ValueError where they go in a circle or
    there is none of that name."""
    names = [name]
    while (base := tiers[names[-1]].get("extends")) is not None:
        if base not in tiers:
            raise ValueError(f"/tiers/{names[-1]}/extends: there is no tier '{base}'; {hint(base, tiers)}")
        if base in names:
            raise ValueError(f"/tiers/{names[-1]}/extends: '{base}' extends this tier, directly or not")
        names.append(base)
    return names


def written_at(tiers, path):
    """The place in the file of a place in a tier in full: that of the nearest tier that has most of it."""

    def depth(name):
        value, steps = tiers[name], 0
        for key in path[2:]:
            try:
                value = value[key]
            except (KeyError, IndexError, TypeError):
                break
            steps += 1
        return steps

    if len(path) < 2 or path[0] != "tiers":
        return path
    return ["tiers", max(chain(tiers, path[1]), key=depth), *path[2:]]


def _listed(path, names, known):
    """(path, name, known names) of every name in a list."""
    for number, name in enumerate(names):
        yield [*path, number], name, known


def _names_of_flow(tier):
    flow = tier["streamlines"]
    yield from _listed(["streamlines", "devices"], flow.get("devices", []), tier["devices"])
    for key, names in flow["refinement"].items():
        yield from _listed(["streamlines", "refinement", key], names, flow["variants"])


def _names_of_places(tier):
    """Names of devices and cells in sweeps and series."""
    entries = [(["passages", name], entry) for name, entry in tier.get("passages", {}).items()]
    entries += _series(tier)
    entries += [
        (["boundary", "mirror", name], entry)
        for name, entry in tier.get("boundary", {}).get("mirror", {}).items()
    ]
    entries += [(["stretching", name], entry) for name, entry in tier.get("stretching", {}).items()]
    entries += [(["sensitivity"], tier["sensitivity"])] if "sensitivity" in tier else []
    for path, entry in entries:
        for key, known in (("device", "devices"), ("cell", "cells")):
            if key in entry:
                yield [*path, key], entry[key], tier[known]


def _names_of_accuracy(tier):
    yield from _listed(["accuracy", "class_sweeps"], tier["accuracy"]["class_sweeps"], tier["passages"])
    for study, part in tier["accuracy"]["studies"].items():
        for method, entry in part["methods"].items():
            place = ["accuracy", "studies", study, "methods", method]
            yield from _listed([*place, "ladder"], entry.get("ladder", []), part.get("ladder", {}))
            if "reference" in entry:
                yield [*place, "reference"], entry["reference"], part["references"]
            if "extends" in entry:
                yield [*place, "extends"], entry["extends"], part["methods"]
        for reference, entry in part["references"].items():
            place = ["accuracy", "studies", study, "references", reference, "methods"]
            yield from _listed(place, entry["methods"], part["methods"])


def _names_of_stability(tier):
    maps = tier["stability"]["maps"]
    for name, plane in maps.items():
        if "extends" in plane:
            yield ["stability", "maps", name, "extends"], plane["extends"], maps


def _names_of_uncertainty(tier):
    known = [*tier["boundary"]["series"], *tier["uncertainty"]["series"]]
    for number, row in enumerate(tier["uncertainty"]["rows"]):
        for side in ("series", "reference"):
            yield ["uncertainty", "rows", number, side], row[side], known


def _names_of_sensitivity(tier):
    choices, asked = tier["sensitivity"]["choices"], tier["sensitivity"]["boundary"]
    series = tier["boundary"]["series"]
    brackets = [*series] + [
        f"sensitivity/{choice}/{value}" for choice in asked["choices"] for value in choices.get(choice, ())
    ]
    yield from _listed(["sensitivity", "boundary", "choices"], asked["choices"], choices)
    if asked["choices"]:
        yield ["sensitivity", "boundary", "reference"], asked["reference"], series
    for choice, values in choices.items():
        for value, entry in values.items():
            if "series" in entry:
                yield ["sensitivity", "choices", choice, value, "series"], entry["series"], brackets


def _names_of_figures(tier):
    figures, variants, sweeps = tier["figures"], tier["streamlines"]["variants"], tier["passages"]
    limits = [*variants, *tier["streamlines"]["refinement"]]
    yield from _listed(["figures", "law_variants"], figures["law_variants"], limits)
    for path, known in (
        (["streamline_variant"], variants),
        (["trajectory_sweep"], sweeps),
        (["deformed_cell", "sweep"], sweeps),
        (["gap_cells", "sweep"], sweeps),
        (["gap_cells", "flow_variant"], variants),
        (["array", "sweep"], sweeps),
        (["array", "variant"], variants),
    ):
        name = figures
        for key in path:
            name = name[key]
        yield ["figures", *path], name, known


#: (section, names in it that refer to something else in the tier).
NAMES = [
    ("streamlines", _names_of_flow),
    ("accuracy", _names_of_accuracy),
    ("stability", _names_of_stability),
    ("uncertainty", _names_of_uncertainty),
    ("sensitivity", _names_of_sensitivity),
    ("figures", _names_of_figures),
]
#: (section, sections without which it says nothing).
NEEDS = [
    ("uncertainty", ["boundary"]),
    ("sensitivity", ["boundary"]),
    ("accuracy", ["passages"]),
    ("figures", ["streamlines", "passages"]),
]


def _series(tier):
    """(path, entry) of every series of brackets of the critical capillary number."""
    for part in ("boundary", "uncertainty"):
        for series, entry in tier.get(part, {}).get("series", {}).items():
            yield [part, "series", series], entry


def _ranges(tier):
    """(path, [low, high]) of every range of a tier."""
    for place, entry in _series(tier):
        yield [*place, "ca_range"], entry["ca_range"]
        for shift, ends in entry.get("ca_ranges", {}).items():
            yield [*place, "ca_ranges", shift], ends
    for series, entry in tier.get("boundary", {}).get("mirror", {}).items():
        yield ["boundary", "mirror", series, "row_shift_range_um"], entry["row_shift_range_um"]
    if "sensitivity" in tier:
        yield ["sensitivity", "boundary", "ca_range"], tier["sensitivity"]["boundary"]["ca_range"]


def _circles(tier):
    """(path, text) of methods that extend one another in a circle."""
    for study, part in tier.get("accuracy", {}).get("studies", {}).items():
        for method in part["methods"]:
            seen, base = [method], part["methods"][method].get("extends")
            while base in part["methods"] and base not in seen:
                seen.append(base)
                base = part["methods"][base].get("extends")
            if base == method:
                place = ["accuracy", "studies", study, "methods", method, "extends"]
                yield place, "the methods extend one another in a circle"


def inconsistencies(tier, devices, cells):
    """(path, text) of what a schema cannot see in a tier in full: sections and names without what they refer
    to, ranges that go backwards or of a row shift that the series does not have, methods that extend one
    another in a circle."""
    tier = tier | {"devices": devices, "cells": cells}
    lacking = [
        ([section], f"needs the section {other}; add it or leave {section} out")
        for section, others in NEEDS
        for other in others
        if section in tier and other not in tier
    ]
    yield from lacking
    if lacking:
        return
    named = [*_names_of_places(tier)] + [
        name for section, names in NAMES if section in tier for name in names(tier)
    ]
    for path, name, known in named:
        if name not in known:
            yield path, f"there is no '{name}'; {hint(name, known)}"
    for path, (low, high) in _ranges(tier):
        if not low < high:
            yield path, f"[{low:g}, {high:g}]: the smaller end comes first; turn it round"
    for path, entry in _series(tier):
        for shift in entry.get("ca_ranges", {}):
            if float(shift) not in entry["row_shifts_um"]:
                shifts = ", ".join(f"{one:g}" for one in entry["row_shifts_um"])
                place = [*path, "ca_ranges", shift]
                yield place, f"the series has no row shift {shift}; it has {shifts}"
    yield from _circles(tier)
    yield from _sweeps_in_si(tier)


#: Sections whose tables and figures are set against a print, and what a study without one has instead.
OF_A_PRINT = {
    "stokes": "streamlines",
    "uncertainty": "boundary, with `confirm`",
    "accuracy": "streamlines, with `refinement`",
    "stability": "the margins of `dld check`",
    "figures": "the figures that every study has",
}


def only_with_claims(tier):
    """(path, text) of the sections of a tier that only a study with claims has."""
    for section, instead in OF_A_PRINT.items():
        if section in tier:
            text = "its tables and figures are set against a print, which the key 'claims' of a study names"
            yield [section], f"{text}; leave it out or use {instead}"


def _sweeps_in_si(tier):
    """(path, text) of sweeps without one axis beside the row shift, and of those over the pressure of a cell
    whose stiffness nothing tells."""
    drives = ("capillary_numbers", "pressure_gradients_bar_per_m")
    for name, entry in tier.get("passages", {}).items():
        if sum(drive in entry for drive in drives) != 1:
            yield ["passages", name], f"exactly one of {' and '.join(drives)} is needed"
        cell = entry.get("cell", next(iter(tier["cells"])))
        told = tier["cells"].get(cell, {})
        if "pressure_gradients_bar_per_m" in entry and not {"shear_modulus_uN_per_m", "type"} & set(told):
            place = ["passages", name, "pressure_gradients_bar_per_m"]
            yield place, f"needs the stiffness of the cell; add /cells/{cell}/shear_modulus_uN_per_m"


def listing(path, found):
    """The text of an error: the file and every problem on a line of its own, each once."""
    return f"{path}:\n  " + "\n  ".join(dict.fromkeys(found))
