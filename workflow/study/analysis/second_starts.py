"""Whether the class depends on where the cell starts: passages begun at a second place, counted by what they
became, over points of the phase space and over the ends of the brackets."""

import pandas as pd

from study.analysis.passages import KEYS
from study.planning.classes import DECIDED

#: Name of the sweep and of the confirmations from the second place, and of the sweep they are set against.
SWEEP, BASE = "second-start", "grid"


def grid_pairs(passages):
    """(class, class from the second place) of the points where the first one is decided."""
    point = [key for key in KEYS if key != "sweep"]
    classes = [passages[passages.sweep == name].set_index(point)["class"] for name in (BASE, SWEEP)]
    both = pd.concat(classes, axis=1, keys=["first", "second"], join="inner")
    return list(both[both["first"].isin(DECIDED)].itertuples(index=False, name=None))


def end_pairs(confirmation):
    """By series, (class, class from the second place) of the ends of its brackets."""
    found = {}
    for row in confirmation[confirmation.confirmation == SWEEP].to_dict("records"):
        for label in DECIDED:
            if pd.notna(row[f"ca_{label}"]):
                found.setdefault(row["series"], []).append((label, row[f"class_at_{label}"]))
    return found


def counted(name, pairs):
    """Row of the table: how many passages of a set kept their class from the second place."""
    same = sum(first == second for first, second in pairs)
    other = sum(first != second and second in DECIDED for first, second in pairs)
    return {
        "set": name,
        "points": len(pairs),
        "same_class": same,
        "other_class": other,
        "no_class": len(pairs) - same - other,
    }


def rows_of(passages, confirmation):
    """Rows for the grid, where it has a second start, and for the ends of every series that was confirmed."""
    grid = grid_pairs(passages)
    rows = [counted(BASE, grid)] if grid else []
    return rows + [
        counted(f"ends of {name}", pairs) for name, pairs in sorted(end_pairs(confirmation).items())
    ]
