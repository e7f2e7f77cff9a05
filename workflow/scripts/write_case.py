"""Prints the case of one run of a tier."""

import argparse
import json

from study.plan import load_plan

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--study", required=True)
parser.add_argument("--tier", required=True)
parser.add_argument("--run", required=True, help="identity of the run")
arguments = parser.parse_args()

runs = load_plan(arguments.study, arguments.tier)["runs"]
print(json.dumps(next(run["case"] for run in runs if run["id"] == arguments.run), indent=2))
