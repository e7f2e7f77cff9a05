"""The devices of a study: their facts, the outlines of their pillars and, for every row shift, the
streamlines that divide the flow."""

from study.analysis.arguments import required_arguments
from study.analysis.devices import FACTS, facts_of
from study.analysis.runs import load_runs
from study.analysis.tables import write_table

LINES = ["device", "kind", "row_shift_um", "x_um", "y_um"]
SEPARATRICES = {
    "downstream": "below",
    "upstream": "above",
}  # in the file of a run: whose pillar they belong to
STYLES = dict.fromkeys(["x_um", "y_um"], ".3f")


def points(device, kind, shift, array):
    """Rows of one line."""
    for x, y in array:
        row = {"device": device, "kind": kind, "row_shift_um": shift}
        yield row | {"x_um": float(x), "y_um": float(y)}


def main():
    arguments = required_arguments(__doc__, "plan", "runs", "devices", "lines")
    finest = {}  # (device, row shift): the run with the finest lattice
    for run in load_runs(arguments.plan, arguments.runs, "streamlines"):
        key = (run.labels["device"], run.row_shift_um)
        if key not in finest or run.dx_um < finest[key].dx_um:
            finest[key] = run
    facts, lines = {}, []
    for (device, shift), run in sorted(finest.items()):
        if device not in facts:
            facts[device] = {"device": device} | facts_of(run)
            lines += points(device, "outline", None, facts[device]["outline_um"])
        for name, kind in SEPARATRICES.items():
            line = run.data(f"separatrix/{name}")
            lines += points(device, kind, shift, [] if line is None else line)
    write_table(facts.values(), ["device", *FACTS], arguments.devices, ["device"])
    write_table(lines, LINES, arguments.lines, styles=STYLES)


main()
