"""Writes the plan of a tier: all its solver runs with their identities and resolved cases, and its
brackets.
"""

import json
from pathlib import Path

from study.arguments import required_arguments
from study.plan import load_plan

arguments = required_arguments(__doc__, "study", "tier", "output")


def lines(name, value):
    """One entry of the plan; lists and dictionaries have one element a line, so that plans compare well."""
    if isinstance(value, list):
        inner = ",\n".join(json.dumps(item) for item in value)
        return f"{json.dumps(name)}: [\n{inner}\n]"
    if isinstance(value, dict):
        inner = ",\n".join(f"{json.dumps(key)}: {json.dumps(item)}" for key, item in value.items())
        return f"{json.dumps(name)}: {{\n{inner}\n}}"
    return f"{json.dumps(name)}: {json.dumps(value)}"


plan = load_plan(arguments.study, arguments.tier)
text = "{\n" + ",\n".join(lines(name, value) for name, value in plan.items()) + "\n}\n"
Path(arguments.output).write_text(text, encoding="utf-8")
