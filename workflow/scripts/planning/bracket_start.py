"""First state of a bracket: the ends of its range and all other runs of the plan that lie on its axis."""

import argparse
import json
from pathlib import Path

from study.analysis.runs import checked_summary
from study.planning.brackets import bracket
from study.planning.documents import read_json

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--plan", required=True)
parser.add_argument("--name", required=True, help="of the bracket")
parser.add_argument("--runs", required=True)
parser.add_argument("--output", required=True)
arguments = parser.parse_args()

definition = read_json(arguments.plan)["brackets"][arguments.name]
points = [
    {"value": value, "class": checked_summary(Path(arguments.runs) / run)["status"], "run": run}
    for value, run in definition["known"]
]
state = bracket(points, definition)
Path(arguments.output).write_text(json.dumps(state, indent=1) + "\n", encoding="utf-8")
