"""The command lines of the programs of the pipeline."""

import argparse


def required_arguments(description, *names):
    """The values of these options, each of them needed: files and folders, or the name of one thing."""
    parser = argparse.ArgumentParser(description=description)
    for name in names:
        parser.add_argument(f"--{name}", required=True)
    return parser.parse_args()


def table_arguments(description, *others):
    """The same for a program that turns the runs of a plan into one table; `others`: further files."""
    return required_arguments(description, "plan", "runs", "output", *others)


def figure_arguments(description, *tables):
    """The same for a figure: the plan, these tables and files, and the outputs."""
    return required_arguments(description, "plan", *tables, "csv", "output")
