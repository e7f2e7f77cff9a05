"""What the frontiers say, in words: the cheapest setting for a wanted accuracy, what failed, the error of the
presets, how passages converge with the lattice spacing, whether fast settings change a result, and the weight
of a membrane update by the run times. All of it comes from the tables."""

from pathlib import Path

import numpy as np
from study.analysis.accuracy import ALL, GOOD, judged_points, passage_ladders
from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import read_table
from study.numerics.fits import first_order_limit
from study.planning.documents import read_json

GOALS = [0.1, 0.03, 0.01, 0.003]


def name_of(row):
    """Method and setting in words."""
    return f"{row.method}, {row.setting}" if row.setting else row.method


def failed(rows):
    """The rows of the settings that did not end well."""
    return rows[~rows.status.isin(["ok", "no reference"])]


def usable(rows):
    """The rows of the settings that ended well at all points of their study."""
    keys = ["study", "method", "setting"]
    bad = failed(rows).drop_duplicates(keys)[keys]
    marked = rows.merge(bad, on=keys, how="left", indicator=True)
    return marked[marked["_merge"] == "left_only"].drop(columns="_merge")


def cheapest(rows, goal):
    """The cheapest good row whose error is told to be below the goal, or None."""
    good = rows[(rows.status == "ok") & (np.fmax(rows.error, rows.reference_uncertainty.fillna(0)) <= goal)]
    return good.loc[good.work_units.idxmin()] if good.work_units.notna().any() else None


def goals_of(rows):
    """Lines of a table: goal, cheapest setting, its error, work and seconds."""
    yield "| error at most | cheapest setting | its error | node updates | seconds |"
    yield "|---|---|---|---|---|"
    for goal in GOALS:
        row = cheapest(rows, goal)
        if row is None:
            floor = rows.reference_uncertainty.max()
            why = "the reference is not that certain" if floor > goal else "none of the settings"
            yield f"| {goal:g} | {why} | | | |"
        else:
            seconds = "" if row.seconds != row.seconds else f"{row.seconds:.2g}"
            yield f"| {goal:g} | {name_of(row)} | {row.error:.1e} | {row.work_units:.1e} | {seconds} |"


def failures_of(rows):
    """Lines on the settings that did not end well."""
    for row in failed(rows).drop_duplicates(["method", "setting"]).itertuples():
        than = f" than the finest of '{row.reference}'" if row.status == "other class" else ""
        yield f"- {name_of(row)}: {row.status}{than}"


def presets_of(table):
    """Lines of a table: largest error of every preset over the points, with the reference's uncertainty."""
    rows = table[(table.method == "preset") & (table.point == ALL)]
    if rows.empty:
        return
    kinds = list(dict.fromkeys(rows.error_kind))
    yield "## Presets\n"
    yield "Largest error over the points; in brackets the uncertainty of the reference.\n"
    yield "| preset | " + " | ".join(kinds) + " | node updates | seconds | status |"
    yield "|---" * (len(kinds) + 4) + "|"
    for setting, part in rows.groupby("setting", sort=False):
        part = part.set_index("error_kind")
        cells = [f"{part.error[kind]:.2g} ({part.reference_uncertainty[kind]:.1g})" for kind in kinds]
        cost = part.iloc[0]
        cells += [f"{cost.work_units:.2e}", f"{cost.seconds:.3g}", cost.status]
        yield f"| {setting} | {' | '.join(cells)} |"


def ladders_of(table):
    """Lines of a table: the measured lengths of the passages on every lattice, their order and limit."""
    rows = passage_ladders(table)
    spacings = sorted(rows.spacing.unique(), reverse=True)
    if rows.empty:
        return
    yield "## Passages against the lattice spacing\n"
    yield "um; limit of the observed order, else of first order from the two finest lattices (in brackets).\n"
    yield "| method | point | length | " + " | ".join(f"{h:.3g} um" for h in spacings) + " | order | limit |"
    yield "|---" * (len(spacings) + 5) + "|"
    for (method, point, kind), part in rows.groupby(["method", "point", "error_kind"], sort=False):
        found = part.drop_duplicates("spacing").set_index("spacing").value.sort_index(ascending=False)
        cells = [f"{found[h]:.3f}" if h in found.index else "" for h in spacings]
        limit, order = first_order_limit(found.index.to_numpy(), found.to_numpy())
        name = kind.removesuffix(", relative").removesuffix(", um")
        cells += [f"{order:.2f}" if order else "(1)", f"{limit:.3f}"]
        yield f"| {method} | {point} | {name} | " + " | ".join(cells) + " |"
    yield ""


