"""Prints the verdicts: one line for each claim with what was measured."""

import sys
import textwrap

import pandas as pd
from study.paper.grades import counted

table = pd.read_csv(sys.argv[1], keep_default_na=False)
width, grade = table.id.str.len().max(), table.verdict.str.len().max()
for row in table.itertuples():
    text = row.measured or row.note
    print(f"{row.id:{width}}  {row.verdict:{grade}}  {textwrap.shorten(text, 100, placeholder=' ...')}")
print(counted(table.verdict))
