"""Prints the names of the case schema as a dictionary of libFuzzer: dictionary.py SCHEMA"""

import json
import sys
from pathlib import Path


def words(part):
    """Names of parameters and of their choices."""
    for name, inner in part.get("properties", {}).items():
        yield name
        yield from words(inner)
    yield from (choice for choice in part.get("enum", []) if isinstance(choice, str))


schema = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
for word in sorted(set(words(schema))):
    print(f'"\\"{word}\\""')
for number in ("1e999", "-0.0", "1e-300", "9007199254740993", "null", "true", "[]", "{}", "\\\\u0000"):
    print(f'"{number}"')
