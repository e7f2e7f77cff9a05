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
#: What the brackets of the corrected coupling depend on, by series.
DOUBTS = {
    "corrected-0.4": "**`corrected`, 0.4 um**",
    "half-force": "half the force, i.e. half the inertia",
    "contact-0.05": "contact at 0.05 instead of 0.1 um",
    "mesh-14": "mesh refined alone, frequency 10 to 14",
    "corrected-0.2": "**`reference`, 0.2 um**",
    "mesh-28": "mesh refined alone, frequency 20 to 28",
}
#: Brackets without net lateral flow, by series; the first is set against the printed boundary.
BLOCKED = {"blocked-corrected": "corrected", "blocked-lateral": "plain kernel"}


def with_blocks(text, blocks):
    """The text with every block put between its marks `<!-- name -->` and `<!-- end -->`; an error if a block
    has no place."""
    for name, block in blocks.items():
        pattern = rf"(<!-- {re.escape(name)} -->\n).*?^( *<!-- end -->)"
        text, count = re.subn(
            pattern, lambda m, block=block: f"{m[1]}{block}\n{m[2]}", text, flags=re.DOTALL | re.MULTILINE
        )
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


def interval(low, high, style=".3g"):
    """Text of a bracket of the critical capillary number, open where an end is missing."""
    low, high = (None if math.isnan(end) else f"{end:{style}}" for end in (low, high))
    if low and high:
        return f"{low} - {high}"
    return f"above {low}" if low else f"below {high}" if high else ""


def remarks(row):
    """What a bracket leaves open, in brackets: undecided passages inside, passages that contradict it."""
    counts = ((row.undecided_inside, "undecided inside"), (row.contradictions, "against it"))
    texts = [f"{count:.0f} {what}" for count, what in counts if count]
    return f" ({', '.join(texts)})" if texts else ""


def beside_print(shift, ends, claim):
    """Texts: Ca of the paper's Eq. (5) at this row shift, and how many times it the boundary is, if known."""
    printed = critical_capillary_number(shift, [claim["value"][name] for name in PARAMETERS])
    if printed is None:
        return ["", ""]
    return [f"{printed:.2f}", interval(*(end / printed for end in ends), ".2f") if printed and ends else ""]


def brackets_of(table, names):
    """Text of every bracket of these series, by series and row shift."""
    chosen = table[table.series.isin(names)].itertuples()
    return {
        (row.series, row.row_shift_um): interval(row.ca_displaced, row.ca_zigzag) + remarks(row)
        for row in chosen
    }


def undisputed_ends(table, series):
    """By row shift, where the boundary of a series lies for certain: what the print is judged by."""
    rows = table[table.series == series].itertuples()
    return {row.row_shift_um: (row.ca_undisputed_displaced, row.ca_undisputed_zigzag) for row in rows}


def doubts(table):
    """Brackets of the corrected coupling with one thing changed at a time, where something was changed."""
    found = brackets_of(table, DOUBTS)
    shifts = sorted({shift for name, shift in found if name not in (JUDGED, "corrected-0.2")}, reverse=True)
    rows = [
        [f"{label} (`{name}`)", *(found.get((name, shift), "") for shift in shifts)]
        for name, label in DOUBTS.items()
        if any((name, shift) in found for shift in shifts)
    ]
    return "\n".join(markdown_table(["changed alone", *(f"d = {shift} um" for shift in shifts)], rows))


def blocked(table, claim):
    """Brackets without net lateral flow, by row shift, and how many times the printed one the first is."""
    found, judged = brackets_of(table, BLOCKED), next(iter(BLOCKED))
    ends = undisputed_ends(table, judged)
    rows = []
    for shift in sorted({shift for _, shift in found}):
        texts = [found.get((name, shift), "") for name in BLOCKED]
        rows.append([shift, *texts, *beside_print(shift, ends.get(shift), claim)])
    heads = [f"Ca, {label}" for label in BLOCKED.values()]
    return "\n".join(
        markdown_table(["d / um", *heads, "paper, Eq. (5)", f"{BLOCKED[judged]} over Eq. (5)"], rows)
    )


def boundary(table, claim):
    """Critical capillary number by row shift: on each lattice, in their limit and by the paper's Eq. (5), and
    how many times the printed one it is."""
    free = table[table.series.str.startswith(SHOWN)]
    limits = [name for name in sorted(free.series.unique()) if name.startswith("extrapolated")]
    lattices = [name for name in sorted(free.series.unique(), reverse=True) if name not in limits]
    ends, rows = undisputed_ends(table, JUDGED), []
    for shift, group in free.groupby("row_shift_um"):
        found = {row.series: (row.ca_displaced, row.ca_zigzag) for row in group.itertuples()}
        texts = [interval(*found[name]) if name in found else "" for name in lattices + limits]
        rows.append([shift, *texts, *beside_print(shift, ends.get(shift), claim)])
    kinds = (name.partition("-") for name in lattices)
    heads = [f"Ca at {dx} um" + ("" if kind == "lattice" else f", {kind}") for kind, _, dx in kinds]
    return "\n".join(markdown_table(["d / um", *heads, *limits, "paper, Eq. (5)", AGAINST_PRINT], rows))


def starts(table):
    """What became of the class of passages from a second place, by set of passages."""
    heads = {"set": "started in the middle of the gap", "points": "passages", "same_class": "same class"}
    heads |= {"other_class": "the other", "no_class": "undecided or failed"}
    rows = table[list(heads)].itertuples(index=False, name=None)
    return "\n".join(markdown_table(list(heads.values()), [list(row) for row in rows]))


def verdicts(table):
    """How many claims came out and how many did not."""
    return f"**Claims: {counted(table.verdict).lower()}.**"
