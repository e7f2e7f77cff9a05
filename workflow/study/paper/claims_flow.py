"""Checks of the claims on the flow without cells, on units and on the optical tweezer."""

import math

import numpy as np

from study.numerics.fits import chi_squared
from study.paper.claims import (
    Finding,
    Undecidable,
    at_paper_lattice,
    check,
    deviation,
    ranged,
    runs_of,
    statements_that_hold,
)


def flow_rows(tables, variant="paper"):
    """Converged rows of a variant of the flow; none in tiers where `paper` is not at the paper's lattice.

    Undecidable if a flow of `paper` did not converge.
    """
    table = tables["streamline_separation"]
    paper = at_paper_lattice(table[table.variant == "paper"])
    failed = paper[paper.status != "converged"]
    if len(failed):
        raise Undecidable(f"the flow at d = {failed.row_shift_um.iloc[0]:g} um did not converge")
    rows = table[(table.variant == variant) & (table.status == "converged")]
    return rows if len(paper) else paper


def stokes_rows(tables):
    """The Stokes checks on the paper's lattice; Undecidable if a flow diverged."""
    rows = at_paper_lattice(tables["stokes_checks"])
    failed = rows[rows.relative_change.isna()]
    if len(failed):
        raise Undecidable(f"a flow at d = {failed.row_shift_um.iloc[0]:g} um diverged")
    return rows


def pair_runs(rows):
    """Runs behind rows of the Stokes checks."""
    return tuple(run for cell in rows.runs.dropna() for run in cell.split()) if "runs" in rows else ()


@check("stokes-linear")
def stokes_linear(tables, claim, _):
    rows = stokes_rows(tables)
    if len(rows) < 3:
        return None
    changes = rows.relative_change.abs()
    growing = (rows.relative_change > 0).sum()
    note = f"an increase at {growing} of {len(rows)} row shifts, else a decrease; the paper says increase"
    largest = float(changes.max())
    good = largest < claim["value"]
    return Finding(good, ranged(changes, ".1e"), note, "1e-9", pair_runs(rows), 100 * largest)


@check("stokes-mirror")
def stokes_mirror(tables, claim, _):
    rows = stokes_rows(tables)
    if len(rows) < 3:
        return None
    worst = rows.reversal_max_high.max()
    shift = (rows.s_um_high - rows.s_upper_um_high).abs().max()
    note = f"upstream and downstream separatrix differ by {shift:.3f} um at most"
    good, text = bool(worst < claim["tolerance"]), f"{worst:.1e} of the largest speed"
    return Finding(good, text, note, runs=pair_runs(rows), difference=float(shift))


@check("reynolds")
def reynolds(tables, claim, _):
    rows = flow_rows(tables)
    if rows.empty:
        return None
    value, slit = rows.reynolds_number.mean(), rows.reynolds_number_slit.mean()
    note = f"slit without pillars {slit:.2f}, superficial mean {rows.reynolds_number_superficial.mean():.2f}"
    return Finding(
        bool(abs(value - claim["value"]) <= claim["tolerance"]),
        f"{value:.3f} (fluid mean)",
        note,
        runs=runs_of(rows),
        difference=float(deviation(value, claim["value"])),
        holding=statements_that_hold(claim, lambda said: abs(value - said["value"]) <= said["tolerance"]),
    )


@check("resistance")
def resistance(tables, claim, _):
    rows = flow_rows(tables)
    values = rows.resistance_Pa_s_per_m2
    if len(values) < 8:
        return None
    mean = values.mean()
    spread = (values / mean - 1).abs().max()
    good = abs(mean - claim["value"]["mean"]) <= claim["tolerance"]["mean"]
    refined = flow_rows(tables, "refined")
    note = f"refined: {refined.resistance_Pa_s_per_m2.mean():.3e}" if len(refined) else ""
    text = f"{mean:.3e}, same to {100 * spread:.2f} %"
    error = abs(mean - refined.resistance_Pa_s_per_m2.mean()) if len(refined) else math.nan
    same = spread <= claim["tolerance"]["spread"]
    off = float(deviation(mean, claim["value"]["mean"])) if same else None
    return Finding(bool(good and same), text, note, f"{error:.1e} (lattice)", runs_of(rows), off)