def check_of(table):
    """Lines on the passages that were run with fast settings and with conservative ones."""
    yield "## Fast settings against conservative ones\n"
    for name, rows in table.groupby("settings", sort=False):
        failed = (rows["class"] == "diverged") & (rows.conservative_class == "diverged")
        check = rows[~failed]
        change, steps = check.d_perp_relative_change.abs(), check.steps_ratio
        yield (
            f"`{name}`, {len(rows)} passages: the same class in {check.same_class.sum()}; D_perp differs "
            f"by {change.max():.2%} at most (median {change.median():.2%}); {steps.median():.1f} times fewer "
            "steps in the median."
        )
        for row in rows[failed | (rows.same_class == 0)].to_dict("records"):
            place = f"d = {row['row_shift_um']:g} um, Ca = {row['capillary_number']:g}"
            classes = f"{row['class']} with the fast settings, {row['conservative_class']} with the others"
            yield f"- {place}: {classes}"
        yield ""


def measured_weight(runs):
    """Weight of a membrane update and nanoseconds of a node update, in words, from the run times in single
    precision.

    seconds = a (node updates + weight * membrane updates), least squares of the relative deviation, over the
    largest set of runs with one lattice, one kernel and one update interval: a fine lattice is slower per
    node and has fewer membrane nodes for them, which the weight would take for its own. None without enough
    runs, or where the times are too uneven to give positive numbers.
    """
    samples = {}
    for run in runs:
        summary, seconds, how = run.summary, run.core_s(), run.case["coupling"]
        if summary["status"] in GOOD and seconds and run.case["fluid"]["precision"] == "single":
            key = run.case["fluid"]["lattice_spacing_um"], how["kernel"], how["steps_per_update"]
            rates = (summary["node_updates"] / seconds, summary["membrane_updates"] / seconds)
            samples.setdefault(key, []).append(rates)
    if not samples:
        return None
    (dx, kernel, steps), rates = max(samples.items(), key=lambda item: len(item[1]))
    if len({round(membrane / node, 4) for node, membrane in rates if node}) < 3:
        return None
    (a, b), *_ = np.linalg.lstsq(np.array(rates), np.ones(len(rates)), rcond=None)
    if min(a, b) <= 0:
        return None
    return (
        f"The run times of {len(rates)} passages with dx = {dx:.3g} um, {kernel} and an update in {steps} "
        f"step{'s' * (steps > 1)} give a weight of {b / a:.0f} and {a * 1e9:.1f} ns per node update."
    )


def main():
    arguments = table_arguments(__doc__, "table", "check")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    table["setting"] = table.setting.astype(object).where(table.setting.notna(), "").astype(str)
    lines = ["# Accuracy against cost: what the frontiers say\n"]
    lines += [f"**{plan['note']}**\n"] if plan["note"] else []
    weight = plan["accuracy"]["membrane_update_weight"]
    lines.append(
        "Errors are largest deviations from the limit of another scheme, over all points or at the point "
        "named; settings that fail at one point are recommended at none. Work is counted in updates of fluid "
        f"nodes; a membrane node counts {weight:g}. Seconds are those of "
        "one core.\n"
    )
    found = measured_weight(load_runs(arguments.plan, arguments.runs, "accuracy-passages"))
    lines += [f"{found}\n"] if found else []
    judged = judged_points(table)
    places = {point: "" if point == ALL else f", {point}" for point in judged.point}
    sound = usable(judged)
    for (study, kind, point), rows in sound.groupby(["study", "error_kind", "point"], sort=False):
        lines += [f"## {study}: {kind}{places[point]}\n", *goals_of(rows), ""]
    for (study, point), rows in judged.groupby(["study", "point"], sort=False):
        failures = list(failures_of(rows))
        lines += [f"## {study}{places[point]}: not usable\n", *failures, ""] if failures else []
    lines += [*presets_of(table), "", *ladders_of(table), *check_of(read_table(arguments.check))]
    Path(arguments.output).write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
