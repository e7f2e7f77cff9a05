"""Puts the numbers of the results into README.md, between its marks: times, boundary, verdicts."""

from pathlib import Path

from study import readme
from study.arguments import required_arguments
from study.claims import load_claims
from study.tables import read_table


def main():
    arguments = required_arguments(__doc__, "readme", "tables", "verdicts", "claims")
    tables = Path(arguments.tables)
    claim = load_claims(arguments.claims)["phase-boundary"]
    brackets = read_table(tables / "phase_boundary.csv")
    blocks = {
        "times": readme.times(read_table(tables / "stage_times.csv")),
        "boundary": readme.boundary(brackets, claim),
        "doubts": readme.doubts(brackets),
        "blocked": readme.blocked(brackets, claim),
        "starts": readme.starts(read_table(tables / "second_starts.csv")),
        "verdicts": readme.verdicts(read_table(arguments.verdicts)),
    }
    path = Path(arguments.readme)
    path.write_text(readme.with_blocks(path.read_text(), blocks))


main()
