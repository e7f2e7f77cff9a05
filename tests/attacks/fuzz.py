"""Structure-aware fuzzing: random cases that look right, made from the case schema, through `dld check` and,
as far as it accepts them, through runs of a few steps. No crash, no hang, no "converged" from nonsense.

    python tests/attacks/fuzz.py --seconds 120 --seed 1 --solver build/debug/dld

A case that fails is printed, so that it can become a row of rows/*.json.
"""

import argparse
import json
import random
import sys
import time
from pathlib import Path

from attack import ROOT, put_over, read, tried
from mutations import at, ends, leaves

#: Bounds that keep a run short; the rest of a case is drawn.
SHORT = {
    "fluid": {"lattice_spacing_um": 0.8},
    "stop": {"max_steps": 60, "max_rows": 1},
    "shear": {"box_um": 20, "duration": 0.01},
    "cell": {"mesh_frequency": 4},
    "output": {"snapshots_per_row": 1, "trajectory_samples_per_row": 10},
}
SCENES = ("streamlines", "passage", "stretching", "channel", "shear")
LABELS = {  # what a run of so few steps may be called
    "stretching": ["converged", "diverged", "undecided"],
    "shear": ["diverged", "undecided"],
}


def number(part, chance):
    """A number near the default, on a nice step, at an end, or anywhere between."""
    low = part.get("minimum", part.get("exclusiveMinimum", -1e3))
    high = part.get("maximum", 1e3)
    near = part.get("default", 1.0)
    drawn = chance.choice(
        [
            near,
            near * chance.uniform(0.5, 2),
            round(near * chance.uniform(0.2, 3), 1),
            near * 10 ** chance.uniform(-6, 6),
            chance.uniform(low, high),
            *ends(part),
        ]
    )
    drawn = min(max(drawn, low), high)
    return round(drawn) if part["type"] == "integer" else drawn


def value(part, chance):
    """An allowed value of a parameter."""
    if "enum" in part:
        return chance.choice(part["enum"])
    if part["type"] == "boolean":
        return chance.random() < 0.5
    if part["type"] == "array":
        return [number(part["items"], chance) for _ in range(chance.randint(1, 3))]
    if part["type"] == "string":
        return chance.choice(["", "a", "é"])
    return number(part, chance)


def drawn_case(schema, chance):
    """A case of one scene with a few parameters drawn at random."""
    scene = chance.choice(SCENES)
    case = put_over({"scene": scene}, SHORT)
    every = [(pointer, part) for pointer, part in leaves(schema) if pointer[0] not in ("scene", "stop")]
    for pointer, part in chance.sample(every, chance.randint(1, 6)):
        case = put_over(case, at(pointer, value(part, chance)))
    return case


def fuzzed(schema, chance, solver):
    """Faults of one random case, checked and run: (case, faults)."""
    case = drawn_case(schema, chance)
    row = {"text": json.dumps(case), "words": ["check", "CASE"], "exit": [0, 2], "seconds": 60}
    faults = tried(row, solver, {}).faults
    if faults or case["fluid"]["lattice_spacing_um"] < 0.4 or case["cell"]["mesh_frequency"] > 12:
        return case, faults
    run = row | {
        "words": ["run", "CASE", "out.h5", "--summary", "summary.json", *chance.choice([[], ["--force"]])],
        "exit": [0, 2, 3],
        "seconds": 300,
        "labels": LABELS.get(case["scene"], ["diverged", "undecided", "converged", "displaced", "zigzag"]),
    }
    return case, tried(run, solver, {}).faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solver", default=str(ROOT / "build/dld"))
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    schema = read(ROOT / "workflow/schemas/case.schema.json")
    solver, chance = str(Path(arguments.solver).resolve()), random.Random(arguments.seed)
    tries, failed, started = 0, 0, time.monotonic()
    while time.monotonic() - started < arguments.seconds:
        case, faults = fuzzed(schema, chance, solver)
        tries += 1
        if faults:
            failed += 1
            print(f"FAILED {'; '.join(faults)}: {json.dumps(case)}", flush=True)
    print(f"{tries - failed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
