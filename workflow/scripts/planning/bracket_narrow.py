"""Next state of a bracket: its last state and the points of one level."""

import argparse
import json
from pathlib import Path

from study.planning.brackets import bracket
from study.planning.documents import read_json

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--plan", required=True)
parser.add_argument("--bracket", required=True)
parser.add_argument("--points", required=True, nargs="+")
parser.add_argument("--output", required=True)
arguments = parser.parse_args()

before = read_json(arguments.bracket)
added = [point for path in arguments.points if (point := read_json(path))]
state = bracket(before["points"] + added, read_json(arguments.plan)["brackets"][before["name"]])
Path(arguments.output).write_text(json.dumps(state, indent=1) + "\n", encoding="utf-8")
