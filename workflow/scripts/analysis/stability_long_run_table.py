"""Drift over a long run: one row per pillar line with extent, volume, area, smallest face and film."""

import numpy as np
from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import write_table

COLUMNS = [
    "name",
    "dx_um",
    "row",
    "d_perp_um",
    "d_perp_change",
    "volume_change",
    "area_change",
    "min_face_ratio",
    "film_um",
    "bump",
    "status",
    "run",
]
STYLES = {"dx_um": ".4f", "d_perp_um": ".4f", "film_um": ".4f", "min_face_ratio": ".3f"}
STYLES |= dict.fromkeys(("d_perp_change", "volume_change", "area_change"), ".3e")
#: Row with which D_perp is compared: the start is forgotten, the drift has hardly begun.
REFERENCE_ROW = 10


def rows_of(run):
    """Rows of one run; none if it crossed no pillar line."""
    names = ("row", "step", "d_perp_um", "min_face_ratio", "film_um", "bump")
    crossings = {name: run.data(f"crossings/{name}") for name in names}
    if crossings["row"] is None:
        return []
    trajectory = {name: run.data(f"trajectory/{name}") for name in ("step", "volume_change", "area_change")}
    known = crossings["row"] == min(REFERENCE_ROW, crossings["row"][-1])
    reference = crossings["d_perp_um"][known][0]
    for k, step in enumerate(crossings["step"]):
        at_step = {
            name: float(np.interp(step, trajectory["step"], trajectory[name]))
            for name in ("volume_change", "area_change")
        }
        yield {
            "name": run.labels["name"],
            "dx_um": run.dx_um,
            "row": int(crossings["row"][k]),
            "d_perp_um": float(crossings["d_perp_um"][k]),
            "d_perp_change": float(crossings["d_perp_um"][k] / reference - 1),
            **at_step,
            "min_face_ratio": float(crossings["min_face_ratio"][k]),
            "film_um": float(crossings["film_um"][k]),
            "bump": int(crossings["bump"][k]),
            "status": run.summary["status"],
            "run": run.id,
        }


def main():
    arguments = table_arguments(__doc__)
    rows = [row for run in load_runs(arguments.plan, arguments.runs, "long-run") for row in rows_of(run)]
    write_table(rows, COLUMNS, arguments.output, ["name", "row"], STYLES)


main()
