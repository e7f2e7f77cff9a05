"""Writes what each file of the results is: RO-Crate metadata beside them."""

import argparse
from pathlib import Path

from study.analysis.crate import METADATA, crate
from study.analysis.software import as_text

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--results", required=True, help="folder of a tier's results")
parser.add_argument("--tiers", nargs="*", default=[], help="other tiers, whose folders may lie within")
arguments = parser.parse_args()
text = as_text(crate(arguments.results, arguments.tiers))
(Path(arguments.results) / METADATA).write_text(text, encoding="utf-8")
