"""Rows made from the case schema: every parameter with wrong types, with numbers outside what is allowed, and
with the least and the greatest allowed ones."""

#: Values of a wrong type, by the type of the parameter.
WRONG = {
    "number": ["1", None, True, [], {}, [1.0], "NaN"],
    "integer": ["1", None, False, [], {}, 1.5, "1e3"],
    "string": [1, None, True, [], {}, "", "no such name", "standard\u0000", "<script>"],
    "boolean": [0, 1, None, "true", [], {}],
    "array": [None, True, "1", {}, [], ["1"], [None], [[1]], [-1], [1e300]],
}
#: Numbers that no physical parameter has.
ABSURD = [1e300, -1e300, -1e-300, 9007199254740993, -1]


def leaves(schema, pointer=()):
    """(pointer, declaration) of every parameter."""
    for name, part in schema.get("properties", {}).items():
        if "properties" in part:
            yield from leaves(part, (*pointer, name))
        elif "type" in part:
            yield (*pointer, name), part


def at(pointer, value):
    """A case with one value at a pointer."""
    for name in reversed(pointer):
        value = {name: value}
    return value


def ends(part):
    """The least and the greatest number that are allowed, as far as there are such."""
    found = [part[key] for key in ("minimum", "maximum") if key in part]
    if "exclusiveMinimum" in part:
        found.append(part["exclusiveMinimum"] + (1 if part["type"] == "integer" else 1e-9))
    return found


def outside(part):
    """Absurd numbers that are not allowed, and the nearest beyond each end."""
    low = part.get("minimum", part.get("exclusiveMinimum", float("-inf")))
    high = part.get("maximum", float("inf"))
    found = [value for value in ABSURD if not low <= value <= high]
    step = 1 if part["type"] == "integer" else 1e-6 * max(1.0, abs(low))
    found += [value for value in (low - step, high * 1.01 + step) if abs(value) != float("inf")]
    return found + ([part["exclusiveMinimum"]] if "exclusiveMinimum" in part else [])


def row(pointer, value, kind, **expected):
    """The row of one value at one pointer."""
    place = "/" + "/".join(pointer)
    return {
        "what": f"{place} = {value!r} ({kind})",
        "group": "made from the schema",
        "kind": kind,
        "on": "bare",
        "case": at(pointer, value),
        "words": ["check", "CASE"],
        **expected,
    }


def mutated_rows(schema):
    """All rows that the schema gives."""
    rows = []
    for pointer, part in leaves(schema):
        place = "/" + "/".join(pointer)
        free = part["type"] == "string" and "enum" not in part  # any text may stand there
        wrong = [v for v in WRONG[part["type"]] if not (free and isinstance(v, str))]
        rows += [row(pointer, v, "a wrong type", exit=2, says=[place]) for v in wrong]
        if part["type"] in ("number", "integer"):
            values = dict.fromkeys(outside(part))
            rows += [
                row(pointer, v, "a number outside what is allowed", exit=2, says=[place]) for v in values
            ]
            values = dict.fromkeys(ends(part))
            rows += [row(pointer, v, "the least and the greatest allowed", exit=[0, 2]) for v in values]
    return rows
