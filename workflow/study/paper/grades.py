"""The grade of a claim: what a check found, held against the criteria that the claim states beforehand."""

from collections import Counter

REPRODUCED = "REPRODUCED"
HOLDS = "HOLDS WITH ANOTHER VALUE"
CONTRADICTS = "PRINT CONTRADICTS ITSELF"
NOT_REPRODUCED = "NOT REPRODUCED"
NOT_DECIDED = "NOT DECIDED"
NOT_RUN = "NOT RUN"
#: Every grade and what it says.
GRADES = {
    REPRODUCED: "within the rounding of the print and our uncertainty, its tolerance",
    HOLDS: "the statement is true, its number differs, within the limit that the claim sets",
    CONTRADICTS: "it does not come out, but another printed statement that excludes it does",
    NOT_REPRODUCED: "none of these; what was measured stands beside it",
    NOT_DECIDED: "its runs were made and do not tell",
    NOT_RUN: "its runs were not made",
}
#: Grades of a claim that did not come out as printed.
OTHERWISE = (HOLDS, CONTRADICTS, NOT_REPRODUCED)
#: A difference that equals its limit but for rounding is within it.
ROUNDING = 1e-9


def counted(verdicts):
    """How often each grade was given, in words."""
    count = Counter(verdicts)
    return ", ".join(f"{count[name]} {name}" for name in GRADES)


def limit_of(claim):
    """The limit of HOLDS WITH ANOTHER VALUE in words; empty for a claim without one."""
    holds = claim.get("holds")
    return f"{with_unit(holds['limit'], holds)} ({holds['number']})" if holds else ""


def with_unit(number, holds):
    """A number of three digits in the unit of a limit."""
    return f"{number:.3g} {holds.get('unit', '')}".rstrip()


def differs(claim, finding):
    """By how much the number of a claim differs, in words, beside the limit; empty where there is none."""
    holds = claim.get("holds")
    if not holds or finding.difference is None:
        return ""
    return f"differs by {with_unit(finding.difference, holds)}, limit {with_unit(holds['limit'], holds)}"


def told_by_print(claim, finding):
    """Which of the printed statements that exclude one another hold, in words."""
    others = claim["contradictions"]
    groups = {True: [], False: [f"the claim ({claim['where']})"]}
    for other in others:
        groups[other["id"] in finding.holding].append(f"{other['statement']} ({other['where']})")
    return f"holds: {'; '.join(groups[True])}; does not hold: {'; '.join(groups[False])}"


def graded(claim, finding):
    """(grade, on what it rests in words) of a finding: the amount by which the number differs, or which of
    the contradicting statements hold."""
    if finding.reproduced:
        return REPRODUCED, ""
    holds = claim.get("holds")
    if holds and finding.difference is not None and finding.difference <= holds["limit"] * (1 + ROUNDING):
        return HOLDS, differs(claim, finding)
    if finding.holding:
        return CONTRADICTS, told_by_print(claim, finding)
    return NOT_REPRODUCED, differs(claim, finding)
