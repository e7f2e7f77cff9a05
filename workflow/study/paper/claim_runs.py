"""The runs behind a claim made again: their cases, and what the committed tables say of each.

Passages are compared by their row of passages.csv (spot_check); flows without a cell and stretched cells by
the numbers of their rows. A run that stands in no table by itself, such as those of the Stokes checks, is
compared with the study's own run where that is there.
"""

from study.analysis.spot_check import ALIKE, CLOSE, OTHER, SAME, case_of, planned_case

#: Table of a scene: its numbers by the key of the summary, with their format.
NUMBERS = {
    "streamlines": (
        "streamline_separation",
        {"s_um": ("separation_um", ".4f"), "resistance_Pa_s_per_m2": ("resistance_Pa_s_per_m2", ".5e")},
    ),
    "stretching": (
        "stretching",
        {"axial_um": ("axial_um", ".4f"), "transverse_um": ("transverse_um", ".4f")},
    ),
}


def runs_of_claim(verdicts, claim):
    """Identities of the runs of a claim in the table of verdicts; a ValueError where it has none."""
    rows = verdicts[verdicts.id == claim]
    runs = "" if rows.empty else str(rows.iloc[0]["runs"])
    if not runs or runs == "nan":
        known = ", ".join(verdicts.id[verdicts.runs.notna()])
        raise ValueError(f"claim={claim}: no runs of it are in the table of verdicts; those of {known} are")
    return runs.split()


def case_of_run(run, passages, plan):
    """The resolved case of a run of the study: of the plan, or of a bracket by its row of passages.csv."""
    rows = passages[passages.run == run]
    if len(rows):
        return case_of(rows.iloc[0].to_dict(), plan)
    found = planned_case(run, plan)
    if found is None:
        raise ValueError(f"run {run} is in no table of passages and not in params/studies/krueger2014.json")
    return found


def as_list(value):
    """A number as a list of one."""
    return value if isinstance(value, list) else [value]


def judged(before, after):
    """(verdict, names that differ) of two dictionaries of texts of numbers."""
    names = [name for name in before if before[name] != after.get(name)]
    if not names:
        return SAME, names
    try:
        close = all(
            abs(float(a) - float(b)) <= CLOSE * abs(float(a))
            for name in names
            for a, b in zip(before[name], after.get(name, []), strict=True)
        )
    except ValueError:
        close = False
    return (ALIKE if close else OTHER), names


def numbers_of(summary, scene):
    """Texts of the numbers of a summary, as the table of its scene shows them."""
    _, columns = NUMBERS[scene]
    return {name: [format(x, style) for x in as_list(summary[key])] for name, (key, style) in columns.items()}


def numbers_in(table, run, scene):
    """The same of the rows of a run in the table of its scene; empty where it has none."""
    _, columns = NUMBERS[scene]
    rows = table[table.run == run]
    if scene == "streamlines":
        rows = rows.head(1)
    shown = {name: [format(float(x), style) for x in rows[name]] for name, (_, style) in columns.items()}
    return shown if len(rows) else {}
