"""Stability maps: the points of the plan, and what a run at one of them counts as."""

import math
from itertools import pairwise, product

from study.planning.failures import WITHOUT_NUMBERS
from study.planning.points import merged

#: Beyond these a finished run counts as inaccurate: the project's bounds for its own runs, on what every run
#: reports of itself. Below the film of zero a node was inside a pillar.
INACCURATE = {
    "volume_change": 0.01,
    "area_change": 0.01,
    "density_variation": 0.1,
}
SMALLEST_FACE_RATIO = 0.3
SMALLEST_FILM_UM = 0.0

STATUSES = ("works", "inaccurate", "fails")


def at(pointer, value):
    """The part of a case that has `value` at a JSON pointer, e.g. /fluid/force_density."""
    part = value
    for name in reversed(pointer.strip("/").split("/")):
        part = {name: part}
    return part


def maps(tier):
    """The points of all maps, in the plane of x and y."""
    part = tier["stability"]
    for name, plane in part["maps"].items():
        x_name, y_name = plane["x"]["key"], plane["y"]["key"]
        for x, y in product(plane["x"]["values"], plane["y"]["values"]):
            labels = {"map": name, "x_name": x_name, "x": x, "y_name": y_name, "y": y}
            base = part["maps"][plane["extends"]]["case"] if "extends" in plane else {}
            point = merged(part["case"], base, plane["case"], at(x_name, x), at(y_name, y))
            yield "stability", labels, merged(point, {"scene": "passage"})


def long_run(tier):
    """Passages of many pillar rows, however early their class is proved."""
    for name, part in tier["stability"]["long_run"].items():
        stop = {"when": "rows", "max_rows": part["rows"]}
        yield "long-run", {"name": name}, merged(part["case"], {"scene": "passage", "stop": stop})


def judge(summary):
    """Status of a run and the quantity that decides it (None if the run works)."""
    if summary["status"] in WITHOUT_NUMBERS:
        return "fails", summary.get("failing_quantity")
    for name, bound in INACCURATE.items():
        if not abs(summary[name]) <= bound:
            return "inaccurate", name
    if not summary["min_face_ratio"] >= SMALLEST_FACE_RATIO:
        return "inaccurate", "min_face_ratio"
    if not summary["smallest_film_um"] >= SMALLEST_FILM_UM:
        return "inaccurate", "smallest_film_um"
    return "works", None


def crossing(ys, shares):
    """The y at which the used share of the tightest margin passes 1 (log-log interpolation), or None."""
    points = list(zip(ys, shares, strict=True))
    if not all(isinstance(value, (int, float)) and value > 0 for pair in points for value in pair):
        return None
    for (y0, s0), (y1, s1) in pairwise(points):
        if (s0 - 1) * (s1 - 1) <= 0 and s0 != s1:
            part = math.log(s0) / (math.log(s0) - math.log(s1))
            return math.exp(math.log(y0) + part * (math.log(y1) - math.log(y0)))
    return None
