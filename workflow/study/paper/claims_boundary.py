"""Checks of the claims on the boundary of the phase space: its law, the cell next to it, the prediction."""

import numpy as np

from study.analysis.boundary import PARAMETERS, UNDISPUTED, law
from study.paper.claims import (
    PAPER_RANGE,
    SERIES,
    SWEEP,
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
from study.paper.claims_classes import OTHERS, near_boundary
from study.planning.brackets import FROM_CELLS
from study.planning.classes import DECIDED

ENOUGH_CELLS = 40  # a third of the paper's phase space


def fitted(tables, name):
    """(a, b, c) of a fit of the boundary and their rows; None if it was not made."""
    rows = tables["fits"]
    rows = rows[rows.name == f"boundary/{name}"].set_index("parameter")
    if not set(PARAMETERS) <= set(rows.index):
        return None
    return rows.loc[list(PARAMETERS)]


def agrees_with_text(boundary, statements):
    """Are the cells displaced up to, and zigzag from, the capillary numbers that the text states, at every
    row shift of which it says something?"""
    for said in statements:
        rows = at_row_shift(boundary, said["row_shift_um"])
        if rows.empty:
            return False
        displaced, zigzag = rows[UNDISPUTED].iloc[0]
        if said["displaced_to"] is not None and not displaced >= said["displaced_to"]:
            return False
        if said["zigzag_from"] is not None and not zigzag <= said["zigzag_from"]:
            return False
    return True


@check("phase-boundary")
def phase_boundary(tables, claim, _):
    found, boundary = fitted(tables, SERIES), at_paper_lattice(tables["phase_boundary"])
    boundary = boundary[boundary.series == SERIES]
    if boundary.empty:
        return None
    if found is None:
        raise Undecidable(f"brackets at {len(boundary)} row shifts do not fix the three coefficients")
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
    if (boundary.status == FROM_CELLS).any():
        note = "; ".join(filter(None, (f"boundary {FROM_CELLS}, without brackets", note)))
    runs = runs_of(boundary.rename(columns={"runs": "run"}))
    off = distance(found)
    holding = statements_that_hold(claim, lambda _: agrees_with_text(boundary, claim["statements"]))
    return Finding(off <= claim["tolerance"], text(found), note, f"95 %: {interval}", runs, off, holding)


@check("slow-near-boundary")
def slow_near_boundary(tables, claim, _):
    rows = {float(row.capillary_number): row for row in at_row_shift(grid(tables), 6.0).itertuples()}
    if not {0.1, 0.3} <= set(rows):
        return None
    pair = [rows[ca] for ca in (0.1, 0.3)]
    names, displaced = [row.label for row in pair], all(row.label == "displaced" for row in pair)
    if set(names) - set(DECIDED) and "zigzag" not in names:
        raise Undecidable(f"Ca = 0.1 {names[0]}, Ca = 0.3 {names[1]}")
    speeds = {ca: row.speed_um_per_kilostep for ca, row in rows.items() if row.label == "displaced"}
    ratio = rows[0.3].speed_um_per_kilostep / rows[0.1].speed_um_per_kilostep
    if displaced and np.isnan(ratio):
        return None  # classes from a bracket have no speed
    slowest = min(speeds, key=speeds.get) if speeds else None
    note = (
        f"slowest displaced cell of this row shift: Ca = {slowest:g}, "
        f"{speeds[slowest] / rows[0.1].speed_um_per_kilostep:.2f} of the speed at Ca = 0.1"
        if slowest
        else ""
    )
    off = abs(ratio - claim["value"])
    text = f"speed ratio {ratio:.2f}; Ca = 0.1 {names[0]}, Ca = 0.3 {names[1]}"
    difference = float(off) if displaced else None
    runs = tuple(row.run for row in pair)
    good = bool(displaced and off <= claim["tolerance"])
    return Finding(good, text, note, near_boundary(tables, 6.0), runs, difference)


@check("a-priori")
def a_priori(tables, claim, _):
    table = at_paper_lattice(tables["a_priori"].rename(columns={"class": "label"}))
    rows = table[(table.sweep == SWEEP) & table.right_tweezer.notna()]
    rows = rows[rows.capillary_number.between(PAPER_RANGE[0] - 1e-9, PAPER_RANGE[1] + 1e-9)]
    if len(rows) < ENOUGH_CELLS:
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
    farthest = float(100 * distance.max()) if len(wrong) else 0.0
    return Finding(good, text, note, "", runs_of(rows), farthest)
