"""Passages of the committed study made again: which ones are drawn, their cases, and how alike they came out.

The committed table names each run by the hash of its case. The case itself comes from the study file: a row
whose run is not found there was made by another study.
"""

import random

from study.analysis.passages import COLUMNS, STYLES
from study.analysis.tables import cell
from study.planning.brackets import at_value
from study.planning.cases import run_id

#: Largest relative difference of D_perp that counts as the same result on another processor or compiler.
CLOSE = 0.005
SAME, ALIKE, OTHER = "same", "alike", "other"
#: What a change of rounding may not move.
LABELS = ("class", "zigs")


def asked(config):
    """(most_node_updates, sample, seed) of the options of the command line, where every value may be a text;
    a ValueError that lists what is wrong with them."""
    ranges = {
        "most_node_updates": (1e99, float, 1, "a number of at least 1, such as 5e9"),
        "sample": (20, int, 1, "a whole number of at least 1"),
        "seed": (1, int, 0, "a whole number of at least 0"),
    }
    values, found = [], []
    for name, (default, kind, least, words) in ranges.items():
        given = config.get(name, default)
        try:
            value = kind(str(given))
        except ValueError:
            value = None
        if value is None or not value >= least or value == float("inf"):
            found.append(f"--config {name}={given}: {words} is needed")
        values.append(value)
    if found:
        raise ValueError("\n".join(found))
    return tuple(values)


def drawn(table, count, seed, most_node_updates):
    """`count` runs of a table of passages (all, if it has fewer), drawn without replacement, every run with
    the same chance; runs with more node updates than `most_node_updates` are left out."""
    runs = sorted(set(table.run[table.node_updates <= most_node_updates]))
    return random.Random(seed).sample(runs, min(count, len(runs)))


def planned_case(identity, plan):
    """The resolved case of a run that the plan knows beforehand; None if it is not among them."""
    return next((run["case"] for run in plan["runs"] if run["id"] == identity), None)


def case_of(row, plan):
    """The resolved case of a row of the table of passages; a ValueError if the study has no such run."""
    if case := planned_case(row["run"], plan):
        return case
    for bracket in plan["brackets"].values():
        case = at_value(bracket["case"], bracket["axis"], float(row[bracket["axis"]]))
        if run_id(case, plan["solver_model"]) == row["run"]:
            return case
    raise ValueError(
        f"run {row['run']} ({row['sweep']}, d = {row['row_shift_um']} um, Ca = {row['capillary_number']}) "
        "is in the committed table and not in the file of the study: make it again, or take its study"
    )


def texts(row):
    """A row of results as the table of passages shows it."""
    return {name: cell(name, row[name], STYLES) for name in COLUMNS}


def _equal(a, b):
    """Same text or same number: a column with gaps shows whole numbers in another format."""
    try:
        return a == b or float(a) == float(b)
    except ValueError:
        return False


def compared(committed, remade):
    """(verdict, columns that differ) of two rows of texts.

    same: every column; alike: class, number of zigs, and D_perp to 0.5 %, as other rounding leaves them.
    """
    columns = [name for name in COLUMNS if name != "sweep" and not _equal(committed[name], remade[name])]
    if not columns:
        return SAME, columns
    if any(name in columns for name in LABELS):
        return OTHER, columns
    a, b = (row["d_perp_um"] for row in (committed, remade))
    if a == b or (a and b and abs(float(a) - float(b)) <= CLOSE * abs(float(a))):
        return ALIKE, columns
    return OTHER, columns
