"""The table of the spot check: one row for every passage that was made again, and how alike it came out.

Ends with an error if a passage came out otherwise.
"""

import argparse
import sys
from collections import Counter

from study.analysis.spot_check import ALIKE, OTHER, SAME
from study.analysis.tables import write_table
from study.planning.documents import read_json

SHOWN = ["sweep", "dx_um", "row_shift_um", "capillary_number"]
COLUMNS = [
    *SHOWN,
    "class",
    "remade_class",
    "d_perp_um",
    "remade_d_perp_um",
    "verdict",
    "differing_columns",
    "run",
]

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--results", nargs="+", required=True)
parser.add_argument("--output", required=True)
parser.add_argument("--what", default="passages", help="what was made again")
arguments = parser.parse_args()

results = [read_json(path) for path in arguments.results]
rows = [
    {
        **{name: result["row"][name] for name in (*SHOWN, "class", "d_perp_um", "run")},
        "remade_class": result["remade"]["class"],
        "remade_d_perp_um": result["remade"]["d_perp_um"],
        "verdict": result["verdict"],
        "differing_columns": " ".join(result["columns"]),
    }
    for result in results
]
write_table(rows, COLUMNS, arguments.output, [*SHOWN, "run"])
count = Counter(row["verdict"] for row in rows)
without = len(rows) - sum(count[verdict] for verdict in (SAME, ALIKE, OTHER))
for row in rows:
    if row["verdict"] != SAME:
        print(f"{row['verdict']}: {row}")
print(
    f"{len(rows)} {arguments.what} made again: {count[SAME]} the same in every column, "
    f"{count[ALIKE]} with the same class and D_perp, {count[OTHER]} otherwise"
    + (f", {without} with nothing to compare with" if without else "")
)
sys.exit(1 if count[OTHER] else 0)
