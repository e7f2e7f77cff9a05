"""Extracts the moving outlines of the animations: the cell in the mid plane at every snapshot of the sweep
`animation`."""

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.surface import outline
from study.analysis.tables import write_table
from study.planning.documents import read_json

COLUMNS = ["row_shift_um", "capillary_number", "class", "step", "x_um", "y_um"]


def snapshots(run, rows_shown):
    """(step, outline) of the snapshots up to the last row shown, in the order of time."""
    last = (rows_shown - 0.5) * run.case["geometry"]["pitch_um"]
    with run.open() as file:
        faces, groups = file["membrane/faces"][:], file["membrane"]
        names = [name for name in groups if name.startswith("snapshot_")]
        for name in sorted(names, key=lambda one: groups[one].attrs["step"]):
            vertices = groups[f"{name}/vertices"][:]
            if vertices[:, 0].mean() <= last:
                yield int(groups[name].attrs["step"]), outline(vertices, faces)


def main():
    arguments = table_arguments(__doc__)
    plan, rows = read_json(arguments.plan), []
    for run in load_runs(arguments.plan, arguments.runs, "passages"):
        if run.labels["sweep"] != "animation":
            continue
        label = {"row_shift_um": run.row_shift_um, "capillary_number": run.case["cell"]["capillary_number"]}
        label["class"] = run.summary["status"]
        for step, line in snapshots(run, plan["figures"]["animation_rows"]):
            rows += [label | {"step": step, "x_um": float(x), "y_um": float(y)} for x, y, _ in line]
    styles = {"row_shift_um": ".1f", "x_um": ".3f", "y_um": ".3f"}
    write_table(rows, COLUMNS, arguments.output, COLUMNS[:2], styles)


main()
