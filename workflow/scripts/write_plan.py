"""Writes the plan of a tier: all its solver runs with their identities and resolved cases."""

import argparse
import json
from pathlib import Path

from study.plan import load_plan

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--study", required=True)
parser.add_argument("--tier", required=True)
parser.add_argument("--output", required=True)
arguments = parser.parse_args()

plan = load_plan(arguments.study, arguments.tier)
Path(arguments.output).write_text(json.dumps(plan, indent=1) + "\n", encoding="utf-8")
