"""Cost of the class against its error rate: rules on the first pillar lines, the proof by the return map,
and the rule that needs no passage, over the passages of some sweeps. Columns as in accuracy_cost.csv."""

from study.analysis import accuracy, class_rules
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table, write_table
from study.planning.documents import read_json


def main():
    arguments = required_arguments(__doc__, "plan", "passages", "crossings", "summary", "output")
    settings = read_json(arguments.plan)["accuracy"]
    tables = [read_table(path) for path in (arguments.passages, arguments.crossings, arguments.summary)]
    sweeps, weight = settings["class_sweeps"], settings["membrane_update_weight"]
    rows = accuracy.mark_frontiers(list(class_rules.rows_of(*tables, sweeps, weight)))
    write_table(rows, accuracy.COLUMNS, arguments.output, ["method", "work_units"], accuracy.STYLES)


main()
