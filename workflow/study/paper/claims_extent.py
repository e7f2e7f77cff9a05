"""Checks of the claims on the lateral extent D_perp of a cell: at d = 6.8 um, against the law of separation,
on one curve, next to the pillar, as in the tweezer, with inertia."""

import numpy as np

from study.analysis.tweezer import TweezerCurve
from study.paper.claims import (
    LATTICE_UM,
    SWEEP,
    Finding,
    Undecidable,
    at_paper_lattice,
    at_row_shift,
    check,
    grid,
    ranged,
    runs_of,
)
from study.paper.claims_boundary import ENOUGH_CELLS
from study.planning.classes import DECIDED

DENOMINATOR = 12  # default of the study
INSIDE, OUTSIDE = 4, 3  # row shifts that tell of a window: two thirds of the paper's at least


def lattice_error(tables, rows):
    """Largest change of D_perp between the paper's lattice and the finer one at common points, in words."""
    table = tables["passages"]
    fine = (
        table[table.sweep == "grid-refined"]
        .set_index(["row_shift_um", "capillary_number"])
        .d_perp_um.dropna()
    )
    coarse = rows.set_index(["row_shift_um", "capillary_number"]).d_perp_um.dropna()
    common = fine.index.intersection(coarse.index)
    if common.empty:
        return ""
    return f"change on the finer lattice {ranged(fine[common] - coarse[common], '+.2f')} um"


def split_by_window(rows, window):
    """Rows with D_perp at row shifts within the window, and those outside."""
    rows = rows[rows.d_perp_um.notna()]
    inside = rows.row_shift_um.between(window[0] - 1e-6, window[1] + 1e-6)
    return rows[inside], rows[~inside]


@check("d-perp-6.8")
def d_perp(tables, claim, _):
    rows = {float(row.capillary_number): row for row in at_row_shift(grid(tables), 6.8).itertuples()}
    if not {float(ca) for ca in claim["value"]} <= set(rows):
        return None
    found = {ca: rows[float(ca)] for ca in claim["value"]}
    decided = {ca: row for ca, row in found.items() if row.label in DECIDED}
    if any(np.isnan(row.d_perp_um) for row in decided.values()):
        return None  # classes from a bracket have no D_perp
    off = max((abs(row.d_perp_um - claim["value"][ca]) for ca, row in decided.items()), default=0.0)
    right = all(row.label == ("displaced" if ca == "0.15" else "zigzag") for ca, row in decided.items())
    good = bool(right and off <= claim["tolerance"])
    if good and len(decided) < len(found):
        raise Undecidable(", ".join(f"{ca}: {row.label}" for ca, row in found.items()))
    text = ", ".join(f"{ca}: {row.d_perp_um:.2f} ({row.label})" for ca, row in found.items())
    centre = ", ".join(f"{ca}: {row.d_perp_at_centre_um:.2f}" for ca, row in found.items())
    sample = grid(tables)
    sample = sample[sample.run.isin([row.run for row in found.values()])]
    note = f"with the centre on the line: {centre}"
    difference = float(off) if right and len(decided) == len(found) else None
    return Finding(good, text, note, lattice_error(tables, sample), runs_of(sample), difference)


def misclassified(rows, printed, factor):
    """Share of cells on the wrong side of D_perp = factor * printed law."""
    displaced = rows.label == "displaced"
    return float((displaced != (rows.d_perp_um > factor * printed)).mean())


@check("sharp-separation")
def sharp_separation(tables, claim, _):
    rows = grid(tables)
    rows = rows[rows.label.isin(DECIDED) & rows.d_perp_um.notna()]
    if len(rows) < ENOUGH_CELLS:
        return None
    law = tables["a_priori"].drop_duplicates("run").set_index("run").printed_d_cr_um
    printed = rows.run.map(law)
    factors = np.round(np.arange(0.7, 1.4001, 0.005), 3)
    shares = np.array([misclassified(rows, printed, factor) for factor in factors])
    best = factors[shares == shares.min()]
    value, tolerance = claim["value"], claim["tolerance"]
    sharp = shares.min() <= tolerance["misclassified"]
    off = float(max(best.min() - value["factor"], value["factor"] - best.max(), 0.0))
    good = bool(sharp and off <= tolerance["factor"] * (1 + 1e-9))
    text = f"factor {ranged(best, '.3f')} with {100 * shares.min():.0f} % on the wrong side"
    one, given = misclassified(rows, printed, 1.0), misclassified(rows, printed, value["factor"])
    note = f"factor 1: {100 * one:.0f} %, factor {value['factor']}: {100 * given:.0f} % on the wrong side"
    difference = off if sharp else None
    return Finding(good, text, note, lattice_error(tables, rows), runs_of(rows), difference)


