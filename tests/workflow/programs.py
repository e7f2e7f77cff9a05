"""The programs of the pipeline by name."""

from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "workflow/scripts"


def program(name):
    """The file of a program; its folder says what it is for."""
    (found,) = SCRIPTS.rglob(f"{name}.py")
    return found
