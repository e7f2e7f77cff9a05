"""Rules that tell the class of a trajectory before it is proven, and what each costs and gets wrong.

The class that a passage ended with, displaced or zigzag, is taken as true. It is the class on the lattice of
the passage; how far that is from the device's is the matter of the other studies.
"""

import numpy as np

from study.analysis.accuracy import ALL
from study.analysis.second_starts import grid_pairs
from study.planning.classes import DECIDED

KIND = "class, share of wrong ones"
LINES = (1, 2, 3, 4, 5, 6, 8, 10)


def any_zig(bumps):
    """Zigzag as soon as the cell fell back once."""
    return "displaced" if all(bumps) else "zigzag"


def last_line(bumps):
    """What the cell did at the last line is what it will go on doing."""
    return "displaced" if bumps[-1] else "zigzag"


RULES = {"any zig so far": any_zig, "what happened last": last_line}


def judged_rule(rule, passages, lines):
    """(share of wrong classes, work units) of a rule used after so many steps from line to line.

    `passages`: list of (class, bumps, share of the work done at each crossing, work units). A passage that
    ended before has its own class by then, at its whole cost.
    """
    wrong, work = 0, 0.0
    for label, bumps, shares, units in passages:
        if lines < len(bumps) - 1:
            wrong += rule(bumps[1 : lines + 1]) != label
            work += units * shares[lines]
        else:
            work += units
    return wrong / len(passages), work


def passages_of(table, crossings, sweeps, weight):
    """The decided passages of some sweeps, as `judged_rule` needs them. The first crossing proves nothing."""
    chosen = table[table.sweep.isin(sweeps) & table["class"].isin(DECIDED)].drop_duplicates("run")
    by_run = dict(tuple(crossings.drop_duplicates(["run", "row"]).groupby("run")))
    found = []
    for row in chosen.to_dict("records"):
        if row["run"] not in by_run:
            continue
        lines = by_run[row["run"]].sort_values("row")
        units = row["node_updates"] + weight * np.nan_to_num(row["membrane_updates"])
        shares = np.minimum(lines.step.to_numpy(float) / row["steps"], 1.0)
        found.append((row["class"], list(lines.bump == 1), shares, units))
    return found


def second_starts(table):
    """(share of classes that a start elsewhere changes, number of pairs) over the points that have both."""
    pairs = [pair for pair in grid_pairs(table) if pair[1] in DECIDED]
    different = sum(first != second for first, second in pairs)
    return (different / len(pairs) if pairs else None), len(pairs)


def row_of(method, setting, error, work, count):
    """Row of the cost table. Among `count` classes nothing below one wrong in `count` is told apart."""
    return {
        "study": "class",
        "method": method,
        "setting": setting,
        "error": error,
        "error_kind": KIND,
        "work_units": work,
        "status": "ok" if error is not None else "no reference",
        "point": ALL,
        "reference": "class that the passage ended with",
        "reference_uncertainty": 1.0 / count if count else None,
    }


def rows_of(table, crossings, summary, sweeps, weight):
    """Rows of all rules: on the first lines, by the proof of the return map, and without any passage."""
    passages = passages_of(table, crossings, sweeps, weight)
    count = len(passages)
    if not count:
        return
    for name, rule in RULES.items():
        for lines in LINES:
            error, work = judged_rule(rule, passages, lines)
            yield row_of(name, f"{lines} lines", error, work, count)
    error, pairs = second_starts(table)
    proof = sum(units for *_, units in passages)
    yield row_of("proof by the return map", f"{pairs} second starts", error, proof, pairs)
    for row in summary[summary.sweep.isin(sweeps)].to_dict("records"):
        if row["hit_rate"] == row["hit_rate"] and row["rule"].startswith("tweezer"):
            name = row["rule"].replace("_", " ")
            judged = row["right"] + row["wrong"]
            yield row_of("a priori", name, 1.0 - row["hit_rate"], max(row["node_updates"], 1.0), judged)
