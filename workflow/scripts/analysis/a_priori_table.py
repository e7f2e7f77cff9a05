"""The class of every passage against what is known without it: the transverse diameter of the tweezer
at Ca_tw = Ca against D_cr = 2 s (displaced if larger), with our s and with the paper's Eq. (4); and
against two rules that need the passage: D_perp against 2 s, and the centre at the gap line against s.

The summary gives for each rule how often it is right and the fluid work behind it.
"""

from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.runs import checked_summary
from study.analysis.tables import read_table, write_table
from study.analysis.tweezer import SeparationCurve, TweezerCurve
from study.paper.claims import load_claims
from study.planning.classes import DECIDED

COLUMNS = [
    "sweep",
    "device",
    "cell",
    "dx_um",
    "lateral_flow",
    "skalak_denominator",
    "row_shift_um",
    "capillary_number",
    "class",
]
COLUMNS += ["s_um", "s_variant", "printed_d_cr_um", "tweezer_um", "d_perp_um", "centre_um"]
RULES = ["tweezer", "tweezer_printed_law", "d_perp", "centre"]
COLUMNS += [f"predicted_{rule}" for rule in RULES] + [f"right_{rule}" for rule in RULES] + ["run"]
SUMMARY = ["sweep", "rule", "right", "wrong", "left_out", "hit_rate", "node_updates"]
STYLES = {"dx_um": ".4f", "row_shift_um": ".1f", "capillary_number": ".4g", "hit_rate": ".4f"}
STYLES |= dict.fromkeys(["s_um", "printed_d_cr_um", "tweezer_um", "d_perp_um", "centre_um"], ".3f")
STYLES |= {"node_updates": ".4e"}


def variant_for(row, separation):
    """The variant of the flow with the device and the settings of a passage: interpolated walls, its
    lattice, its lateral flow; without one, the refined limit."""
    if row["lateral_flow"] == "blocked":
        return "blocked-lateral"
    accurate = separation[
        separation.variant.str.startswith("accurate") & (separation.device == row["device"])
    ]
    same = accurate[(accurate.dx_um - row["dx_um"]).abs() < 1e-3]
    return same.variant.iloc[0] if len(same) else "refined"


def larger(extent, limit):
    """displaced, zigzag, or None where a number is missing."""
    if extent != extent or limit != limit:
        return None
    return "displaced" if extent > limit else "zigzag"


def row_of(row, separation, distances, tweezer, law):
    """Table row of one passage."""
    variant = variant_for(row, separation)
    s = distances.distance(row["device"], variant, row["row_shift_um"])
    diameter = tweezer.diameter(row["capillary_number"], row["skalak_denominator"])
    printed = law["A_um"] * row["epsilon"] ** law["B"]
    predictions = {
        "tweezer": larger(diameter, 2 * s),
        "tweezer_printed_law": larger(diameter, printed),
        "d_perp": larger(row["d_perp_um"], 2 * s),
        "centre": larger(row["centre_um"], s),
    }
    known = row["class"] in DECIDED
    found = row | {"s_um": s, "s_variant": variant, "printed_d_cr_um": printed, "tweezer_um": diameter}
    for rule, prediction in predictions.items():
        found[f"predicted_{rule}"] = prediction
        found[f"right_{rule}"] = int(prediction == row["class"]) if known and prediction else None
    return found


def flow_work(separation, runs):
    """Node updates of the flows of a variant, all row shifts together: {variant: updates}."""
    work = {}
    for variant, rows in separation[separation.run.notna()].groupby("variant"):
        summaries = [checked_summary(Path(runs) / run) for run in rows.run]
        work[variant] = sum(summary.get("node_updates", 0) for summary in summaries)
    return work


def summary_rows(rows, work):
    """Hits and cost of every rule in every sweep. A rule of the tweezer costs the flows without a cell alone:
    the static stretching has no fluid. The others cost the passages too."""
    for sweep in sorted({row["sweep"] for row in rows}):
        members = [row for row in rows if row["sweep"] == sweep]
        flows = sum(work.get(variant, 0) for variant in {row["s_variant"] for row in members})
        passages = sum(row["node_updates"] for row in members if row["node_updates"] == row["node_updates"])
        for rule in RULES:
            judged = [row[f"right_{rule}"] for row in members if row[f"right_{rule}"] is not None]
            cost = {"tweezer": flows, "tweezer_printed_law": 0}.get(rule, flows + passages)
            yield {
                "sweep": sweep,
                "rule": rule,
                "right": sum(judged),
                "wrong": len(judged) - sum(judged),
                "left_out": len(members) - len(judged),
                "hit_rate": sum(judged) / len(judged) if judged else None,
                "node_updates": float(cost),
            }


def main():
    arguments = required_arguments(
        __doc__, "passages", "separation", "stretching", "claims", "runs", "output", "summary"
    )
    law = load_claims(arguments.claims)["separation-law"]["value"]
    separation = read_table(arguments.separation)
    given = (separation, SeparationCurve(separation), TweezerCurve(read_table(arguments.stretching)), law)
    rows = [row_of(row, *given) for row in read_table(arguments.passages).to_dict("records")]
    keys = ["sweep", "dx_um", "row_shift_um", "capillary_number"]
    write_table(rows, COLUMNS, arguments.output, keys, STYLES)
    work = flow_work(separation, arguments.runs)
    write_table(summary_rows(rows, work), SUMMARY, arguments.summary, styles=STYLES)


main()
