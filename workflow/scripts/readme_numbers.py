"""Puts the numbers of the results into README.md, between its marks: times, verdicts, the boundary, what it
depends on, second starts."""

from pathlib import Path

from study import readme
from study.arguments import required_arguments
from study.claims import load_claims
from study.tables import read_table


def main():
    arguments = required_arguments(__doc__, "readme", "tables", "verdicts", "claims")
    tables = Path(arguments.tables)
    claim = load_claims(arguments.claims)["phase-boundary"]
    uncertainty = tables / "boundary_uncertainty.csv"  # made on request
    blocks = {
        "times": readme.times(read_table(tables / "stage_times.csv")),
        "boundary": readme.boundary(read_table(tables / "phase_boundary.csv"), claim),
        "doubts": readme.doubts(read_table(uncertainty) if uncertainty.exists() else None),
        "starts": readme.starts(read_table(tables / "second_starts.csv")),
        "verdicts": readme.verdicts(read_table(arguments.verdicts)),
    }
    path = Path(arguments.readme)
    path.write_text(readme.with_blocks(path.read_text(), blocks))


main()
