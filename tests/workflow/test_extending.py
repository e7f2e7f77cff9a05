"""docs/extending.md: each addition is made in a copy of the repository from the snippets of that page, and
files and lines are counted."""

import difflib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import test_cells
from study.planning.documents import validated
from study.planning.plan import load_plan

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/extending.md").read_text(encoding="utf-8")
BUILD = ROOT / "build"
DLD = BUILD / "dld"
needs_build = pytest.mark.skipif(
    not ((BUILD / "build.ninja").exists() and DLD.exists() and shutil.which("ninja")),
    reason="the solver is not built with Ninja",
)
#: Results that a figure can be drawn from; the others are left out of the copy.
RESULTS = "results/triangle/"


def snippets(section):
    """(kind, file, anchor, text) of every snippet of a section that says where it belongs."""
    (part,) = re.findall(rf"^## {section}\n(.*?)(?=^## |\Z)", PAGE, flags=re.MULTILINE | re.DOTALL)
    found = re.findall(
        r"^```\w+ (new|lines) (\S+)(?: after ([^\n]*))?\n(.*?)^```$", part, flags=re.MULTILINE | re.DOTALL
    )
    assert found, section
    return found


def add(tree, section):
    """Makes the additions of a section in a tree, as a reader would."""
    for kind, name, anchor, text in snippets(section):
        path = tree / name
        if kind == "new":
            assert not path.exists(), name
            path.write_text(text, encoding="utf-8")
            continue
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
        place = len(lines)
        if anchor:
            (place,) = (n + 1 for n, line in enumerate(lines) if line.strip() == anchor)
        else:
            text = f"\n\n{text}"
        path.write_text("".join([*lines[:place], text, *lines[place:]]), encoding="utf-8")


def copied_files():
    """Files of the repository that a copy needs."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False)
    if listed.returncode:
        pytest.skip("not a repository of git")
    names = [name for name in listed.stdout.decode().split("\0") if name and (ROOT / name).is_file()]
    return [name for name in names if not name.startswith("results/") or name.startswith(RESULTS)]


def text_of(path):
    return path.read_text(encoding="utf-8", errors="replace").splitlines()


def counted(tree, before):
    """(new files, {changed file: (lines added, lines removed)}) of a tree against its files before."""
    new, changed = [], {}
    for path in sorted(path for path in tree.rglob("*") if path.is_file()):
        name = str(path.relative_to(tree))
        if name not in before:
            new.append(name)
        elif before[name] != (lines := text_of(path)):
            marks = [line[0] for line in difflib.ndiff(before[name], lines)]
            changed[name] = (marks.count("+"), marks.count("-"))
    return new, changed


@pytest.fixture
def tree(tmp_path):
    """A copy of the repository."""
    place = tmp_path / "tree"
    for name in copied_files():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, place / name)
    return place


@pytest.fixture
def extended(tree):
    """Makes the additions of a section in the copy; what they cost in files and lines."""

    def make(*sections):
        before = {str(path.relative_to(tree)): text_of(path) for path in tree.rglob("*") if path.is_file()}
        for section in sections:
            add(tree, section)
        return counted(tree, before)

    return make


def snakemake(tree, *words):
    """What a call of Snakemake in a tree says; it has to succeed."""
    command = [sys.executable, "-m", "snakemake", "--nolock", "--cores", "1", *words]
    environment = os.environ | {"PYTHONPATH": str(tree / "workflow")}
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def jobs_in(told):
    """{rule: number of jobs} of a dry run."""
    return {name: int(count) for name, count in re.findall(r"^(\w+) +(\d+)$", told, flags=re.MULTILINE)}


def new_plan(tree):
    return load_plan(tree / "params/studies/elliptic-posts.json", "full")


def test_a_study_is_one_file(tree, extended):
    assert extended("A study") == (["params/studies/elliptic-posts.json"], {})
    plan = new_plan(tree)
    jobs = jobs_in(snakemake(tree, "--dry-run", "--config", "study=elliptic-posts"))
    assert jobs["solve"] == len({run["id"] for run in plan["runs"]}) == 4 + 8
    wanted = ("study_page", "figure_devices", "figure_study_separation", "figure_study_phase_space")
    assert [jobs[name] for name in wanted] == [1] * len(wanted)
    assert "figure_window" not in jobs  # of two cells, and this study has one


def test_a_device_is_some_lines_of_a_study(tree, extended):
    extended("A study")
    before = len(new_plan(tree)["runs"])
    assert extended("A device") == ([], {"params/studies/elliptic-posts.json": (2, 0)})
    plan = new_plan(tree)
    assert plan["devices"]["diamond"]["geometry"]["pillar"]["sides"] == 4
    assert len(plan["runs"]) == before + 4
    jobs = jobs_in(snakemake(tree, "--dry-run", "--config", "study=elliptic-posts"))
    assert jobs["solve"] == before + 4


@pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")
def test_a_cell_is_one_file(tree, extended):
    assert extended("A cell") == (["params/cells/hardened.json"], {})
    file = tree / "params/cells/hardened.json"
    cell = validated(file, "cell") | {"file": file}
    for check in (
        test_cells.test_a_type_is_named_like_its_file,
        test_cells.test_every_value_has_a_source_and_every_source_a_value,
        test_cells.test_the_bending_ratio_is_that_of_the_moduli,
    ):
        check(cell)
    test_cells.test_the_solver_accepts_a_passage_of_the_type(cell, tree)
    extended("A study")
    path = tree / "params/studies/elliptic-posts.json"
    study = json.loads(path.read_text(encoding="utf-8"))
    study["cells"] = {"mine": {"type": "hardened"}}
    path.write_text(json.dumps(study), encoding="utf-8")
    jobs = jobs_in(snakemake(tree, "--dry-run", "--config", "study=elliptic-posts", f"dld={DLD}"))
    assert jobs["solve"] == 12  # the solver, shown all cases, refuses none
    plan = json.loads((tree / "results/elliptic-posts/plan.json").read_text(encoding="utf-8"))
    passages = [run for run in plan["runs"] if run["group"] == "passages"]
    assert {run["labels"]["cell"] for run in passages} == {"mine"}  # the column of the tables
    assert {run["case"]["cell"]["bending_ratio"] for run in passages} == {0.002481}
    assert plan["cells"]["mine"]["shear_modulus_uN_per_m"] == 53


def built_commands(target):
    """The commands that build a target of the repository's build, in order."""
    told = subprocess.run(
        ["ninja", "-C", BUILD, "-t", "commands", target], capture_output=True, text=True, check=True
    )
    return [line for line in told.stdout.splitlines() if not line.startswith("ninja:")]


