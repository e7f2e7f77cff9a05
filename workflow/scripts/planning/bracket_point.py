"""One run of a bracket: the lower or the upper of the next values that its last state names, or, with
--confirm, an end of the bracket at other settings. Where the state asks for nothing, nothing is run."""

import argparse
import json
from pathlib import Path

from study.analysis.solve import solved
from study.planning.brackets import at_value
from study.planning.documents import read_json


def wanted(state, side, confirm):
    """The value to run, or None."""
    if confirm:
        return state[side]
    index = ("low", "high").index(side)
    return state["next"][index] if index < len(state["next"]) else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--plan", "--bracket", "--runs", "--dld", "--runner", "--output"):
        parser.add_argument(name, required=True)
    parser.add_argument("--side", required=True, choices=["low", "high"])
    parser.add_argument("--confirm", help="name of the settings at which an end is run again")
    arguments = parser.parse_args()
    plan, state = read_json(arguments.plan), read_json(arguments.bracket)
    definition = plan["brackets"][state["name"]]
    value = wanted(state, arguments.side, arguments.confirm)
    point = None
    if value is not None:
        template = definition["confirm"][arguments.confirm] if arguments.confirm else definition["case"]
        case = at_value(template, definition["axis"], value)
        run, status = solved(case, plan["solver_model"], arguments.runs, arguments.runner, arguments.dld)
        point = {"value": value, "class": status, "run": run}
    Path(arguments.output).write_text(json.dumps(point) + "\n", encoding="utf-8")


main()
