"""What a check of a claim is: a function of the tables and the claim that says what was measured.

A check returns a Finding, or None where the runs for it are missing; it raises Undecidable where they are
there and do not tell. It knows the names of the default reading alone: variant `paper` of the flow, sweep
`grid` and series `default` of the cells. What it makes of another reading it is told by a view of the tables
(readings), and how its Finding is graded stands in grades. A claim that does not come out is a result. The
checks stand in claims_flow (flow, tweezer), claims_classes and claims_extent (cells in the array).
"""

from dataclasses import dataclass

import pandas as pd

from study.planning.documents import read_json

LATTICE_UM = 0.4
SWEEP, SERIES, VARIANT = "grid", "default", "paper"
PAPER_RANGE = (0.1, 1.5)  # capillary numbers of the paper
CHECKS = {}


class Undecidable(Exception):
    """Why a claim cannot be judged although its runs were made: one diverged, or a fit has too few points."""


@dataclass(frozen=True)
class Finding:
    """Outcome of a check: does the claim come out within its tolerance, what was measured and how surely,
    what else there is to say, the runs behind it; by how much the number differs that the claim's `holds`
    describes (None: the statement itself is not true, or it has no number); and which of the printed
    statements that contradict the claim hold.
    """

    reproduced: bool
    measured: str
    note: str = ""
    uncertainty: str = ""
    runs: tuple = ()
    difference: float | None = None
    holding: tuple = ()


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
    return rows[pd.to_numeric(rows.dx_um, errors="coerce").sub(LATTICE_UM).abs() < 1e-3]


def grid(tables):
    """Rows of the phase space at the paper's lattice and within its capillary numbers; `label` is the
    class.
    """
    table = at_paper_lattice(tables["passages"].rename(columns={"class": "label"}))
    low, high = PAPER_RANGE
    rows = table[(table.sweep == SWEEP) & table.capillary_number.between(low - 1e-9, high + 1e-9)]
    return rows.sort_values(["row_shift_um", "capillary_number"])


def at_row_shift(rows, row_shift_um):
    """Those of some rows that have this row shift."""
    return rows[rows.row_shift_um.sub(row_shift_um).abs() < 1e-6]


def statements_that_hold(claim, holds):
    """Ids of the printed statements that contradict a claim and for which `holds` is true."""
    return tuple(other["id"] for other in claim.get("contradictions", []) if holds(other))


def deviation(value, printed):
    """How far a number is from the printed one, per cent."""
    return 100 * abs(value / printed - 1)


def runs_of(*frames):
    """Identities of the runs of some rows, each once, in their order."""
    found = [run for frame in frames for cell in frame.run.dropna() for run in str(cell).split()]
    return tuple(dict.fromkeys(found))


def ranged(values, style):
    """Text of a range of values."""
    low, high = format(min(values), style), format(max(values), style)
    return low if low == high else f"{low} ... {high}"
