"""Checks of the claims on the class of a cell: rows of the phase space, its boundary, what it is good for."""

import math
from itertools import groupby
from operator import attrgetter

import numpy as np

from study.boundary import PARAMETERS, law
from study.claims import (
    LIMIT,
    PAPER_RANGE,
    SERIES,
    SWEEP,
    Finding,
    Undecidable,
    at_paper_lattice,
    check,
    ranged,
    runs_of,
)
from study.passages import DECIDED

# Series of brackets that stand beside the paper's lattice.
OTHERS = ("lattice-0.2", LIMIT, "corrected-0.4", "blocked-corrected")
CAPILLARY_NUMBERS = [0.1, 0.3, 0.5, 0.7, 1.2]  # of Fig. 6
ROW_SHIFTS = 10  # of the paper


def grid(tables, sweep=SWEEP):
    """Rows of the phase space at the paper's lattice and within its capillary numbers; `label` is the
    class.
    """
    table = at_paper_lattice(tables["passages"].rename(columns={"class": "label"}))
    low, high = PAPER_RANGE
    rows = table[(table.sweep == sweep) & table.capillary_number.between(low - 1e-9, high + 1e-9)]
    return rows.sort_values(["row_shift_um", "capillary_number"])


def at_row_shift(tables, row_shift_um):
    """The same at one row shift."""
    rows = grid(tables)
    return rows[rows.row_shift_um.sub(row_shift_um).abs() < 1e-6]


def passages(tables, row_shift_um):
    """The same by capillary number."""
    return {float(row.capillary_number): row for row in at_row_shift(tables, row_shift_um).itertuples()}


def listed(rows):
    """Classes in words, neighbouring equal ones together: `0.1 ... 0.7 displaced, 0.8 ... 1.5 zigzag`."""
    groups = [
        (label, [row.capillary_number for row in members])
        for label, members in groupby(rows.itertuples(), key=attrgetter("label"))
    ]
    return ", ".join(f"{ranged(numbers, 'g')} {label}" for label, numbers in groups)


def other_lattices(tables, row_shift_um):
    """What the finer lattice, the limit and the corrected coupling say at one row shift."""
    found = {name: near_boundary(tables, row_shift_um, name) for name in OTHERS}
    return "; ".join(f"d = {row_shift_um:g}, {name}: {text}" for name, text in found.items() if text)


def near_boundary(tables, row_shift_um, series=SERIES):
    """The bracket of the critical capillary number in words: how sure a class is; empty if there is none."""
    rows = tables["phase_boundary"]
    rows = rows[(rows.series == series) & (rows.row_shift_um.sub(row_shift_um).abs() < 1e-6)]
    if rows.empty:
        return ""
    row = rows.iloc[0]
    if row.status.startswith("all"):
        return f"{row.status} up to Ca = {row.ca_displaced:g}" if row.ca_displaced > 0 else row.status
    if not (row.ca_displaced > 0 and row.ca_zigzag > 0):
        return ""
    return f"critical Ca {row.ca_displaced:.3g} ... {row.ca_zigzag:.3g}"


def classes_as(shifts, zigzag_from, wanted=None, lowest=0.0):
    """Check that exactly the cells with Ca above `zigzag_from` zigzag and the others are displaced, at every
    one of the row shifts; of the capillary numbers `wanted`, or of all from `lowest` on."""

    def function(tables, claim, _):
        good, texts, notes, sure, frames = True, [], [], [], []
        for shift in shifts:
            rows = at_row_shift(tables, shift)
            rows = rows[rows.capillary_number >= lowest - 1e-9]
            if wanted:
                rows = rows[rows.capillary_number.round(6).isin(wanted)]
            if len(rows) < max(3, len(wanted or [])):
                return None
            expected = ["zigzag" if ca > zigzag_from else "displaced" for ca in rows.capillary_number]
            good = good and list(rows.label) == expected
            texts.append(f"d = {shift:g}: {listed(rows)}")
            notes.append(other_lattices(tables, shift))
            sure.append(near_boundary(tables, shift))
            frames.append(rows)
        note = "; ".join(filter(None, notes))
        return Finding(good, "; ".join(texts), note, "; ".join(filter(None, sure)), runs_of(*frames))

    return function


check("eps-5-all-displaced")(classes_as([2.0], math.inf))
check("eps-11-soft-zigzag")(classes_as([4.4], 1.0))
check("eps-13-zigzag")(classes_as([5.2], 0.0, lowest=0.5))
check("eps-17-stiff-displaced")(classes_as([6.8], 0.2, CAPILLARY_NUMBERS))
check("eps-20-22-all-zigzag")(classes_as([8.0, 8.8], 0.0))


def fitted(tables, name):
    """(a, b, c) of a fit of the boundary and their rows; None if it was not made."""
    rows = tables["fits"]
    rows = rows[rows.name == f"boundary/{name}"].set_index("parameter")
    if not set(PARAMETERS) <= set(rows.index):
        return None
    return rows.loc[list(PARAMETERS)]


