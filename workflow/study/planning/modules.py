"""Which modules of this package a program uses, so that its rule depends on them and on no others."""

import ast
from functools import cache
from pathlib import Path

HERE = Path("workflow")


def _imported(path):
    """Names of the modules of this package that a file imports itself, with dots."""
    for node in ast.walk(ast.parse(Path(path).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "study":
            yield node.module
            yield from (f"{node.module}.{name.name}" for name in node.names)


@cache
def modules_of(program):
    """Files of the modules that a program imports, directly or not, sorted."""
    found, waiting = set(), [program]
    while waiting:
        for name in _imported(waiting.pop()):
            path = str(HERE / Path(*name.split(".")).with_suffix(".py"))
            if path not in found and Path(path).is_file():
                found.add(path)
                waiting.append(path)
    return sorted(found)
