"""Prints the rules that make figures and pages from tables alone, one a line."""

from study.planning.redraw import drawing_rules

print("\n".join(drawing_rules()))
