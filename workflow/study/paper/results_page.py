"""The page of the results, docs/results.md: Markdown tables made from the results around plain words; and the
line of verdicts, kept between marks in README.md."""

import math
import re

from study.analysis.boundary import PARAMETERS, UNDISPUTED, critical_capillary_number
from study.analysis.tables import markdown_table
from study.paper.claims import SWEEP
from study.paper.grades import counted
from study.paper.manuscript import MISSING, expanded, number
from study.planning.points import STUDY_GROUPS

#: Series of brackets that the boundary shows; the first is set against the printed one.
SHOWN = ["default", "corrected", "hinge_sphere", "hinge_sheet", "blocked"]
NO_DOUBTS = "What the brackets depend on was not made yet: `snakemake --cores 2 uncertainty`."


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


def beside_print(shift, ends, claim):
    """Texts: Ca of the paper's Eq. (5) at this row shift, and how many times it the boundary is, if known."""
    printed = critical_capillary_number(shift, [claim["value"][name] for name in PARAMETERS])
    if printed is None:
        return ["", ""]
    return [f"{printed:.2f}", interval(*(end / printed for end in ends), ".2f") if printed and ends else ""]


def boundary(table, claim):
    """Critical capillary number of every series shown and of the paper's Eq. (5) by row shift, and how many
    times the printed one the first is."""
    rows = table[table.series.isin(SHOWN)]
    keys = zip(rows.series, rows.row_shift_um, strict=True)
    found = dict(zip(keys, rows[UNDISPUTED].astype(float).itertuples(index=False, name=None), strict=True))
    lines = []
    for shift in sorted(set(rows.row_shift_um)):
        texts = [interval(*found.get((name, shift), (math.nan, math.nan))) for name in SHOWN]
        lines.append([shift, *texts, *beside_print(shift, found.get((SHOWN[0], shift)), claim)])
    titles = ["d / um", *(f"`{name}`" for name in SHOWN), "paper, Eq. (5)", f"`{SHOWN[0]}` over Eq. (5)"]
    return "\n".join(markdown_table(titles, lines))


def changed_bracket(row):
    """Text of a bracket and of its change, per cent, from the least to the most that both brackets allow."""
    change = interval(row["least_change_percent"], row["most_change_percent"], "+.0f").replace(" - ", " to ")
    return interval(*(row[name] for name in UNDISPUTED)) + (f" ({change} %)" if change else "")


def doubts(table):
    """Brackets with one thing changed at a time, by row shift, from the table of the target `uncertainty`; a
    sentence without it (None)."""
    if table is None:
        return NO_DOUBTS
    table = table.sort_values("row_shift_um", ascending=False, kind="stable")
    shifts, lines = list(dict.fromkeys(table.row_shift_um)), []
    for (cause, setting, reference), rows in table.groupby(["cause", "setting", "reference"], sort=False):
        cells = {row["row_shift_um"]: changed_bracket(row) for row in rows.to_dict("records")}
        texts = (cells.get(shift, "") for shift in shifts)
        lines.append([f"{cause}: {setting}", f"`{reference}`", *texts])
    titles = ["changed alone", "against", *(f"d = {shift} um" for shift in shifts)]
    return "\n".join(markdown_table(titles, lines))


def lattices(table):
    """Largest distance (um) from the printed law by series, and up to which capillary number; None where the
    finer lattice has no law yet."""
    if table is None or table.set_index("series").largest_distance_um.isna().get("refined", True):
        return None
    rows = table.set_index("series")
    distances = {name: f"{value:.2f}" for name, value in rows.largest_distance_um.dropna().items()}
    return distances | {"to_ca": f"{rows.to_ca['refined']:g}"}


def finer_cells(table):
    """How many cells of the finer lattice have a printed class, and how many have it; None without them."""
    if table is None:
        return None
    return {"named": int(table.as_printed.count()), "as_printed": int(table.as_printed.sum())}


def starts(table):
    """What became of the class of passages from a second place, by set of passages."""
    heads = {"set": "started in the middle of the gap", "points": "passages", "same_class": "same class"}
    heads |= {"other_class": "the other", "no_class": "undecided or failed"}
    rows = table[list(heads)].itertuples(index=False, name=None)
    return "\n".join(markdown_table(list(heads.values()), [list(row) for row in rows]))


def verdicts(table):
    """How many claims came out and how many did not."""
    return f"**Claims: {counted(table.verdict).lower()}.**"


#: Rules that guess the class without following the cell, in words; the shape of the cell comes from these.
RULES = {
    "tweezer_printed_law": "extent of the stretched cell, s by the printed law",
    "tweezer": "extent of the stretched cell, s as simulated",
    "d_perp": "extent at the pillar, from the passage itself",
    "centre": "centre at the gap line beyond s, from the passage itself",
}


def rules(table):
    """How often each rule of the class was right on the grid; None where there is no such sweep."""
    rows = table[(table.sweep == SWEEP) & table.rule.isin(RULES)].set_index("rule")
    lines = []
    for rule in (rule for rule in RULES if rule in rows.index):
        right, wrong = (int(rows[name][rule]) for name in ("right", "wrong"))
        work = rows.node_updates[rule]
        lines.append([RULES[rule], f"{right} of {right + wrong}", f"{work:.1e}" if work else "none"])
    titles = ["rule", "cells right", "work / node updates"]
    return "\n".join(markdown_table(titles, lines)) if lines else None


def readings(declared):
    """What each series shown is, in the words of the claims."""
    words = {one["id"]: one["description"] for one in declared}
    return "\n".join(markdown_table(["column", "what it is"], [[f"`{name}`", words[name]] for name in SHOWN]))


def claim_line(table, name):
    """One claim with what was measured and its verdict as an item of a list; empty where it is not judged."""
    for row in table[table.id == name].to_dict("records"):
        measured = row["measured"] if isinstance(row["measured"], str) else "not measured"
        claim = row["claim"][0].upper() + row["claim"][1:]
        return f"- {claim}. Measured: {measured}. **{row['verdict'].capitalize()}.**"
    return ""


def declared_number(declared, tables, key):
    """A number of the article by its key, as paper/numbers.toml declares it; None where the tier lacks it."""
    entries = (entry for group in declared for entry in expanded(group))
    text = number(next(entry for entry in entries if entry["key"] == key), tables, {})
    return None if text == MISSING else text
