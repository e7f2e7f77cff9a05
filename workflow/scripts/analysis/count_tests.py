"""Adds up JUnit reports and prints "N passed, N failed"; a missing report counts as one failure."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def counts(path):
    """Numbers of passed and of failed tests of one report."""
    if not Path(path).exists():
        return 0, 1
    suites = list(ElementTree.parse(path).getroot().iter("testsuite"))
    total, bad, skipped = (
        sum(int(suite.get(name) or 0) for suite in suites for name in names)
        for names in (["tests"], ["failures", "errors"], ["skipped", "disabled"])
    )
    return total - bad - skipped, bad


passed, failed = map(sum, zip(*map(counts, sys.argv[1:]), strict=True))
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
