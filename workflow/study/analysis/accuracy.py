"""Errors and costs of the runs of the accuracy study.

A study has points (what is simulated), methods with their settings (how), and references: limits of the
ladders of some methods. Every method names the reference that it is judged by, which is the limit of another
scheme wherever there is one.
"""

from collections import defaultdict

import numpy as np

from study.analysis.frontier import limit, on_frontier
from study.planning.classes import DECIDED

#: What is judged in each study: {error kind: (name in the summary, relative)}.
OBSERVABLES = {
    "flow": {
        "separation distance, relative": ("separation_um", True),
        "flow resistance, relative": ("resistance_Pa_s_per_m2", True),
    },
    "tweezer": {
        "axial diameter, relative": ("axial_um", True),
        "transverse diameter, relative": ("transverse_um", True),
    },
    "passages": {
        "D_perp, relative": ("d_perp_um", True),
        "centre, relative": ("centre_um", True),
        "film, um": ("film_um", False),
    },
}
GOOD = {"converged", *DECIDED}
COLUMNS = [
    "study",
    "method",
    "setting",
    "error",
    "error_kind",
    "work_units",
    "seconds",
    "on_frontier",
    "status",
]
COLUMNS += ["point", "spacing", "value", "reference", "reference_value", "reference_uncertainty"]
STYLES = dict.fromkeys(("error", "work_units", "seconds", "reference_uncertainty"), ".3e")
ALL = "all"


def spacing(case):
    """What goes to zero along a ladder: the lattice spacing in um; for a cell alone 1 / mesh frequency."""
    if case["scene"] == "stretching":
        return 1.0 / case["cell"]["mesh_frequency"]
    return case["fluid"]["lattice_spacing_um"]


def work_units(summary, weight):
    """Node updates, and membrane updates at their weight; None where the solver counted nothing."""
    nodes = summary.get("node_updates")
    return None if nodes is None else nodes + weight * summary.get("membrane_updates", 0)


def row_of(run, weight):
    """What one run gives: labels, cost, status, and the observables as arrays."""
    summary = run.summary
    observed = {}
    for kind, (name, _) in OBSERVABLES[run.labels["study"]].items():
        value = summary.get(name)
        if value is not None:
            observed[kind] = np.atleast_1d(np.asarray(value, float))
    cost = {"work_units": work_units(summary, weight), "seconds": run.core_s()}
    return (
        run.labels | cost | {"spacing": spacing(run.case), "status": summary["status"], "observed": observed}
    )


def references(definitions, rows):
    """{(reference, point, kind): (limit, uncertainty)} as arrays, from the rows that each reference names."""
    ladders = defaultdict(list)
    for name, definition in definitions.items():
        for row in rows:
            chosen = definition.get("settings", [row["setting"]])
            if row["method"] in definition["methods"] and row["setting"] in chosen and row["status"] in GOOD:
                for kind, values in row["observed"].items():
                    ladders[name, row["point"], kind].append((row["spacing"], values))
    found = {}
    for key, ladder in ladders.items():
        order = definitions[key[0]]["order"]
        if len(ladder) < (2 if order == "observed" else 3):
            continue
        spacings = [step for step, _ in ladder]
        limits = [limit(spacings, values, order) for values in zip(*(v for _, v in ladder), strict=True)]
        found[key] = tuple(np.array(part) for part in zip(*limits, strict=True))
    return found


def expected_classes(definitions, rows):
    """{(reference, point): class} that the finest run of each reference found."""
    finest = {}
    for name, definition in definitions.items():
        for row in sorted(rows, key=lambda row: -row["spacing"]):
            if row["method"] in definition["methods"] and row["status"] in GOOD:
                finest[name, row["point"]] = row["status"]
    return finest


def judged(study, row, reference, limits, classes):
    """Table rows of one run, one for each observable."""
    status = row["status"]
    if status in GOOD:
        same = status == classes.get((reference, row["point"]), status)
        status = "ok" if same else "other class"
    for kind, (_, relative) in OBSERVABLES[study].items():
        target = limits.get((reference, row["point"], kind))
        value, error, floor = row["observed"].get(kind), None, None
        if target is not None:
            scale = np.abs(target[0]) if relative else 1.0
            floor = float(np.max(target[1] / scale))
            if value is not None and len(value) == len(target[0]):
                error = float(np.max(np.abs(value - target[0]) / scale))
        single = value is not None and len(value) == 1
        yield {
            "study": study,
            "method": row["method"],
            "setting": row["setting"],
            "point": row["point"],
            "spacing": row.get("spacing"),
            "error": error,
            "error_kind": kind,
            "work_units": row["work_units"],
            "seconds": row["seconds"],
            "status": status if status != "ok" or error is not None else "no reference",
            "value": float(value[0]) if single else None,
            "reference": reference,
            "reference_value": float(target[0][0]) if single and target is not None else None,
            "reference_uncertainty": floor,
        }


def over_points(rows):
    """The rows of each setting joined over its points: largest error, whole cost, the first failure."""
    groups = defaultdict(list)
    for row in rows:
        groups[row["study"], row["method"], row["setting"], row["error_kind"]].append(row)
    for members in groups.values():
        bad = [row["status"] for row in members if row["status"] != "ok"]

        def total(name, how, members=members):
            values = [row[name] for row in members]
            return None if any(value is None for value in values) else how(values)

        yield members[0] | {
            "point": ALL,
            "error": total("error", max),
            "work_units": total("work_units", sum),
            "seconds": total("seconds", sum),
            "reference_uncertainty": total("reference_uncertainty", max),
            "status": bad[0] if bad else "ok",
            "value": None,
            "reference_value": None,
        }


def resolved_error(row):
    """Error as far as the reference can tell: never below its uncertainty; NaN where there is none."""
    if row["error"] is None:
        return np.nan
    return max(row["error"], row["reference_uncertainty"] or 0.0)


def mark_frontiers(rows):
    """Sets `on_frontier` in each row: among the good rows of the same study, kind of error and point."""
    groups = defaultdict(list)
    for row in rows:
        row["on_frontier"] = False
        if row["status"] == "ok":
            groups[row["study"], row["error_kind"], row["point"]].append(row)
    for members in groups.values():
        costs = [np.nan if row["work_units"] is None else row["work_units"] for row in members]
        for row, kept in zip(members, on_frontier(costs, [*map(resolved_error, members)]), strict=True):
            row["on_frontier"] = bool(kept)
    return rows


def passage_ladders(rows):
    """Rows of a cost table with the measured lengths of the passages, of the couplings that have them on two
    lattices or more; the methods by the name of the coupling alone."""
    prefix = "lattice, "
    rows = rows[(rows.study == "passages") & (rows.point != ALL) & rows.method.str.startswith(prefix)]
    rows = rows.dropna(subset=["value", "spacing"])
    rows = rows.assign(method=rows.method.str.removeprefix(prefix))
    return rows[rows.groupby(["method", "point", "error_kind"]).spacing.transform("nunique") > 1]


def judged_points(rows):
    """Rows of a cost table to draw conclusions from: over all points together, of passages at each point,
    because a setting that finds the right class at one point may miss it at another."""
    return rows[(rows.point == ALL) != (rows.study == "passages")]
