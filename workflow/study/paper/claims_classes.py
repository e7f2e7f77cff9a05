"""Checks of the claims on the class of a cell: rows of the phase space and what they are good for."""

import math
from itertools import groupby
from operator import attrgetter

from study.paper.claims import (
    SERIES,
    Finding,
    Undecidable,
    at_paper_lattice,
    at_row_shift,
    check,
    grid,
    ranged,
    runs_of,
    statements_that_hold,
)
from study.planning.classes import DECIDED

# Series of brackets that stand beside the default.
OTHERS = ("corrected", "refined", "reference", "blocked", "blocked-corrected")
CAPILLARY_NUMBERS = [0.1, 0.3, 0.5, 0.7, 1.2]  # of Fig. 6
ROW_SHIFTS = 10  # of the paper
SAME = 1e-9  # capillary numbers closer than this are one


def listed(rows):
    """Classes in words, neighbouring equal ones together: `0.1 ... 0.7 displaced, 0.8 ... 1.5 zigzag`."""
    groups = [
        (label, [row.capillary_number for row in members])
        for label, members in groupby(rows.itertuples(), key=attrgetter("label"))
    ]
    return ", ".join(f"{ranged(numbers, 'g')} {label}" for label, numbers in groups)


def other_series(tables, row_shift_um):
    """What the corrected coupling, the finer lattice and the blocked flow say at one row shift."""
    found = {name: near_boundary(tables, row_shift_um, name) for name in OTHERS}
    return "; ".join(f"d = {row_shift_um:g}, {name}: {text}" for name, text in found.items() if text)


def near_boundary(tables, row_shift_um, series=SERIES):
    """The bracket of the critical capillary number in words: how sure a class is; empty if there is none."""
    rows = at_row_shift(tables["phase_boundary"], row_shift_um)
    rows = rows[rows.series == series]
    if rows.empty:
        return ""
    row = rows.iloc[0]
    if row.status.startswith("all"):
        return f"{row.status} up to Ca = {row.ca_displaced:g}" if row.ca_displaced > 0 else row.status
    if not (row.ca_displaced > 0 and row.ca_zigzag > 0):
        return ""
    return f"critical Ca {row.ca_displaced:.3g} ... {row.ca_zigzag:.3g}"


def unknown(cells, rows):
    """Capillary numbers of the cells that no row tells the class of."""
    known = set(rows.capillary_number.round(6))
    return [ca for ca in cells.capillary_number if round(ca, 6) not in known]


def middle_of_switch(rows):
    """Capillary number half way between the softest displaced and the stiffest zigzag cell of a row shift;
    None if a class is missing or they are mixed."""
    displaced = rows[rows.label == "displaced"].capillary_number.max()
    zigzag = rows[rows.label == "zigzag"].capillary_number.min()
    return (displaced + zigzag) / 2 if displaced < zigzag else None


def switches_within(rows, cells, displaced_to, zigzag_from):
    """Are all cells up to one capillary number displaced and all from another on zigzag?"""
    labels = dict(zip(rows.capillary_number.round(6), rows.label, strict=True))
    numbers = cells.capillary_number.round(6)
    expected = {ca: "displaced" for ca in numbers if ca <= displaced_to + SAME}
    expected |= {ca: "zigzag" for ca in numbers if ca >= zigzag_from - SAME}
    return all(labels.get(ca) == label for ca, label in expected.items())


def chosen(rows, wanted, lowest):
    """The rows or cells with the capillary numbers `wanted`, or all from `lowest` on."""
    rows = rows[rows.capillary_number >= lowest - SAME]
    return rows[rows.capillary_number.round(6).isin(wanted)] if wanted else rows


def at_wanted(tables, shift, wanted, lowest):
    """(rows, cells that should have one) at a row shift; None where a tier or a reading has too few."""
    rows, cells = (
        chosen(at_row_shift(table, shift), wanted, lowest) for table in (grid(tables), tables["cells"])
    )
    return None if rows.empty or len(cells) < max(3, len(wanted or [])) else (rows, cells)


def distance_of_switch(rows, printed):
    """How far the capillary number at which the class switches is from a printed one; None without one."""
    found = middle_of_switch(rows)
    return None if printed is None or found is None else float(abs(found - printed))


def classes_as(shifts, zigzag_from, wanted=None, lowest=0.0, switch=None):
    """Check that exactly the cells with Ca above `zigzag_from` zigzag and the others are displaced, at every
    one of the row shifts; of the capillary numbers `wanted`, or of all from `lowest` on. `switch` is the
    capillary number that the statement names, if it names one; such a statement is on one row shift.
    """

    def function(tables, claim, _):
        parts = {shift: at_wanted(tables, shift, wanted, lowest) for shift in shifts}
        there = {shift: part for shift, part in parts.items() if part}
        wrong, missing = False, []
        for shift, (rows, cells) in there.items():
            expected = rows.capillary_number.gt(zigzag_from).map({True: "zigzag", False: "displaced"})
            decided = rows.label.isin(DECIDED)
            wrong = wrong or bool((decided & (rows.label != expected)).any())
            open_cells = rows[~decided].capillary_number.to_list() + unknown(cells, rows)
            missing += [f"d = {shift:g}, Ca = {ca:g}" for ca in open_cells]
        if not wrong and len(there) < len(shifts):
            return None
        text = "; ".join(f"d = {shift:g}: {listed(rows)}" for shift, (rows, _) in there.items())
        if not wrong and missing:
            raise Undecidable(f"no class at {'; '.join(missing)}; {text}")
        note = "; ".join(filter(None, (other_series(tables, shift) for shift in there)))
        sure = "; ".join(filter(None, (near_boundary(tables, shift) for shift in there)))
        row, cells = (at_row_shift(table, shifts[0]) for table in (grid(tables), tables["cells"]))
        holding = statements_that_hold(claim, lambda said: switches_within(row, cells, **said["value"]))
        runs = runs_of(*(rows for rows, _ in there.values()))
        return Finding(not wrong, text, note, sure, runs, distance_of_switch(row, switch), holding)

    return function


