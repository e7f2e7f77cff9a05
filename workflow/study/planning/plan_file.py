"""The plan of a tier once it is made: its file, and what is asked of it."""

import json
from pathlib import Path


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


def study_brackets(plan):
    """The brackets of the study by name; those of the target `uncertainty` are not among them."""
    return {name: found for name, found in plan["brackets"].items() if found["kind"] != "uncertainty"}