@check("phase-boundary")
def phase_boundary(tables, claim, _):
    found, boundary = fitted(tables, SERIES), tables["phase_boundary"]
    if found is None:
        if (boundary.series == SERIES).sum() >= ROW_SHIFTS:
            raise Undecidable(f"the brackets of {SERIES} do not fix the three coefficients")
        return None
    printed = [claim["value"][name] for name in PARAMETERS]
    numbers = np.linspace(*PAPER_RANGE, 141)

    def distance(rows):
        return float(np.abs(law(rows.value.to_numpy(), numbers) - law(printed, numbers)).max())

    def text(rows):
        a, b, c = rows.value
        return f"{a:.2f} + {b:.2f} exp(-{c:.2f} Ca), off by {distance(rows):.2f} um at most"

    others = {name: fitted(tables, name) for name in (*OTHERS, "paper-text")}
    note = "; ".join(f"{name}: {text(rows)}" for name, rows in others.items() if rows is not None)
    interval = ", ".join(f"{name} {row.low:.2f} ... {row.high:.2f}" for name, row in found.iterrows())
    runs = runs_of(boundary[boundary.series == SERIES].rename(columns={"runs": "run"}))
    good = distance(found) <= claim["tolerance"]
    return Finding(good, text(found), note, f"95 %: {interval}", runs)


@check("window")
def window(tables, claim, _):
    rows = grid(tables)
    if rows.row_shift_um.nunique() < ROW_SHIFTS:
        return None
    found = rows.groupby("row_shift_um").label.agg(set)
    mixed = [shift for shift, labels in found.items() if labels.issuperset(DECIDED)]
    low, high = claim["value"]
    beyond = [shift for shift in mixed if not low < shift < high]
    unclear = [
        shift for shift, labels in found.items() if not low < shift < high and labels.difference(DECIDED)
    ]
    good = bool(mixed) and not beyond and not unclear

    def listed_shifts(shifts):
        return ", ".join(f"{shift:g}" for shift in shifts)

    text = f"both classes at d = {listed_shifts(mixed)} um"
    notes = [f"on an edge or outside: d = {listed_shifts(beyond)} um"] if beyond else []
    notes += [f"undecided or diverged cells there: d = {listed_shifts(unclear)} um"] if unclear else []
    note = "; ".join(notes)
    return Finding(good, text, note, "one row shift of the grid, 0.4 to 1.2 um", runs_of(rows))


@check("design-example")
def design_example(tables, claim, _):
    rows = grid(tables)
    low, high = claim["value"]
    rows = rows[rows.row_shift_um.between(low, high)]
    stiff, soft = (rows[rows.capillary_number.sub(ca).abs() < 1e-9] for ca in (0.4, 1.2))
    if not len(stiff) or len(stiff) != len(soft):
        return None
    good = set(stiff.label) == {"displaced"} and set(soft.label) == {"zigzag"}
    pairs = zip(stiff.itertuples(), soft.itertuples(), strict=True)
    text = "; ".join(f"d = {a.row_shift_um:g}: {a.label}, {b.label}" for a, b in pairs)
    critical = tables["critical_row_shift"]
    critical = at_paper_lattice(critical)
    limits = [
        f"Ca = {row.capillary_number:g}: {row.d_displaced_um:g} ... {row.d_zigzag_um:g} um"
        for row in critical[critical.capillary_number.isin([0.4, 1.2])].itertuples()
    ]
    return Finding(
        good, text, "classes of Ca = 0.4 and 1.2", "critical d at " + ", ".join(limits), runs_of(stiff, soft)
    )


@check("slow-near-boundary")
def slow_near_boundary(tables, claim, _):
    rows = passages(tables, 6.0)
    if not {0.1, 0.3} <= set(rows):
        return None
    names = [rows[ca].label for ca in (0.1, 0.3)]
    speeds = {ca: row.speed_um_per_kilostep for ca, row in rows.items() if row.label == "displaced"}
    ratio = rows[0.3].speed_um_per_kilostep / rows[0.1].speed_um_per_kilostep
    good = names == ["displaced", "displaced"] and abs(ratio - claim["value"]) <= claim["tolerance"]
    slowest = min(speeds, key=speeds.get) if speeds else None
    note = (
        f"slowest displaced cell of this row shift: Ca = {slowest:g}, "
        f"{speeds[slowest] / rows[0.1].speed_um_per_kilostep:.2f} of the speed at Ca = 0.1"
        if slowest
        else ""
    )
    text = f"speed ratio {ratio:.2f}; Ca = 0.1 {names[0]}, Ca = 0.3 {names[1]}"
    runs = (rows[0.1].run, rows[0.3].run)
    return Finding(bool(good), text, note, near_boundary(tables, 6.0), runs)


@check("a-priori")
def a_priori(tables, claim, _):
    table = at_paper_lattice(tables["a_priori"].rename(columns={"class": "label"}))
    rows = table[(table.sweep == SWEEP) & table.right_tweezer.notna()]
    rows = rows[rows.capillary_number.between(PAPER_RANGE[0] - 1e-9, PAPER_RANGE[1] + 1e-9)]
    if len(rows) < 50:
        return None
    wrong = rows[rows.right_tweezer == 0]
    distance = (wrong.tweezer_um / (2 * wrong.s_um) - 1).abs()
    good = bool((distance <= claim["tolerance"]).all())
    text = f"{len(rows) - len(wrong)} of {len(rows)} classes right"
    if len(wrong):
        text += f"; misses with the tweezer's diameter {ranged(100 * distance, '.0f')} % off 2 s"
    names = {"tweezer_printed_law": "Eq. (4)", "d_perp": "D_perp > 2 s", "centre": "centre > s"}
    rates = {rule: rows[f"right_{rule}"].dropna() for rule in names}
    note = "; ".join(f"{names[rule]}: {100 * rate.mean():.0f} %" for rule, rate in rates.items() if len(rate))
    return Finding(good, text, note, "", runs_of(rows))
