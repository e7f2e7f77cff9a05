"""Prints the case of one run of a plan."""

import argparse
import json

from study.planning.documents import read_json

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--plan", required=True)
parser.add_argument("--run", required=True, help="identity of the run")
arguments = parser.parse_args()

runs = read_json(arguments.plan)["runs"]
print(json.dumps(next(run["case"] for run in runs if run["id"] == arguments.run), indent=2))
