"""Passages from a second place in the gap: how many keep their class, on the grid and at ends of brackets."""

from study.analysis.arguments import required_arguments
from study.analysis.second_starts import rows_of
from study.analysis.tables import read_table, write_table

COLUMNS = ["set", "points", "same_class", "other_class", "no_class"]


def main():
    arguments = required_arguments(__doc__, "passages", "confirmation", "output")
    rows = rows_of(read_table(arguments.passages), read_table(arguments.confirmation))
    write_table(rows, COLUMNS, arguments.output, ["set"])


main()
