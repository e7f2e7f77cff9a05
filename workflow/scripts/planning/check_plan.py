"""Shows the cases of a tier to the solver: fails with all that it refuses, or writes what they will take."""

import argparse
import sys

from study.planning.documents import SCHEMAS, read_json
from study.planning.plan import load_plan
from study.planning.precheck import seconds_of_runs

parser = argparse.ArgumentParser(description=__doc__)
for name in ("--study", "--tier", "--dld", "--output"):
    parser.add_argument(name, required=True)
arguments = parser.parse_args()

plan = load_plan(arguments.study, arguments.tier)
case_schema = read_json(SCHEMAS / "case.schema.json")
try:
    seconds_of_runs(arguments.study, plan, case_schema, arguments.dld, arguments.output)
except ValueError as error:
    sys.exit(str(error))
