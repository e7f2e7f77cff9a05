"""The bending laws as the program `bending_laws` measures them, in fixed number formats."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table, write_table

NUMBERS = ["prefactor", "fold_modulus_ratio", "sphere_ratio", "squeeze_anisotropy"]
COLUMNS = ["law", *NUMBERS, "mesh_frequency"]


def main():
    arguments = required_arguments(__doc__, "measured", "output")
    rows = read_table(arguments.measured).to_dict("records")
    write_table(rows, COLUMNS, arguments.output, (), dict.fromkeys(NUMBERS, ".4f"))


main()
