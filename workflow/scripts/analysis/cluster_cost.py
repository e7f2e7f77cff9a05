"""Puts what a phase space costs on a cluster into docs/cluster.md."""

import argparse
from pathlib import Path

from study.analysis.cluster_cost import cost_table
from study.analysis.tables import read_table
from study.paper.results_page import with_blocks

parser = argparse.ArgumentParser(description=__doc__)
for name in ("--passages", "--stages", "--page"):
    parser.add_argument(name, required=True)
arguments = parser.parse_args()
page = Path(arguments.page)
block = cost_table(read_table(arguments.passages), read_table(arguments.stages))
page.write_text(with_blocks(page.read_text(encoding="utf-8"), {"cost": block}), encoding="utf-8")
