"""What the report sets beside a verdict or a passage: figure and table of every claim, the words for a
set of runs, the class that the paper states, 2 s and the pressure gradient of a healthy cell."""

import numpy as np

from study.analysis.boundary import printed_class

#: Figure and table on which the verdict of a claim rests.
EVIDENCE = {
    "phase-boundary": ("fig07", "phase_boundary"),
    "eps-5-all-displaced": ("fig06", "passages"),
    "eps-11-soft-zigzag": ("fig06", "passages"),
    "eps-13-zigzag": ("fig07", "passages"),
    "eps-17-stiff-displaced": ("fig06", "passages"),
    "eps-20-22-all-zigzag": ("fig06", "passages"),
    "window": ("fig07", "passages"),
    "design-example": ("fig07", "phase_boundary"),
    "slow-near-boundary": ("fig_speed", "passages"),
    "d-perp-6.8": ("fig08", "passages"),
    "collapse": ("fig10", "passages"),
    "tweezer-master-curve": ("fig10", "stretching"),
    "sharp-separation": ("fig09", "passages"),
    "a-priori": ("fig_a_priori", "a_priori"),
    "open-symbols": ("fig_film", "passages"),
    "tweezer": ("fig05", "stretching_comparison"),
    "separation-law": ("table01", "fits"),
    "table-1": ("table01", "streamline_separation"),
    "resistance": ("fig04", "streamline_separation"),
    "stokes-linear": ("fig04", "stokes_checks"),
    "stokes-mirror": ("fig04", "stokes_checks"),
    "inertia": ("fig10", "passages"),
    "reynolds": ("fig04", "stokes_checks"),
    "device-pressure": ("fig04", "units"),
    "cell-area": ("fig03", "stretching"),
    "unit-conversion": ("fig04", "units"),
}
#: Sweeps that are no reading of the claims, in words.
SWEEPS = {
    "animation": "The cells of the animations",
    "full-height-tilted": "Full height, started tilted",
    "inertia": "Inertia: the paper's force",
    "inertia-quarter": "Inertia: a quarter of the paper's force",
    "row-shift-0.4": "critical row shift at Ca = 0.4",
    "second-start": "Cells of the grid, started in the middle of the gap",
}
GRID = "The grid: every row shift with every capillary number"
SEARCH = "boundary/"


def set_in_words(sweep, dx_um, lateral_flow, readings):
    """What a set of runs is, for somebody who has not read the study: sweep or series, lattice, flow."""
    found = {}
    for one in readings:  # several readings may judge the same runs; they are named after the first
        for name in (one.get("sweep"), one.get("series")):
            found.setdefault(name, one["description"])
    name = sweep.removeprefix(SEARCH)
    words = found.get(
        name,
        SWEEPS.get(
            name, name.replace("sensitivity/", "one choice changed, ").replace("/", " ").replace("_", " ")
        ),
    )
    if sweep.startswith(SEARCH):
        words = f"Search for the boundary: {words}"
    elif sweep == "grid":
        words = GRID
    words = words[0].upper() + words[1:]
    flow = "" if lateral_flow == "free" else ", no net lateral flow"
    return f"{words} (lattice {dx_um:.3g} um{flow})"


def linked(verdicts, figures, tables, runs):
    """The verdicts with the figure, the table and the runs of each that the page has, and their number."""
    for row in verdicts:
        figure, table = EVIDENCE.get(row["id"], (None, None))
        named = str(row.get("runs", "")).split()
        known = [run for run in named if run in runs]
        links = {"figure": figure if figure in figures else None, "table": table if table in tables else None}
        yield row | links | {"shown_runs": known, "runs_count": len(named)}


def by_row_shift(separation):
    """{row shift in um: 2 s in um} of the flow with the walls of the passages where it was made."""
    if separation is None or separation.empty:
        return {}
    variants = list(separation.variant)
    wanted = next((name for name in ("accurate-0.4", "accurate") if name in variants), variants[0])
    rows = separation[separation.variant == wanted]
    return {round(shift, 3): 2 * s for shift, s in zip(rows.row_shift_um, rows.s_um, strict=True) if s == s}


def pressure_per_capillary(units):
    """Pressure gradient of a healthy cell in bar/m at Ca = 1 by the definition of Ca, l = sqrt(G H)."""
    if units is None or units.empty:
        return None
    rows = units.dropna(subset=["capillary_number", "pressure_gradient_bar_per_m"])
    rows = rows[np.isclose(rows.length_scale_um, rows.length_scale_um.max())]
    ratios = rows.pressure_gradient_bar_per_m / rows.capillary_number
    return float(ratios.median()) if len(ratios) else None


def beside_print(points, statements, separation, units):
    """The points with the printed class, 2 s (um) and the pressure gradient (bar/m), None where unknown."""
    doubled, slope = by_row_shift(separation), pressure_per_capillary(units)
    for point in points:
        point["printed"] = printed_class(statements, point["d"], point["ca"])
        point["two_s_um"] = None if point["d"] not in doubled else round(doubled[point["d"]], 3)
        point["pressure"] = None if slope is None else float(f"{slope * point['ca']:.3g}")
    return points
