"""Which rules make figures and pages from tables alone, so that they can run without a solver or its runs:
told by the rules themselves, so that a new figure is in no other list."""

import re
from pathlib import Path

RULES = Path("workflow/rules")
#: Words of a rule that reads runs, brackets or the solver.
READS_RUNS = r"of_runs|RUNS\b|BRACKET|DLD|--runs"
#: Rules whose program stands elsewhere: the target itself, the article, which is LaTeX's, and a study's page.
OTHERS = {"redraw", "paper", "study_page"}


def rules_in(text):
    """{name: text} of the rules of a file."""
    parts = re.split(r"^ *rule (\w+):\n", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def drawing_rules(folder=RULES):
    """Names of the rules that draw or write from tables alone, sorted."""
    rules = {}
    for path in sorted(Path(folder).rglob("*.smk")):
        rules |= rules_in(path.read_text(encoding="utf-8"))
    return sorted(
        name
        for name, text in rules.items()
        if name in OTHERS
        or (re.search(r"\{SCRIPTS\}/(drawing|paper)/", text) and not re.search(READS_RUNS, text))
    )
