"""The boundary between displaced and zigzag: critical capillary number of every series and row shift,
confirmations of its ends, and the mirror question, the critical row shift."""

from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.boundary import UNDISPUTED, undisputed
from study.analysis.tables import write_table
from study.planning.brackets import point_at
from study.planning.documents import read_json
from study.planning.plan_file import study_brackets

BOUNDARY = [
    "dx_um",
    "row_shift_um",
    "ca_displaced",
    "ca_zigzag",
    "status",
    "lateral_flow",
    "settings",
    "series",
    "device",
    "cell",
]
BOUNDARY += ["undecided_inside", "contradictions", *UNDISPUTED]
BOUNDARY += ["confirmed", "runs"]
ROW_SHIFTS = [
    "series",
    "device",
    "cell",
    "dx_um",
    "capillary_number",
    "d_displaced_um",
    "d_zigzag_um",
    "status",
]
ROW_SHIFTS += ["undecided_inside", "contradictions", "settings", "runs"]
POINTS = ["series", "device", "cell", "dx_um", "row_shift_um", "capillary_number", "class", "run"]
CONFIRMATION = ["series", "row_shift_um", "confirmation", "ca_displaced", "class_at_displaced", "ca_zigzag"]
CONFIRMATION += ["class_at_zigzag", "agrees", "runs"]
STYLES = {"dx_um": ".4f", "row_shift_um": ".1f", "d_displaced_um": ".2f"}
STYLES |= {"d_zigzag_um": ".2f"} | dict.fromkeys(
    ["ca_displaced", "ca_zigzag", *UNDISPUTED, "capillary_number"], ".4g"
)


def ends(state):
    """Identities of the runs at the ends of a bracket."""
    points = [point_at(state, state[side]) for side in ("low", "high")]
    return " ".join(point["run"] for point in points if point)


def confirmation_row(definition, state, label, folder):
    """What another set of settings says of both ends; None where the bracket has no such end."""
    low, high = (read_json(folder / f"confirm-{label}-{side}.json") for side in ("low", "high"))
    agrees = [point["class"] == name for point, name in ((low, "displaced"), (high, "zigzag")) if point]
    return {
        "series": definition["series"],
        "row_shift_um": definition["case"]["geometry"]["row_shift_um"],
        "confirmation": label,
        "ca_displaced": state["low"],
        "class_at_displaced": low and low["class"],
        "ca_zigzag": state["high"],
        "class_at_zigzag": high and high["class"],
        "agrees": "yes" if all(agrees) else "no",
        "runs": " ".join(point["run"] for point in (low, high) if point),
    }


def common(definition, state):
    """What a row has whatever its axis."""
    return {
        "series": definition["series"],
        "dx_um": definition["case"]["fluid"]["lattice_spacing_um"],
        "lateral_flow": definition["case"]["fluid"]["lateral_flow"],
        "settings": definition["settings"],
        "runs": ends(state),
        "device": definition["device"],
        "cell": definition["cell"],
        **{name: state[name] for name in ("status", "undecided_inside", "contradictions")},
    }


def point_rows(definition, state):
    """Every run of a bracket."""
    for point in state["points"]:
        yield {
            **{name: definition[name] for name in ("series", "device", "cell")},
            "dx_um": definition["case"]["fluid"]["lattice_spacing_um"],
            "row_shift_um": definition["case"]["geometry"]["row_shift_um"],
            "capillary_number": definition["case"]["cell"]["capillary_number"],
            definition["axis"]: point["value"],
            "class": point["class"],
            "run": point["run"],
        }


def main():
    arguments = required_arguments(
        __doc__, "plan", "brackets", "boundary", "points", "confirmation", "row-shifts"
    )
    plan = read_json(arguments.plan)
    boundary, row_shifts, points, confirmation = [], [], [], []
    for name, definition in study_brackets(plan).items():
        folder = Path(arguments.brackets) / name
        state = read_json(folder / f"level-{definition['levels']}.json")
        row = common(definition, state)
        points += point_rows(definition, state)
        if definition["axis"] == "row_shift_um":
            capillary = definition["case"]["cell"]["capillary_number"]
            row |= {"capillary_number": capillary}
            row_shifts.append(row | {"d_displaced_um": state["low"], "d_zigzag_um": state["high"]})
            continue
        confirmed = [confirmation_row(definition, state, label, folder) for label in definition["confirm"]]
        row |= {"row_shift_um": definition["case"]["geometry"]["row_shift_um"]}
        row |= {"ca_displaced": state["low"], "ca_zigzag": state["high"]}
        row |= dict(zip(UNDISPUTED, undisputed(state["points"]), strict=True))
        row["confirmed"] = "; ".join(f"{found['confirmation']}: {found['agrees']}" for found in confirmed)
        boundary.append(row)
        confirmation += confirmed
    write_table(boundary, BOUNDARY, arguments.boundary, ["series", "row_shift_um"], STYLES)
    write_table(row_shifts, ROW_SHIFTS, arguments.row_shifts, ["series", "capillary_number"], STYLES)
    keys = ["series", "row_shift_um", "capillary_number"]
    write_table(points, POINTS, arguments.points, keys, STYLES)
    write_table(confirmation, CONFIRMATION, arguments.confirmation, ["series", "row_shift_um"], STYLES)


main()
