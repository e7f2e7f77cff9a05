"""The JSON documents of the pipeline: read, and held against their schema."""

import json
from pathlib import Path

from study.planning.validation import listing, load_json, pointer, unprintable, violations

SCHEMAS = Path(__file__).resolve().parents[2] / "schemas"


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