@check("collapse")
def collapse(tables, claim, _):
    inside, outside = split_by_window(grid(tables), claim["value"])
    if inside.row_shift_um.nunique() < INSIDE or outside.row_shift_um.nunique() < OUTSIDE:
        return None
    groups = inside.groupby("capillary_number").d_perp_um
    spread = (groups.max() - groups.min()).max()
    own = (inside.d_perp_um - inside.capillary_number.map(groups.mean())).abs().max()
    off = (outside.d_perp_um - outside.capillary_number.map(groups.mean())).abs()
    farthest = off.groupby(outside.row_shift_um).max()
    good = bool(spread <= claim["tolerance"] and (farthest > claim["tolerance"]).all())
    difference = float(spread) if farthest.min() > own else None
    text = f"spread within {spread:.2f} um; the others off their mean by up to {ranged(farthest, '.2f')} um"
    note = "; ".join(f"d = {shift:g}: {value:.2f}" for shift, value in farthest.items())
    error = lattice_error(tables, inside)
    runs = runs_of(inside, outside)
    return Finding(good, text, f"largest distance at {note}", error, runs, difference)


@check("open-symbols")
def open_symbols(tables, claim, _):
    rows = grid(tables)
    rows = rows[rows.film_um.notna()]
    low, high = claim["value"]
    far = (rows.row_shift_um <= low + 1e-6) | (rows.row_shift_um >= high - 1e-6)
    if rows[far].row_shift_um.nunique() < OUTSIDE or rows[~far].empty:
        return None
    films = rows[far].groupby("row_shift_um").film_um.min()
    thinnest = float(films.min())
    good = thinnest >= claim["tolerance"]
    difference = claim["tolerance"] - thinnest if thinnest > rows[~far].film_um.min() else None
    text = "thinnest film " + ", ".join(f"d = {shift:g}: {film:.2f}" for shift, film in films.items()) + " um"
    note = f"the other row shifts: {ranged(rows[~far].film_um, '.2f')} um"
    sure = f"lattice spacing {LATTICE_UM} um"
    return Finding(good, text, note, sure, runs_of(rows[far]), difference)


@check("tweezer-master-curve")
def tweezer_master_curve(tables, claim, _):
    inside, _outside = split_by_window(grid(tables), (3.6, 7.2))
    if inside.row_shift_um.nunique() < INSIDE:
        return None
    curve = TweezerCurve(tables["stretching"])

    def distances(denominator):
        mean = inside.groupby("capillary_number").d_perp_um.mean()
        return np.array([extent - curve.diameter(ca, denominator) for ca, extent in mean.items()])

    found = distances(DENOMINATOR)
    if np.isnan(found).all():
        return None  # no curve of this membrane
    if np.isnan(found).any():
        raise Undecidable("the tweezer curve or D_perp does not reach all capillary numbers")
    worst = float(np.abs(found).max())
    text = f"mean D_perp minus tweezer {ranged(found, '+.2f')} um, rms {np.sqrt((found**2).mean()):.2f} um"
    others = {
        k: distances(k) for k in sorted(set(tables["stretching"].skalak_denominator)) if k != DENOMINATOR
    }
    note = "cells with k = 12 against tweezer with " + "; ".join(
        f"k = {k:g}: {ranged(values, '+.2f')}" for k, values in others.items() if not np.isnan(values).any()
    )
    good = worst <= claim["tolerance"]
    return Finding(good, text, note, lattice_error(tables, inside), runs_of(inside), worst)


@check("inertia")
def inertia(tables, claim, _):
    table = at_paper_lattice(tables["passages"].rename(columns={"class": "label"}))
    keys = ["row_shift_um", "capillary_number"]
    full = table[table.sweep == "inertia"].set_index(keys)
    quarter = table[table.sweep == "inertia-quarter"].set_index(keys)
    stokes = table[table.sweep == SWEEP].set_index(keys)
    if full.empty or not full.index.equals(quarter.index):
        return None
    change = full.d_perp_um / quarter.d_perp_um - 1
    same = bool((full.label == quarter.label).all())
    good = same and bool((change.abs() <= claim["tolerance"]).all())
    text = f"D_perp changes by {ranged(100 * change, '+.2f')} % between a quarter and the whole of Re"
    text += ", same classes" if same else ", other classes"
    common = full.index.intersection(stokes.index)
    dropped = 100 * (full.d_perp_um[common] / stokes.d_perp_um[common] - 1)
    points = ", ".join(f"d = {shift:g} um, Ca = {ca:g}" for shift, ca in full.index)
    note = f"at {points} only"
    note += f"; against the Stokes equilibrium {ranged(dropped, '+.2f')} %" if len(common) else ""
    difference = float(100 * change.abs().max()) if same else None
    return Finding(good, text, note, runs=runs_of(full, quarter), difference=difference)
