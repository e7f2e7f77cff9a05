"""How sure the critical capillary number is: its bracket with one thing changed at a time, beside the bracket
of the series that the change is made to, at the row shifts of the target `uncertainty`. The undisputed ends
reach as far as passages contradict one another. The change is that of their middles (in ln Ca); it lies
between the least and the most that the two brackets allow."""

import math
from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.boundary import UNDISPUTED, undisputed
from study.analysis.tables import write_table
from study.planning.brackets import cut
from study.planning.documents import read_json

REFERENCE = ["reference_displaced", "reference_zigzag"]
CHANGES = ["change_percent", "least_change_percent", "most_change_percent"]
ENDS = ["ca_displaced", "ca_zigzag"]
COLUMNS = ["row_shift_um", "cause", "setting", *ENDS, *UNDISPUTED, "undecided_inside"]
COLUMNS += ["series", "reference", *REFERENCE, *CHANGES, "runs"]
STYLES = dict.fromkeys(["row_shift_um", *CHANGES], ".1f") | dict.fromkeys(
    [*ENDS, *UNDISPUTED, *REFERENCE], ".4g"
)


def states_of(plan, folder):
    """Final states of the brackets of the capillary number, by series and row shift."""
    return {
        (one["series"], one["case"]["geometry"]["row_shift_um"]): read_json(
            folder / name / f"level-{one['levels']}.json"
        )
        for name, one in plan["brackets"].items()
        if one["axis"] == "capillary_number"
    }


def row_shifts(plan):
    """Row shifts (um) at which something is changed by the target itself."""
    own = (one for one in plan["brackets"].values() if one["kind"] == "uncertainty")
    return {one["case"]["geometry"]["row_shift_um"] for one in own}


def percent(one, other):
    """Change from one capillary number to another, per cent; None where there is none."""
    return None if None in (one, other) else 100 * (other / one - 1)


def changes(low, high, reference_low, reference_high):
    """Change of the middle of a bracket, the least and the most change, per cent; None with an open end."""
    brackets = (reference_low, reference_high), (low, high)
    middles = (None if None in ends else math.sqrt(ends[0] * ends[1]) for ends in brackets)
    found = [percent(*middles), percent(reference_high, low), percent(reference_low, high)]
    return dict(zip(CHANGES, found, strict=True))


def rows_of(row, states, shifts):
    """Table rows of one cause: at every row shift asked for that both series have."""
    for (series, shift), state in states.items():
        reference = states.get((row["reference"], shift))
        if series != row["series"] or reference is None or shift not in shifts:
            continue
        ends, unchanged = (undisputed(one["points"]) for one in (state, reference))
        displaced, zigzag, _ = cut(state["points"])
        brackets = dict(zip([*UNDISPUTED, *REFERENCE], [*ends, *unchanged], strict=True))
        yield (
            row
            | brackets
            | changes(*ends, *unchanged)
            | {
                "row_shift_um": shift,
                "ca_displaced": displaced,
                "ca_zigzag": zigzag,
                "undecided_inside": state["undecided_inside"],
                "runs": " ".join(point["run"] for point in state["points"]),
            }
        )


def main():
    arguments = required_arguments(__doc__, "plan", "brackets", "output")
    plan = read_json(arguments.plan)
    states, shifts = states_of(plan, Path(arguments.brackets)), row_shifts(plan)
    rows = [found for row in plan["uncertainty"] for found in rows_of(row, states, shifts)]
    write_table(rows, COLUMNS, arguments.output, ["row_shift_um"], STYLES)


main()
