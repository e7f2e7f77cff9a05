"""Measured data, read strictly: a typing error in a table is named and never a missing point."""

import csv
import math

import pandas as pd


def _number(text):
    """The finite number of a cell, None for an empty one; a ValueError for anything else."""
    if text == "":
        return None
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(text)
    return value


def _unit(name):
    """Whether a column holds numbers: its name ends with a unit."""
    return name.rsplit("_", 1)[-1] in ("pN", "um")


def problem_of(name, text):
    """What is wrong with one cell; None if nothing is."""
    if not _unit(name):
        return None if text.strip() else "is empty: a name is needed"
    try:
        value = _number(text)
    except ValueError:
        return f"= {text!r}: a finite number is needed, with a point, or nothing"
    if value is None:
        return "is empty: a number is needed" if name == "F_pN" else None
    if "_err_" in name and value <= 0:
        return f"= {text}: an error bar is above 0; leave the cell empty if it is not known"
    return f"= {text}: at least 0 is needed" if value < 0 else None


def read_measured(path):
    """The data frame of a table of measured values, `#` before comments; a ValueError that lists all that is
    wrong in it, with line and column."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = [(number, line) for number, line in enumerate(file, 1) if not line.startswith("#")]
    cells = csv.reader((line for _, line in lines), quoting=csv.QUOTE_NONE)  # one line, one row
    rows = [(number, row) for (number, _), row in zip(lines, cells, strict=True)]
    if not rows:
        raise ValueError(f"{path}: no header")
    header, found = rows[0][1], []
    for number, row in rows[1:]:
        if len(row) != len(header):
            found.append(
                f"line {number}: {len(row)} columns, the header has {len(header)}; separate them by commas"
            )
            continue
        for name, text in zip(header, row, strict=True):
            if problem := problem_of(name, text):
                found.append(f"line {number}, {name} {problem}")
    if found:
        raise ValueError("\n  ".join([f"{path}:", *found]))
    return pd.read_csv(path, comment="#")
