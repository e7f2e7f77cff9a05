"""Extracts the lines of Figure 1: streams of equal flux, a small particle on a streamline below the
separation streamline, and the way and outlines of a displaced cell."""

import numpy as np
from study.analysis.arguments import table_arguments
from study.analysis.midplane import MidPlaneFlow
from study.analysis.runs import load_runs
from study.analysis.surface import outline
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["kind", "line", "x_um", "y_um"]


def rows(kind, line, points):
    """Table rows of one line."""
    for x, y in points:
        yield {"kind": kind, "line": line, "x_um": float(x), "y_um": float(y)}


def flow_lines(run, wanted):
    """Streams of equal flux and the path of the small particle; both run through the gap line of row 0."""
    geometry = run.case["geometry"]
    field = [run.data(f"flow/{name}") for name in ("x_um", "y_um", "velocity")]
    flow = MidPlaneFlow(*field, geometry["pitch_um"], run.row_shift_um)
    radius, pitch = geometry["pillar_radius_um"], geometry["pitch_um"]
    length = 1.25 * wanted["rows"] * pitch
    seeds = {("stream", n): y for n, y in enumerate(flow.equal_flux_seeds(radius, wanted["streams"]))}
    height = radius + wanted["small_height"] * run.summary["separation_um"]
    for (kind, number), y in (seeds | {("small", 0): height}).items():
        before, after = flow.streamline((0, y), pitch, -1.0), flow.streamline((0, y), length)
        yield from rows(kind, number, np.concatenate([before[:0:-1], after]))


def cell_lines(run, wanted):
    """Way of the centre and outlines in the mid plane at the pillar lines."""
    last = (wanted["rows"] - 0.5) * run.case["geometry"]["pitch_um"]
    with run.open() as file:
        x, y = file["trajectory/x_um"][:], file["trajectory/y_um"][:]
        yield from rows("cell", 0, np.column_stack([x, y])[x <= last])
        faces, groups = file["membrane/faces"][:], file["membrane"]
        for number, name in enumerate(sorted(name for name in groups if name.startswith("crossing_"))):
            vertices = groups[f"{name}/vertices"][:]
            if vertices[:, 0].mean() <= last:
                yield from rows("outline", number, outline(vertices, faces)[:, :2])


def main():
    arguments = table_arguments(__doc__)
    wanted, lines = read_json(arguments.plan)["figures"]["array"], []
    for run in load_runs(arguments.plan, arguments.runs, "streamlines"):
        if run.labels["variant"] == wanted["variant"] and run.row_shift_um == wanted["row_shift_um"]:
            lines += flow_lines(run, wanted)
    for run in load_runs(arguments.plan, arguments.runs, "passages"):
        chosen = run.labels["sweep"] == wanted["sweep"] and run.row_shift_um == wanted["row_shift_um"]
        right = run.case["cell"]["capillary_number"] == wanted["capillary_number"]
        if chosen and right and run.summary["status"] == "displaced":
            lines += cell_lines(run, wanted)
    write_table(lines, COLUMNS, arguments.output, styles={"x_um": ".3f", "y_um": ".3f"})


main()