def compiled(tree, sources):
    """Object files of sources of the copy, compiled as the repository's are."""
    (model,) = (line for line in built_commands("dld") if line.endswith(f"{ROOT}/solver/scene/registry.cpp"))
    objects, started = [], []
    for source in sources:
        target = tree / f"{Path(source).name}.o"  # the name that it has in the library
        words = [word.replace(f"{ROOT}/solver", f"{tree}/solver") for word in shlex.split(model)]
        words[-1] = str(tree / source)
        words[words.index("-o") + 1] = str(target)
        words = [f"{target}.d" if word.endswith(".o.d") else word for word in words]
        words = [str(target) if word == words[words.index("-MT") + 1] else word for word in words]
        started.append(subprocess.Popen(words, cwd=BUILD, stderr=subprocess.PIPE, text=True))
        objects.append(target)
    for process in started:
        _, errors = process.communicate()
        assert process.returncode == 0, errors
    return objects


def linked(tree, target, library):
    """A program of the repository's build, linked with another library."""
    link = built_commands(target)[-1]
    words = next(part for part in link.split(" && ") if " -o " in part)
    words = [str(library) if word == "libdld_core.a" else word for word in shlex.split(words)]
    program = tree / target
    words[words.index("-o") + 1] = str(program)
    subprocess.run(words, cwd=BUILD, check=True)
    return program


def told_by(program, *words):
    done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@needs_build
def test_a_pillar_shape_and_a_scene_are_one_file_and_two_lines_each(tree, extended):
    shape = ["solver/geometry/stadium.hpp"], {"solver/geometry/pillar.cpp": (2, 0)}
    scene = ["solver/scene/array.cpp"], {"solver/scene/registry.cpp": (2, 0)}
    assert extended("A pillar shape") == shape
    assert extended("A scene") == scene
    changed = ["solver/geometry/pillar.cpp", "solver/scene/array.cpp", "solver/scene/registry.cpp"]
    library = tree / "libdld_core.a"
    shutil.copy(BUILD / "libdld_core.a", library)
    subprocess.run(["ar", "r", library, *compiled(tree, changed)], check=True)
    dld = linked(tree, "dld", library)

    schema = json.loads(told_by(dld, "schema"))
    assert "array" in schema["properties"]["scene"]["enum"]
    shapes = schema["properties"]["geometry"]["properties"]["pillar"]["oneOf"]
    assert "stadium" in [one["properties"]["shape"]["const"] for one in shapes]
    case = tree / "case.json"
    pillar = {"shape": "stadium", "length_um": 20, "width_um": 12, "rotation_deg": 15}
    case.write_text(json.dumps({"scene": "array", "geometry": {"pillar": pillar}}), encoding="utf-8")
    checked = json.loads(told_by(dld, "check", "--json", case))
    assert checked["case"]["geometry"]["pillar"] == pillar
    told_by(dld, "run", case, tree / "run.h5")
    case.write_text(
        json.dumps({"scene": "array", "geometry": {"pillar": pillar | {"width_um": 30}}}), encoding="utf-8"
    )
    refused = subprocess.run([dld, "check", case], capture_output=True, text=True, check=False)
    assert refused.returncode == 2 and "less than the length" in refused.stderr
    if (BUILD / "unit_tests").exists():
        tests = linked(tree, "unit_tests", library)
        assert "[  PASSED  ]" in told_by(tests, "--gtest_filter=Shapes.*:Pillar.*:Device.*")


def test_a_figure_is_one_file_and_one_rule(tree, extended):
    extended("A study")
    new, changed = extended("A figure")
    assert new == ["workflow/scripts/drawing/fig_extent.py"]
    assert changed == {"workflow/rules/study_figures.smk": (16, 0)}
    drawn = "results/triangle/figures/fig_extent.png"
    allowed = told_by_python(tree, "workflow/scripts/planning/redraw_rules.py").split()
    call = ["--quiet", "all", "--config", "study=triangle", "--forceall", "--allowed-rules", *allowed, "--"]
    snakemake(tree, *call, drawn)  # as `bash workflow/reproduce redraw`, which needs an installation
    assert (tree / drawn).stat().st_size > 5000
    assert "figure_extent" in jobs_in(snakemake(tree, "--dry-run", "--config", "study=elliptic-posts"))
    page = tree / "results/triangle/README.md"
    where = {"plan": page.with_name("plan.json"), "tables": page.with_name("tables"), "output": page}
    words = [f"--{name}={value}" for name, value in (where | {"name": "triangle"}).items()]
    told_by_python(tree, "workflow/scripts/analysis/study_page.py", *words)
    assert "![The lateral extent of the cells" in page.read_text(encoding="utf-8")


def told_by_python(tree, *words):
    environment = os.environ | {"PYTHONPATH": str(tree / "workflow")}
    done = subprocess.run(
        [sys.executable, *words], cwd=tree, env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout
