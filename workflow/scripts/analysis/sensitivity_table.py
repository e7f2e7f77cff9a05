"""What every choice of the sensitivity study changes: D_perp at the points of Fig. 8, the critical capillary
number, and s. Choices of which crossing and which instant define D_perp are read from the default runs."""

import math

from study.analysis.arguments import table_arguments
from study.analysis.runs import load_runs
from study.analysis.tables import read_table, write_table
from study.planning.documents import read_json
from study.planning.points import choices

COLUMNS = [
    "choice",
    "value",
    "observable",
    "row_shift_um",
    "capillary_number",
    "result",
    "low",
    "high",
    "class",
]
COLUMNS += ["change", "relative_change", "unit", "runs"]
STYLES = dict.fromkeys(["result", "low", "high", "change", "relative_change"], ".4f")
STYLES |= {"row_shift_um": ".1f", "capillary_number": ".4g"}
DEFAULT = ("default", "")


def row(choice, value, observable, result, unit, runs, **others):
    return {
        "choice": choice,
        "value": value,
        "observable": observable,
        "result": result,
        "unit": unit,
        "runs": runs,
    } | others


def d_perp_rows(run):
    """D_perp of one run, and for the default settings by every reading of the definition."""
    choice, value = run.labels["choice"], run.labels["value"]
    place = {name: run.labels[name] for name in ("row_shift_um", "capillary_number")}
    place |= {"class": run.summary["status"]}
    observable = f"d_perp(d={place['row_shift_um']:g}, Ca={place['capillary_number']:g})"

    def one(choice, value, result):
        return row(choice, value, observable, result, "um", run.id, **place)

    yield one(choice, value, run.summary.get("d_perp_um"))
    widths = run.data("crossings/d_perp_um")
    if (choice, value) != DEFAULT or widths is None or len(widths) < 2:
        return
    yield one("instant", "centre on the gap line", run.summary.get("d_perp_at_centre_um"))
    settled = widths[1:]  # the start shapes the first crossing
    readings = {
        "last": settled[-1],
        "narrowest": settled.min(),
        "widest": settled.max(),
        "mean": settled.mean(),
    }
    for name, width in readings.items():
        yield one("crossing", name, float(width))


def separation_rows(run, default_runs):
    """s of one flow without a cell; none for a choice that does not change the flow."""
    choice, value, shift = (run.labels[name] for name in ("choice", "value", "row_shift_um"))
    if (choice, value) == DEFAULT or run.id != default_runs[shift]:
        s = run.summary.get("separation_um")
        yield row(choice, value, f"s(d={shift:g})", s, "um", run.id, row_shift_um=shift)


def critical_rows(choice, value, entry, boundary, settings):
    """Critical capillary number of one choice at the row shifts asked for: middle and ends of the bracket."""
    factor = entry.get("capillary_factor", 1)
    series = entry.get("series", settings["reference"])
    if (choice, value) != DEFAULT and "series" not in entry and entry["case"]:
        series = f"sensitivity/{choice}/{value}"
    elif (choice, value) != DEFAULT and factor == 1 and "series" not in entry:
        return
    rows = boundary[(boundary.series == series) & boundary.row_shift_um.isin(settings["row_shifts_um"])]
    for found in rows.to_dict("records"):
        low, high = found["ca_displaced"] / factor, found["ca_zigzag"] / factor
        place = {"row_shift_um": found["row_shift_um"], "class": found["status"], "low": low, "high": high}
        name, middle = f"critical_ca(d={found['row_shift_um']:g})", math.sqrt(low * high)
        yield row(choice, value, name, middle, "1", found["runs"], **place)


def with_changes(rows):
    """The rows with their difference from the default settings."""
    default = {found["observable"]: found["result"] for found in rows if found["choice"] == "default"}
    for found in rows:
        reference, result = default.get(found["observable"]), found["result"]
        if found["choice"] != "default" and None not in (reference, result):
            change = result - reference
            found = found | {"change": change, "relative_change": change / reference}
        yield found


def main():
    arguments = table_arguments(__doc__, "boundary")
    tier = read_json(arguments.plan)
    runs = load_runs(arguments.plan, arguments.runs, "sensitivity")
    rows = [found for run in runs for found in d_perp_rows(run)]
    flows = load_runs(arguments.plan, arguments.runs, "sensitivity-flow")
    labels = [(run.labels["choice"], run.labels["value"]) for run in flows]
    pairs = list(zip(flows, labels, strict=True))
    default_runs = {run.labels["row_shift_um"]: run.id for run, label in pairs if label == DEFAULT}
    rows += [found for run in flows for found in separation_rows(run, default_runs)]
    boundary = read_table(arguments.boundary)
    for choice, value, entry in choices(tier):
        rows += critical_rows(choice, value, entry, boundary, tier["sensitivity"]["boundary"])
    keys = ["choice", "value", "observable"]
    write_table(list(with_changes(rows)), COLUMNS, arguments.output, keys, STYLES)


main()
