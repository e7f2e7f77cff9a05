"""The arrows of CONTRIBUTING.md: what includes and imports what, one way, without circles."""

import ast
import re
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOLVER, WORKFLOW = ROOT / "solver", ROOT / "workflow"
PRINT = "paper"  # the folder that knows what the paper prints


def arrows(text):
    """{folder: folders that it uses} from the tables of the section Arrows."""
    section = re.search(r"^## Arrows$(.*?)^## ", text, flags=re.DOTALL | re.MULTILINE)[1]
    rows = re.findall(r"^\| (`.*`) \| (.*) \|$", section, flags=re.MULTILINE)
    named = ((folder, used) for folders, used in rows for folder in re.findall(r"`([^`]+)`", folders))
    return {folder: set() if used == "nothing" else set(used.split(", ")) for folder, used in named}


def includes(path):
    """Files of solver/ that a source or header of it includes, relative to solver/."""
    return re.findall(r'^\s*#include "([^"]+)"', path.read_text(encoding="utf-8"), flags=re.MULTILINE)


def imports(path):
    """All names that a program or module imports, with dots, wherever it does so."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            module = "." * node.level + (node.module or "")
            yield module
            yield from (f"{module}.{name.name}" for name in node.names)


def parts_of_study(path):
    """Folders of study/ that a program or module imports from."""
    names = (name.split(".") for name in imports(path))
    return {name[1] for name in names if name[0] == "study" and len(name) > 1}


def programs():
    return sorted((WORKFLOW / "scripts").rglob("*.py"))


def used_folders():
    """{folder of the table: {folder that it uses: one of its files that does so}} of the code as it is."""
    found = {}
    for path in sorted([*SOLVER.rglob("*.cpp"), *SOLVER.rglob("*.hpp")]):
        folder = path.relative_to(SOLVER).parts[0]
        uses = found.setdefault(f"solver/{folder}", {})
        uses |= {name.split("/")[0]: path for name in includes(path) if name.split("/")[0] != folder}
    modules = [path for path in sorted((WORKFLOW / "study").rglob("*.py")) if path.parent.name != "study"]
    for path in [*modules, *programs()]:
        kind, folder = path.relative_to(WORKFLOW).parts[:2]
        own = {folder} if kind == "study" else set()
        uses = found.setdefault(f"{kind}/{folder}", {})
        uses |= dict.fromkeys(parts_of_study(path) - own, path)
    return found


ALLOWED, USED = arrows((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")), used_folders()


def prints_allowed(path):
    """Whether a program outside scripts/paper is started by the rules of the paper alone."""
    rules = [*(WORKFLOW / "rules").rglob("*.smk"), ROOT / "Snakefile"]
    starters = [rule for rule in rules if path.name in rule.read_text(encoding="utf-8")]
    return bool(starters) and all(rule.parent.name == PRINT for rule in starters)


def test_the_table_has_every_folder_and_no_other():
    assert set(ALLOWED) == set(USED)


@pytest.mark.parametrize("folder", sorted(USED))
def test_a_folder_uses_what_the_table_says(folder):
    found = dict(USED[folder])
    if folder.startswith("scripts/") and folder != f"scripts/{PRINT}":
        found.pop(PRINT, None)  # judged by the rules that start them, below
    extra = {name: str(path.relative_to(ROOT)) for name, path in found.items() if name not in ALLOWED[folder]}
    assert not extra, f"{folder} must not use these, and does so in"
    assert set(found) == ALLOWED[folder], (
        f"nothing in {folder} uses them any more: take them out of the table"
    )


def test_the_print_is_known_to_the_rules_of_the_paper_alone():
    for path in programs():
        if path.parent.name != PRINT and PRINT in parts_of_study(path):
            assert prints_allowed(path), f"{path.name} imports study.{PRINT}, and other rules start it"
    for rule in (WORKFLOW / "rules").glob("*.smk"):
        text = rule.read_text(encoding="utf-8")
        assert f"study.{PRINT}" not in text and f"/{PRINT}/" not in text, rule.name
    assert f"study.{PRINT}" not in (ROOT / "Snakefile").read_text(encoding="utf-8")


def test_no_program_imports_another():
    names = {path.stem for path in programs()} | {"scripts"}
    for path in programs():
        assert not names & {part for name in imports(path) for part in name.split(".")[:1]}, path.name


def circle(graph):
    """The names of a circle of {name: names that it uses}; empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def test_no_header_includes_itself():
    headers = {str(path.relative_to(SOLVER)): includes(path) for path in SOLVER.rglob("*.hpp")}
    assert not {name for used in headers.values() for name in used} - set(headers)
    assert circle(headers) == []


def test_no_module_imports_itself():
    files = {
        ".".join(path.relative_to(WORKFLOW).with_suffix("").parts): path
        for path in (WORKFLOW / "study").rglob("*.py")
    }
    graph = {name: {used for used in imports(path) if used in files} for name, path in files.items()}
    assert circle(graph) == []


def test_a_reversed_arrow_and_a_circle_are_found():
    text = "## Arrows\n\n| `a`, `b/c` | d, e |\n| `d` | nothing |\n\n## Next\n"
    assert arrows(text) == {"a": {"d", "e"}, "b/c": {"d", "e"}, "d": set()}
    assert circle({"a": ["b"], "b": ["c"], "c": []}) == []
    assert set(circle({"a": ["b"], "b": ["c"], "c": ["a"]})) == {"a", "b", "c"}
