"""The tiers of a study as its file has them, each in full."""

from study.planning.documents import SCHEMAS, read_json
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
    violations,
    written_at,
)

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


def _without_nulls(overlay):
    return {
        key: _without_nulls(value) if isinstance(value, dict) else value
        for key, value in overlay.items()
        if value is not None
    }


def expanded(tiers, name):
    """A tier with what it does not say itself taken from the tier that it `extends`, and without what it
    gives as null."""
    *own, first = chain(tiers, name)
    full = tiers[first]
    for part in reversed(own):
        full = _taken_away(full, tiers[part], ["tiers", part])
        full = merged(full, _without_nulls(tiers[part]))
    return {key: value for key, value in full.items() if key != "extends"}


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
