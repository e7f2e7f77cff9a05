"""Puts the line of verdicts into README.md, between its marks."""

from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.paper.results_page import verdicts, with_blocks


def main():
    arguments = required_arguments(__doc__, "readme", "verdicts")
    path = Path(arguments.readme)
    text = with_blocks(
        path.read_text(encoding="utf-8"), {"verdicts": verdicts(read_table(arguments.verdicts))}
    )
    path.write_text(text, encoding="utf-8")


main()
