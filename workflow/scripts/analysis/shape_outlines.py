"""Outline and gap of an example of every pillar shape, as the solver has them: a few steps of the flow state
the device. The examples stand in the schema of a case."""

import json
import subprocess
import tempfile
from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.shapes import example_of, shapes_of
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["shape", "gap_um", "kind", "x_um", "y_um"]
STEPS = 2  # of the flow, which is not what is wanted
CASE = {"scene": "streamlines", "fluid": {"lattice_spacing_um": 0.4, "force_density": 1e-4}}
CASE |= {"stop": {"max_steps": STEPS}}


def device_of(pillar, dld):
    """What the solver says of the device with this pillar."""
    with tempfile.TemporaryDirectory() as folder:
        case, output, summary = (Path(folder) / name for name in ("case.json", "run.h5", "summary.json"))
        case.write_text(json.dumps(CASE | {"geometry": {"pillar": pillar}}), encoding="utf-8")
        command = [Path(dld).absolute(), "run", case, output, "--summary", summary]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return read_json(summary)["device"]


def main():
    arguments = required_arguments(__doc__, "schema", "dld", "output")
    rows = []
    for shape in shapes_of(read_json(arguments.schema)):
        pillar = example_of(shape)
        device = device_of(pillar, arguments.dld)
        gap = [(device["gap_line_x_um"], device[f"surface_{side}_um"]) for side in ("below", "above")]
        kinds = {"outline": device["outline_um"], "gap": gap if device["outline_um"] else []}
        for kind, points in kinds.items():
            row = {"shape": pillar["shape"], "gap_um": device["gap_um"], "kind": kind}
            rows += [row | {"x_um": x, "y_um": y} for x, y in points]
    write_table(rows, COLUMNS, arguments.output, styles={"x_um": ".4f", "y_um": ".4f"})


main()
