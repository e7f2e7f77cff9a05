"""The numbers of README.md: Markdown tables made from the results, kept between marks in the text."""

import math
import re

from study.boundary import PARAMETERS, critical_capillary_number
from study.claims import counted
from study.points import STUDY_GROUPS
from study.tables import markdown_table

#: Series of brackets that the boundary of the README shows, by how their names begin.
SHOWN = ("lattice-", "corrected-", "extrapolated")
#: The series that is set against the printed boundary, and what that column is called.
JUDGED, AGAINST_PRINT = "corrected-0.4", "0.4 um, corrected, over Eq. (5)"


def with_blocks(text, blocks):
    """The text with every block put between its marks `<!-- name -->` and `<!-- end -->`; an error if a block
    has no place."""
    for name, block in blocks.items():
        pattern = rf"(<!-- {re.escape(name)} -->\n).*?(\n *<!-- end -->)"
        text, count = re.subn(pattern, lambda m, block=block: m[1] + block + m[2], text, flags=re.DOTALL)
        if count != 1:
            raise ValueError(f"the text has {count} places for '{name}', one is needed: <!-- {name} -->")
    return text


def times(stages):
    """Runs and core time of every stage of the study and their sum, from the table of stage times."""
    stages = stages[stages.stage.isin(STUDY_GROUPS)]
    sums = stages.groupby(["stage", "dx_um"], as_index=False).agg(
        runs=("runs", "sum"), longest_s=("longest_s", "max"), total_s=("total_s", "sum")
    )
    rows = [
        [row.stage, f"{row.dx_um:.3g}", row.runs, f"{row.longest_s:.0f}", f"{row.total_s / 60:.1f}"]
        for row in sums.itertuples()
    ]
    total = ["**all**", "", sums.runs.sum(), "", f"**{sums.total_s.sum() / 60:.0f}**"]
    titles = ["stage", "dx / um", "runs", "longest / s", "together / core min"]
    return "\n".join(markdown_table(titles, [*rows, total]))


def interval(low, high, digits=3):
    """Text of a bracket of the critical capillary number, open where an end is missing."""
    low, high = (None if math.isnan(end) else f"{end:.{digits}g}" for end in (low, high))
    if low and high:
        return f"{low} - {high}"
    return f"above {low}" if low else f"below {high}" if high else ""


def boundary(table, claim):
    """Critical capillary number by row shift: on each lattice, in their limit and by the paper's Eq. (5), and
    how many times the printed one it is."""
    free = table[table.series.str.startswith(SHOWN)]
    limits = [name for name in sorted(free.series.unique()) if name.startswith("extrapolated")]
    lattices = [name for name in sorted(free.series.unique(), reverse=True) if name not in limits]
    rows = []
    for shift, group in free.groupby("row_shift_um"):
        found = {row.series: (row.ca_displaced, row.ca_zigzag) for row in group.itertuples()}
        printed = critical_capillary_number(shift, [claim["value"][name] for name in PARAMETERS])
        texts = [interval(*found[name]) if name in found else "" for name in lattices + limits]
        known = printed is not None and JUDGED in found
        ratio = interval(*(end / printed for end in found[JUDGED]), 2) if known else ""
        rows.append([shift, *texts, "" if printed is None else f"{printed:.2f}", ratio])
    kinds = (name.partition("-") for name in lattices)
    heads = [f"Ca at {dx} um" + ("" if kind == "lattice" else f", {kind}") for kind, _, dx in kinds]
    return "\n".join(markdown_table(["d / um", *heads, *limits, "paper, Eq. (5)", AGAINST_PRINT], rows))


def verdicts(table):
    """How many claims came out and how many did not."""
    return f"**Claims: {counted(table.verdict).lower()}.**"
