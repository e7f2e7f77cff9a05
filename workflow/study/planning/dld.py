"""Questions to the solver, `dld resolve`: what cases resolve to, what is wrong with them, what they take."""

import functools
import json
import os
import subprocess
import tempfile
from pathlib import Path

from study.planning import meshes

#: The solver that is asked while the plan is made.
DLD = Path(os.environ.get("DLD", Path(__file__).resolve().parents[3] / "build/dld"))


def answers(cases, dld):
    """The solver's answers to a list of cases; a RuntimeError if it has none."""
    with tempfile.TemporaryDirectory() as folder:
        asked, answered = Path(folder) / "cases.json", Path(folder) / "answers.json"
        asked.write_text(json.dumps([meshes.anywhere(case) for case in cases]), encoding="utf-8")
        done = subprocess.run(
            [Path(dld).absolute(), "resolve", asked, answered], capture_output=True, text=True, check=False
        )
        if done.returncode not in (0, 2) or not answered.exists():
            raise RuntimeError(f"{dld} resolve: exit {done.returncode}: {done.stderr.strip()}")
        return json.loads(answered.read_text(encoding="utf-8"))


def words(problem):
    """One of the problems of an answer in words."""
    value = f" = {problem['value']}" if problem["value"] else ""
    text = f"{problem['pointer'] or '/'}{value}: allowed is {problem['allowed']}"
    return text + (f"; {problem['advice']}" if problem["advice"] else "")


def in_capillary_number(case):
    """A case with the capillary number that its section `operating` means in the place of the section.

    The solver computes it, since a mean speed or a flow rate needs the resistance of the device. A ValueError
    lists what is wrong, or says that there is no solver yet.
    """
    number = _capillary_number(json.dumps(case, sort_keys=True))
    rest = {name: value for name, value in case.items() if name != "operating"}
    return rest | {"cell": rest.get("cell", {}) | {"capillary_number": number}}


@functools.cache
def _capillary_number(text):
    if not DLD.exists():
        raise ValueError(
            "/operating: conditions in SI units need the solver while the plan is made; build it first: "
            "cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build --target dld"
        )
    (answer,) = answers([json.loads(text)], DLD)
    if answer["problems"]:
        raise ValueError("; ".join(map(words, answer["problems"])))
    return answer["case"]["cell"]["capillary_number"]
