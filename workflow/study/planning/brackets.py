"""Bracketing the boundary between displaced and zigzag along one axis of the phase space.

Along the capillary number, as along the row shift, cells are displaced at low values and zigzag at high ones.
A bracket holds the points known so far; its ends are the neighbouring displaced and zigzag points at the cut
that contradicts the fewest points. Each level adds the two inner thirds of the interval, two independent
runs. Nothing here runs or reads a file: points are dictionaries {value, class, run}.
"""

import copy
import math

from study.planning.classes import DECIDED

#: Where the value of an axis stands in a case.
AXES = {"capillary_number": ("cell", "capillary_number"), "row_shift_um": ("geometry", "row_shift_um")}
DIGITS = 4  # of a capillary number chosen by a bracket
#: Status of a boundary that was not looked for: the neighbouring cells of a sweep whose classes differ.
FROM_CELLS = "from the cells of the sweeps"


def at_value(case, axis, value):
    """A copy of a resolved case with another value on the axis."""
    section, key = AXES[axis]
    moved = copy.deepcopy(case)
    moved[section][key] = float(value)
    return moved


def off_axis(case, axis):
    """A copy of a resolved case without the value on the axis: equal for all points of one bracket."""
    section, key = AXES[axis]
    rest = copy.deepcopy(case)
    rest[section].pop(key, None)
    return rest


def merged_points(*groups):
    """Points of several lists, each value once, in ascending order."""
    found = {point["value"]: point for group in groups for point in group}
    return [found[value] for value in sorted(found)]


def cut(points):
    """(low, high, contradictions): values next to the cut that contradicts the fewest decided points.

    low is displaced (None: no displaced point below the cut), high zigzag (None: none above it). Among
    equally good cuts the lowest counts.
    """
    decided = [point for point in points if point["class"] in DECIDED]
    displaced = [point["class"] == "displaced" for point in decided]
    wrong = [displaced[:k].count(False) + displaced[k:].count(True) for k in range(len(decided) + 1)]
    best = wrong.index(min(wrong))
    below = [point["value"] for point, d in zip(decided[:best], displaced[:best], strict=True) if d]
    above = [point["value"] for point, d in zip(decided[best:], displaced[best:], strict=True) if not d]
    return (max(below) if below else None), (min(above) if above else None), min(wrong)


def narrow(low, high, definition):
    """Is the interval as small as asked for: a ratio of capillary numbers, or one step of the row shift?"""
    if definition["axis"] == "row_shift_um":
        return high - low <= definition["step"] * 1.001
    return high / low <= 1 + definition["tolerance"]


def status_of(points, definition):
    """bracketed, all-displaced, all-zigzag, or open: something undecided is in the way; FROM_CELLS where no
    level was to narrow it."""
    low, high, _ = cut(points)
    if low is not None and high is not None:
        if narrow(low, high, definition):
            return "bracketed"
        return "open" if definition["levels"] else FROM_CELLS
    if low is not None and points[-1]["class"] == "displaced":
        return "all-displaced"
    if high is not None and points[0]["class"] == "zigzag":
        return "all-zigzag"
    return "open"


def _inner_capillary_numbers(low, high, unclear, definition):
    """Thirds of the logarithm; with unclear points inside, the middles between them and the ends."""
    if not unclear:
        step = math.log(high / low) / 3
        values = [low * math.exp(step), high * math.exp(-step)]
    else:
        gaps = [(low, unclear[0]), (unclear[-1], high)]
        values = [math.sqrt(a * b) for a, b in gaps if not narrow(a, b, definition)]
    return [float(f"{value:.{DIGITS}g}") for value in values]


def _inner_row_shifts(low, high, known, step):
    """Lattice steps strictly between the ends, at most two: those nearest to the thirds."""
    count = round((high - low) / step)
    free = [k for k in range(1, count) if all(abs(low + k * step - value) > 0.5 * step for value in known)]
    if len(free) > 2:
        free = sorted({min(free, key=lambda k: abs(3 * k - part * count)) for part in (1, 2)})
    return [round(low + k * step, 6) for k in free]


def next_values(points, definition):
    """The values to run next: none (the bracket is done), one or two."""
    low, high, _ = cut(points)
    if low is None or high is None or narrow(low, high, definition):
        return []
    inside = [point["value"] for point in points if low < point["value"] < high]
    if definition["axis"] == "row_shift_um":
        return _inner_row_shifts(low, high, inside, definition["step"])
    values = _inner_capillary_numbers(low, high, inside, definition)
    return sorted({value for value in values if low < value < high} - set(inside))


def bracket(points, definition):
    """The state of a bracket, as it is written to a file."""
    points = merged_points(points)
    low, high, contradictions = cut(points)
    inside = [p for p in points if low is not None and high is not None and low < p["value"] < high]
    return {
        "name": definition["name"],
        "axis": definition["axis"],
        "low": low,
        "high": high,
        "status": status_of(points, definition),
        "undecided_inside": len(inside),
        "contradictions": contradictions,
        "next": next_values(points, definition),
        "points": points,
    }


def point_at(state, value):
    """The point of a bracket at a value; None without one."""
    return next((point for point in state["points"] if point["value"] == value), None)
