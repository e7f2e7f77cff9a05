"""Checks of the paper's claims: each takes the tables and the claim and says what was measured.

A check returns a Finding, or None where this tier lacks the runs. The verdict is on the paper's own method at
its own lattice (variant `paper`, sweep `figure-6`, 0.4 um); refined values stand in the note. A claim that
does not come out is a result.
"""

import math
from dataclasses import dataclass

import numpy as np

from study.fits import chi_squared
from study.plan import read_json

LATTICE_UM = 0.4
SWEEP = "figure-6"
CAPILLARY_NUMBERS = [0.1, 0.3, 0.5, 0.7, 1.2]
CHECKS = {}


@dataclass(frozen=True)
class Finding:
    """Outcome of a check: does the claim come out, what was measured, what else there is to say."""

    reproduced: bool
    measured: str
    note: str = ""


def load_claims(path):
    """Claims by id."""
    return {claim["id"]: claim for claim in read_json(path)["claims"]}


def check(claim_id):
    """Registers the function below as the check of a claim."""

    def register(function):
        CHECKS[claim_id] = function
        return function

    return register


def at_paper_lattice(rows):
    """The rows whose lattice spacing is the paper's."""
    return rows[rows.dx_um.sub(LATTICE_UM).abs() < 1e-3]


def flow_rows(tables, variant="paper"):
    """Converged rows of a variant of the flow; none in tiers where `paper` is not at the paper's lattice."""
    table = tables["streamline_separation"]
    rows = table[table.status == "converged"]
    paper = at_paper_lattice(rows[rows.variant == "paper"])
    return rows[rows.variant == variant] if len(paper) else paper


def ranged(values, style):
    """Text of a range of values."""
    low, high = format(min(values), style), format(max(values), style)
    return low if low == high else f"{low} ... {high}"


@check("stokes-linear")
def stokes_linear(tables, claim, _):
    rows = at_paper_lattice(tables["stokes_checks"])
    if len(rows) < 3:
        return None
    changes = rows.relative_change.abs()
    growing = (rows.relative_change > 0).sum()
    note = f"an increase at {growing} of {len(rows)} row shifts, else a decrease; the text says increase"
    return Finding(bool(changes.max() < claim["value"]), ranged(changes, ".1e"), note)


@check("stokes-mirror")
def stokes_mirror(tables, claim, _):
    rows = at_paper_lattice(tables["stokes_checks"])
    if len(rows) < 3:
        return None
    worst = rows.reversal_max_high.max()
    shift = (rows.s_um_high - rows.s_upper_um_high).abs().max()
    note = f"upstream and downstream separatrix differ by {shift:.3f} um at most"
    return Finding(bool(worst < claim["tolerance"]), f"{worst:.1e} of the largest speed", note)


@check("reynolds")
def reynolds(tables, claim, _):
    rows = flow_rows(tables)
    if rows.empty:
        return None
    value, slit = rows.reynolds_number.mean(), rows.reynolds_number_slit.mean()
    note = f"slit without pillars {slit:.2f}, superficial mean {rows.reynolds_number_superficial.mean():.2f}"
    return Finding(abs(value - claim["value"]) <= claim["tolerance"], f"{value:.3f} (fluid mean)", note)


@check("resistance")
def resistance(tables, claim, _):
    values = flow_rows(tables).resistance_Pa_s_per_m2
    if len(values) < 8:
        return None
    mean = values.mean()
    spread = (values / mean - 1).abs().max()
    good = abs(mean - claim["value"]["mean"]) <= claim["tolerance"]["mean"]
    refined = flow_rows(tables, "refined").resistance_Pa_s_per_m2
    note = f"refined: {refined.mean():.3e}" if len(refined) else ""
    text = f"{mean:.3e}, same to {100 * spread:.2f} %"
    return Finding(bool(good and spread <= claim["tolerance"]["spread"]), text, note)


@check("device-pressure")
def device_pressure(tables, claim, _):
    values = flow_rows(tables).resistance_Pa_s_per_m2
    if values.empty:
        return None
    pressure = values.mean() * 1e-3 * 30e-3 / 1e5
    return Finding(bool(abs(pressure - claim["value"]) <= claim["tolerance"]), f"{pressure:.3f} bar")


@check("table-1")
def table_1(tables, claim, _):
    def found(variant):
        rows = flow_rows(tables, variant)
        return {f"{d:.1f}": s for d, s in zip(rows.row_shift_um, rows.s_um, strict=True)}

    printed, measured = claim["value"], found("paper")
    if set(printed) - set(measured):
        return None

    def listed(values):
        return ", ".join(f"{values[d]:.2f}" for d in printed if d in values)

    worst = max(abs(measured[d] - printed[d]) for d in printed)
    note = f"accurate: {listed(found('accurate'))}; refined: {listed(found('refined'))}"
    return Finding(worst <= claim["tolerance"], f"{listed(measured)}; off by {worst:.2f} at most", note)


@check("separation-law")
def separation_law(tables, claim, _):
    if len(flow_rows(tables)) < 8:
        return None
    fits = tables["fits"].set_index(["name", "parameter"])

    def law(variant):
        return {key: fits.loc[(f"separation-law/{variant}", key)] for key in claim["value"]}

    def text(found):
        return ", ".join(f"{key} = {row.value:.3f} +- {row.std_error:.3f}" for key, row in found.items())

    measured = law("paper")
    good = all(
        abs(row.value - claim["value"][key]) <= claim["tolerance"][key] for key, row in measured.items()
    )
    others = [
        name
        for name in ("accurate", "refined", "printed-table")
        if (f"separation-law/{name}", "B") in fits.index
    ]
    return Finding(bool(good), text(measured), "; ".join(f"{name}: {text(law(name))}" for name in others))