check("eps-5-all-displaced")(classes_as([2.0], math.inf))
check("eps-11-soft-zigzag")(classes_as([4.4], 1.0, switch=1.0))
check("eps-13-zigzag")(classes_as([5.2], 0.0, lowest=0.5, switch=0.5))
check("eps-17-stiff-displaced")(classes_as([6.8], 0.2, CAPILLARY_NUMBERS))
check("eps-20-22-all-zigzag")(classes_as([8.0, 8.8], 0.0))


def incomplete(rows, cells):
    """Row shifts of the cells at which a class is undecided or not there."""
    return [
        shift
        for shift in sorted(set(cells.row_shift_um))
        if (~at_row_shift(rows, shift).label.isin(DECIDED)).any()
        or unknown(at_row_shift(cells, shift), at_row_shift(rows, shift))
    ]


def window_beyond(mixed, shifts, window):
    """By how much the window of both classes ends later than printed, um: at the row shifts next to it, both
    without. None if it has no end there."""
    below, above = [one for one in shifts if one < min(mixed)], [one for one in shifts if one > max(mixed)]
    if not below or not above:
        return None
    return float(max(window[0] - max(below), min(above) - window[1], 0.0))


@check("window")
def window(tables, claim, _):
    rows, (low, high) = grid(tables), claim["value"]
    found = rows.groupby("row_shift_um").label.agg(set)
    mixed = [shift for shift, labels in found.items() if labels.issuperset(DECIDED)]
    beyond = [shift for shift in mixed if not low < shift < high]
    if len(found) < ROW_SHIFTS and not beyond:
        return None
    unclear = incomplete(rows, tables["cells"])
    outside = [shift for shift in unclear if not low < shift < high]

    def listed_shifts(shifts):
        return ", ".join(f"{shift:g}" for shift in shifts)

    if not beyond and (outside or (not mixed and unclear)):
        raise Undecidable(f"cells without a class at d = {listed_shifts(outside or unclear)} um")
    text = f"both classes at d = {listed_shifts(mixed)} um" if mixed else "one class at every row shift"
    notes = [f"on an edge or outside: d = {listed_shifts(beyond)} um"] if beyond else []
    notes += [f"cells without a class there: d = {listed_shifts(outside)} um"] if outside else []
    sure = "one row shift of the grid, 0.4 to 1.2 um"
    clear = [shift for shift in found.index if shift not in unclear]
    difference = window_beyond(mixed, clear, claim["value"]) if mixed else None
    good = bool(mixed) and not beyond
    return Finding(good, text, "; ".join(notes), sure, runs_of(rows), difference)


def edge_distance(rows, printed):
    """How far a printed row shift is from where the cells of one capillary number switch, um: 0 between the
    largest displaced and the smallest zigzag one. None if they do not switch once."""
    displaced = rows[rows.label == "displaced"].row_shift_um.max()
    zigzag = rows[rows.label == "zigzag"].row_shift_um.min()
    if not displaced < zigzag:
        return None
    return float(max(displaced - printed, printed - zigzag, 0.0))


@check("design-example")
def design_example(tables, claim, _):
    low, high = claim["value"]
    pair = [
        [table[table.capillary_number.sub(ca).abs() < SAME] for ca in (0.4, 1.2)]
        for table in (grid(tables), tables["cells"])
    ]
    (stiff, soft), cells = ([rows[rows.row_shift_um.between(low, high)] for rows in two] for two in pair)
    if stiff.empty or soft.empty:
        return None
    wrong = (stiff.label == "zigzag").any() or (soft.label == "displaced").any()
    decided = [set(rows[rows.label.isin(DECIDED)].row_shift_um) for rows in (stiff, soft)]
    if not wrong and decided != [set(rows.row_shift_um) for rows in cells]:
        raise Undecidable("a cell within the window has no class")
    labels = [dict(zip(rows.row_shift_um, rows.label, strict=True)) for rows in (stiff, soft)]
    shifts = sorted(set(labels[0]) & set(labels[1]))
    text = "; ".join(f"d = {shift:g}: {labels[0][shift]}, {labels[1][shift]}" for shift in shifts)
    stiff_displaced, soft_zigzag = (
        set(rows[rows.label == name].row_shift_um) for rows, name in zip(pair[0], DECIDED, strict=True)
    )
    edges = [edge_distance(rows, at) for rows, at in zip(pair[0], (high, low), strict=True)]
    difference = max(edges) if stiff_displaced & soft_zigzag and None not in edges else None
    critical = at_paper_lattice(tables["critical_row_shift"])
    limits = [
        f"Ca = {row.capillary_number:g}: {row.d_displaced_um:g} ... {row.d_zigzag_um:g} um"
        for row in critical[critical.capillary_number.isin([0.4, 1.2])].itertuples()
    ]
    sure = "critical d at " + ", ".join(limits) if limits else ""
    return Finding(
        not wrong, text, "classes of Ca = 0.4 and 1.2", sure, runs_of(stiff, soft), difference=difference
    )
