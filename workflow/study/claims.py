"""What a check of a claim is: a function of the tables and the claim that says what was measured.

A check returns a Finding, or None where the runs for it are missing; it raises Undecidable where they are
there and do not tell. The verdict is on the paper's own method at its own lattice (variant `paper` of the
flow, sweep `grid` and series `lattice-0.4` of the cells); refined values stand in the note. A claim that
does not come out is a result. The checks stand in claims_flow (flow, tweezer), claims_classes and
claims_extent (cells in the array).
"""

from collections import Counter
from dataclasses import dataclass

from study.plan import read_json

LATTICE_UM = 0.4
SWEEP, SERIES, LIMIT = "grid", "lattice-0.4", "extrapolated"
PAPER_RANGE = (0.1, 1.5)  # capillary numbers of the paper
CHECKS = {}
VERDICTS = ("REPRODUCED", "NOT REPRODUCED", "NOT DECIDED", "NOT RUN")


def counted(verdicts):
    """How often each verdict was given, in words."""
    count = Counter(verdicts)
    return ", ".join(f"{count[name]} {name}" for name in VERDICTS)


class Undecidable(Exception):
    """Why a claim cannot be judged although its runs were made: one diverged, or a fit has too few points."""


@dataclass(frozen=True)
class Finding:
    """Outcome of a check: does the claim come out, what was measured and how surely, what else there is to
    say, and the runs behind it."""

    reproduced: bool
    measured: str
    note: str = ""
    uncertainty: str = ""
    runs: tuple = ()


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


def runs_of(*frames):
    """Identities of the runs of some rows, each once, in their order."""
    found = [run for frame in frames for cell in frame.run.dropna() for run in str(cell).split()]
    return tuple(dict.fromkeys(found))


def ranged(values, style):
    """Text of a range of values."""
    low, high = format(min(values), style), format(max(values), style)
    return low if low == high else f"{low} ... {high}"
