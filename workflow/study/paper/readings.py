"""What the tables say under another reading of what the paper leaves open: a view of them for each reading.

A reading is a sweep of passages and a series of brackets, and where it changes them the flow without a cell
and the unit of the capillary number. In its view these stand under the names of the default reading, so that
every check of a claim is written once. Other sweeps and tables of the default stay only where they hold in
the reading too.
"""

import math

import numpy as np
import pandas as pd

from study.analysis.boundary import UNDISPUTED
from study.analysis.tweezer import TweezerCurve
from study.paper.claims import SERIES, SWEEP, VARIANT, at_paper_lattice, grid
from study.planning.classes import DECIDED

#: Columns of capillary numbers, by table.
CAPILLARY = {
    "passages": ["capillary_number"],
    "a_priori": ["capillary_number"],
    "critical_row_shift": ["capillary_number"],
    "phase_boundary": ["ca_displaced", "ca_zigzag", *UNDISPUTED],
}
DIGITS = 6  # a capillary number has four significant ones
POINT = ["row_shift_um", "capillary_number"]


def renamed(table, column, own, default):
    """The table with the rows of `own` under the name of the default's, which are left out."""
    if own == default:
        return table
    others = table[~table[column].isin([own, default])]
    return pd.concat([table[table[column] == own].assign(**{column: default}), others])


def in_printed_numbers(tables, factor):
    """The tables by printed capillary numbers: a run at Ca is one at Ca / factor of the print, a rate per Ca
    is as much larger, and so are the pressure and the speed that belong to a printed Ca."""
    if factor == 1:
        return tables
    found = dict(tables)
    for name, columns in CAPILLARY.items():
        found[name] = tables[name].assign(**(tables[name][columns] / factor).round(DIGITS))
    fits = tables["fits"].copy()
    rates = fits.name.str.startswith("boundary/") & (fits.parameter == "rate")
    fits.loc[rates, ["value", "std_error", "low", "high"]] *= factor
    units = tables["units"].copy()
    per_number = ["pressure_gradient_bar_per_m", "mean_velocity_mm_per_s"]
    units.loc[units.source != "printed", per_number] *= factor
    return found | {"fits": fits, "units": units}


def points_of(rows):
    """(row shift, capillary number) of every row."""
    return list(zip(rows.row_shift_um.round(DIGITS), rows.capillary_number.round(DIGITS), strict=True))


def class_within(bracket, capillary):
    """The class that a bracket tells of a capillary number: displaced up to its lower end, zigzag from its
    upper one; None between them and beyond what was tried."""
    displaced, zigzag = bracket[UNDISPUTED]
    if capillary <= displaced + 1e-9:
        return "displaced"
    return "zigzag" if capillary >= zigzag - 1e-9 else None


def told_by_brackets(points, boundary):
    """Rows without D_perp for the points whose class follows from a bracket; its runs stand behind them."""
    brackets = {round(row.row_shift_um, DIGITS): row for _, row in boundary.iterrows()}
    for shift, capillary in points:
        bracket = brackets.get(shift)
        label = None if bracket is None else class_within(bracket, capillary)
        if label:
            row = {"sweep": SWEEP, "row_shift_um": shift, "capillary_number": capillary, "class": label}
            yield row | {"dx_um": bracket.dx_um, "run": bracket.runs}


def passages_in(tables, reading, cells):
    """Passages of the reading as sweep `grid`: its sweep; where that lacks a cell of the default's phase
    space, the run of a bracket with just its numbers; else the class that the bracket tells."""
    table, sweep = tables["passages"], reading.get("sweep")
    own = table[table.sweep == sweep]
    known = set(points_of(at_paper_lattice(own)))
    wanted = [point for point in points_of(cells) if point not in known]
    tried = at_paper_lattice(table[table.sweep == f"boundary/{reading['series']}"])
    at_cell = np.array([point in wanted for point in points_of(tried)], dtype=bool)
    tried = tried[at_cell].drop_duplicates(POINT)
    known |= set(points_of(tried))
    boundary = at_paper_lattice(tables["phase_boundary"])
    boundary = boundary[boundary.series == reading["series"]]
    rest = [point for point in wanted if point not in known]
    told = pd.DataFrame(list(told_by_brackets(rest, boundary)))
    beside = table[table.sweep != SWEEP] if sweep == SWEEP else table[:0]
    parts = [own.assign(sweep=SWEEP), tried.assign(sweep=SWEEP), told, beside]
    found = pd.concat([part for part in parts if len(part)] or [table[:0]], ignore_index=True)
    return found.reindex(columns=table.columns)


def predicted(rows, tweezer):
    """Rows of the predictions with those of a tweezer's curve: `displaced` where the diameter is larger than
    2 s. Without a curve there is none."""
    diameters = [
        tweezer.diameter(row.capillary_number, row.skalak_denominator) if tweezer else math.nan
        for row in rows.itertuples()
    ]
    rows = rows.assign(tweezer_um=diameters)
    judged = rows["class"].isin(DECIDED) & rows.tweezer_um.notna() & rows.s_um.notna()
    right = (rows.tweezer_um > 2 * rows.s_um) == (rows["class"] == "displaced")
    return rows.assign(right_tweezer=right.astype(float).where(judged))


def predictions_in(tables, reading, passages):
    """The predictions for the passages of the reading, as sweep `grid`."""
    table = tables["a_priori"]
    runs = passages[passages.sweep == SWEEP].run
    sweeps = [reading.get("sweep"), f"boundary/{reading['series']}"]
    rows = table[table.sweep.isin(sweeps) & table.run.isin(runs)]
    rows = rows.drop_duplicates("run").assign(sweep=SWEEP)
    if "bending_law" in reading:
        return predicted(rows, None)
    # The tweezer's own capillary number is no matter of the flow, so only the array's is another.
    return predicted(rows, TweezerCurve(tables["stretching"])) if "capillary_factor" in reading else rows


def flow_in(tables, reading):
    """Tables of the flow without a cell, with the variant of the reading in the place of `paper`; what was
    made with the default's flow alone is left out."""
    variant = reading.get("flow_variant", VARIANT)
    fits = renamed(tables["fits"], "name", f"boundary/{reading['series']}", f"boundary/{SERIES}")
    fits = renamed(fits, "name", f"separation-law/{variant}", f"separation-law/{VARIANT}")
    flow = renamed(tables["streamline_separation"], "variant", variant, VARIANT)
    found = {"fits": fits, "streamline_separation": flow}
    if variant != VARIANT:
        found |= {name: tables[name][:0] for name in ("stokes_checks", "units")}
    return found


def view(tables, reading):
    """The tables as the checks of the claims have to see them in a reading. `cells` are the points of the
    phase space that the paper's claims are about: those of the default's sweep, whatever the reading has.
    """
    cells = grid(tables)[POINT]
    tables = in_printed_numbers(tables, reading.get("capillary_factor", 1))
    passages = passages_in(tables, reading, cells)
    found = {"cells": cells, "passages": passages} | flow_in(tables, reading)
    found["a_priori"] = predictions_in(tables, reading, passages)
    found["phase_boundary"] = renamed(tables["phase_boundary"], "series", reading["series"], SERIES)
    if reading["series"] != SERIES:
        found["critical_row_shift"] = tables["critical_row_shift"][:0]
    if "bending_law" in reading:
        # Its cell was not stretched: only the mesh at rest, the same for all, is left of the tweezer.
        found["stretching"] = tables["stretching"].assign(method="another membrane")
    return tables | found
