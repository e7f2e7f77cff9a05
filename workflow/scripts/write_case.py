"""Writes the case file of one run of a plan."""

import argparse
import json
from pathlib import Path

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--plan", required=True)
parser.add_argument("--run", required=True, help="identity of the run")
parser.add_argument("--output", required=True)
arguments = parser.parse_args()

plan = json.loads(Path(arguments.plan).read_text(encoding="utf-8"))
case = next(run["case"] for run in plan["runs"] if run["id"] == arguments.run)
Path(arguments.output).write_text(json.dumps(case, indent=2) + "\n", encoding="utf-8")