@check("unit-conversion")
def unit_conversion(tables, claim, _):
    if flow_rows(tables).empty:
        return None
    table, worst, measured = tables["units"], 0.0, []
    for key in ("pressure_gradient_bar_per_m", "mean_velocity_mm_per_s"):
        rows = table[table.source == "l = sqrt(G H), resistance of paper"].sort_values("capillary_number")
        worst = max(worst, *np.abs(rows[key].to_numpy() / np.array(claim["value"][key]) - 1))
        measured.append(ranged(rows[key], ".3f"))
    text = f"p' = {measured[0]} bar/m, u = {measured[1]} mm/s"
    note = (
        "l = H instead of sqrt(G H) nearly gives the printed p'; the printed p' and u agree with each other"
    )
    return Finding(bool(worst <= claim["tolerance"]), text, note)


@check("cell-area")
def cell_area(tables, claim, _):
    rows = tables["stretching"]
    areas = rows[rows.mesh_frequency == 10].area_over_radius_squared.dropna()
    if areas.empty:
        return None
    area = areas.iloc[0]
    return Finding(bool(abs(area - claim["value"]) <= claim["tolerance"]), f"{area:.4f}", "continuum 8.771")


@check("tweezer")
def tweezer(tables, claim, experiment):
    table = tables["stretching"]
    table = table[(table.method == "static") & (table.mesh_frequency == 10) & (table.status == "converged")]
    points = experiment[
        (experiment.set == "SURESH2005_FIG7") & (experiment.F_pN > 0) & (experiment.F_pN <= 100)
    ]

    def deviations(curve):
        for simulated, value, error in (
            ("axial_um", "DA_um", "DA_err_um"),
            ("transverse_um", "DT_um", "DT_err_um"),
        ):
            force, length = curve.force_pN.to_numpy(), curve[simulated].to_numpy()
            yield max(
                chi_squared(force, length, [p]) ** 0.5 for p in points[["F_pN", value, error]].to_numpy()
            )

    found = {k: tuple(deviations(curve)) for k, curve in table.groupby("skalak_denominator")}
    if 12 not in found:
        return None
    axial, transverse = found[12]
    note = "; ".join(f"k = {k:g}: {a:.1f}, {t:.1f}" for k, (a, t) in found.items() if k != 12)
    text = f"axial {axial:.2f}, transverse {transverse:.2f} error bars off at most"
    return Finding(bool(max(axial, transverse) <= claim["tolerance"]), text, f"other denominators: {note}")


def passages(tables, row_shift_um):
    """Rows of the sweep of Fig. 6 at one row shift by capillary number; empty on another lattice."""
    table = tables["passages"].rename(columns={"class": "label"})
    near = table.row_shift_um.sub(row_shift_um).abs() < 1e-6
    rows = table[near & (table.sweep == SWEEP) & (table.dx_um.sub(LATTICE_UM).abs() < 1e-3)]
    return {float(row.capillary_number): row for row in rows.itertuples()}


def classes_as(row_shift_um, zigzag_from, note=""):
    """Check that exactly the cells with Ca above `zigzag_from` zigzag and the others are displaced."""

    def function(tables, claim, _):
        rows = passages(tables, row_shift_um)
        if not set(CAPILLARY_NUMBERS) <= set(rows):
            return None
        measured = {ca: rows[ca].label for ca in CAPILLARY_NUMBERS}
        expected = {ca: "zigzag" if ca > zigzag_from else "displaced" for ca in CAPILLARY_NUMBERS}
        return Finding(
            measured == expected, ", ".join(f"{ca}: {name}" for ca, name in measured.items()), note
        )

    return function


check("eps-5-all-displaced")(classes_as(2.0, math.inf))
check("eps-11-soft-zigzag")(classes_as(4.4, 1.0))
check("eps-17-stiff-displaced")(classes_as(6.8, 0.2))
check("eps-20-22-all-zigzag")(classes_as(8.8, 0.0, "examined at 22/80 only"))


@check("slow-near-boundary")
def slow_near_boundary(tables, claim, _):
    rows = passages(tables, 6.0)
    if not {0.1, 0.3} <= set(rows):
        return None
    names = [rows[ca].label for ca in (0.1, 0.3)]
    ratio = rows[0.3].speed_um_per_kilostep / rows[0.1].speed_um_per_kilostep
    good = names == ["displaced", "displaced"] and abs(ratio - claim["value"]) <= claim["tolerance"]
    return Finding(bool(good), f"speed ratio {ratio:.2f}; Ca = 0.1 {names[0]}, Ca = 0.3 {names[1]}")


@check("d-perp-6.8")
def d_perp(tables, claim, _):
    rows = passages(tables, 6.8)
    common = [ca for ca in claim["value"] if float(ca) in rows]
    if not common:
        return None
    measured = {ca: rows[float(ca)].d_perp_um for ca in common}
    good = all(abs(measured[ca] - claim["value"][ca]) <= claim["tolerance"] for ca in common)
    good = good and all(rows[float(ca)].label == "zigzag" for ca in common)
    text = ", ".join(f"{ca}: {value:.2f} ({rows[float(ca)].label})" for ca, value in measured.items())
    missing = [ca for ca in claim["value"] if ca not in common]
    return Finding(bool(good), text, f"not run at Ca = {', '.join(missing)}" if missing else "")