@check("device-pressure")
def device_pressure(tables, claim, _):
    rows = flow_rows(tables)
    if rows.empty:
        return None
    pressure = rows.resistance_Pa_s_per_m2.mean() * 1e-3 * 30e-3 / 1e5
    good = bool(abs(pressure - claim["value"]) <= claim["tolerance"])
    off = float(deviation(pressure, claim["value"]))
    return Finding(good, f"{pressure:.3f} bar", runs=runs_of(rows), difference=off)


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
    errors = flow_rows(tables, "refined").s_uncertainty_um.dropna()
    error = f"refined: +- {errors.max():.3f}" if len(errors) else ""
    text = f"{listed(measured)}; off by {worst:.2f} at most"
    return Finding(worst <= claim["tolerance"], text, note, error, runs_of(flow_rows(tables)), worst)


def largest_deviation(found, printed, epsilon):
    """How far a law of separation is from the printed one at most within a range of eps, per cent."""
    at = np.linspace(epsilon.min(), epsilon.max(), 101)
    ratio = found["A_um"] / printed["A_um"] * at ** (found["B"] - printed["B"])
    return float(100 * np.abs(ratio - 1).max())


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
    note = "; ".join(f"{name}: {text(law(name))}" for name in others)
    intervals = [
        f"{key}: {row.low:.3f} ... {row.high:.3f}" for key, row in measured.items() if row.low == row.low
    ]
    error = "95 %: " + ", ".join(intervals) if intervals else ""
    found = {key: row.value for key, row in measured.items()}
    off = largest_deviation(found, claim["value"], flow_rows(tables).epsilon)
    return Finding(bool(good), text(measured), note, error, runs_of(flow_rows(tables)), off)


@check("unit-conversion")
def unit_conversion(tables, claim, _):
    table = tables["units"]
    rows = table[table.source == "l = sqrt(G H), resistance of paper"].sort_values("capillary_number")
    if flow_rows(tables).empty or rows.empty:
        return None
    keys = ("pressure_gradient_bar_per_m", "mean_velocity_mm_per_s")

    def off(printed):
        return max(np.abs(rows[key].to_numpy() / np.array(printed[key]) - 1).max() for key in printed)

    worst = off({key: claim["value"][key] for key in keys})
    measured = [ranged(rows[key], ".3f") for key in keys]
    text = f"p' = {measured[0]} bar/m, u = {measured[1]} mm/s"
    note = (
        "l = H instead of sqrt(G H) nearly gives the printed p'; the printed p' and u agree with each other"
    )
    holding = statements_that_hold(claim, lambda said: off(said["value"]) <= said["tolerance"])
    good = bool(worst <= claim["tolerance"])
    return Finding(good, text, note, runs=runs_of(flow_rows(tables)), holding=holding)


@check("cell-area")
def cell_area(tables, claim, _):
    rows = tables["stretching"]
    rows = rows[(rows.mesh_frequency == 10) & rows.area_over_radius_squared.notna()]
    if rows.empty:
        return None
    area = rows.area_over_radius_squared.iloc[0]
    good = bool(abs(area - claim["value"]) <= claim["tolerance"])
    off = float(deviation(area, claim["value"]))
    return Finding(good, f"{area:.4f}", "continuum 8.771", "rounding", runs_of(rows.head(1)), off)


@check("tweezer")
def tweezer(tables, claim, experiment):
    table = tables["stretching"]
    table = table[(table.method == "static") & (table.mesh_frequency == 10)]
    if len(table) and not (table.status == "converged").all():
        raise Undecidable("a shape of the tweezer was not found to the wanted tolerance")
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
    worst = float(max(axial, transverse))
    note = f"other denominators: {note}"
    return Finding(worst <= claim["tolerance"], text, note, runs=runs_of(table), difference=worst)
