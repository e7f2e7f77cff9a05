"""The page of the results: words of the template, numbers of the tables of a tier."""

import os
import tomllib
from pathlib import Path

import pandas as pd
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.paper import results_page
from study.paper.claims import SWEEP
from study.paper.templates import filled
from study.planning.documents import read_json


def context(arguments):
    """What the template fills in."""
    tables = Path(arguments.results) / "tables"
    folder = Path(arguments.output).parent
    found = {path.stem: read_table(path) for path in sorted(tables.glob("*.csv"))}
    verdicts, printed = pd.read_csv(arguments.verdicts, dtype=str), read_json(arguments.claims)
    declared = tomllib.loads(Path(arguments.numbers).read_text(encoding="utf-8"))["numbers"]
    law = next(claim for claim in printed["claims"] if claim["id"] == "phase-boundary")
    numbers = [
        results_page.declared_number(declared, found, f"cells/{SWEEP}/{which}")
        for which in ("all", "as-printed")
    ]
    uncertainty = found.get("boundary_uncertainty")  # made on request
    return {
        "note": read_json(arguments.plan)["note"],
        "root": os.path.relpath(Path(arguments.root), folder),
        "results": os.path.relpath(Path(arguments.results), folder),
        "results_name": Path(arguments.results).name,
        "verdicts": results_page.verdicts(verdicts),
        "claim": lambda name: results_page.claim_line(verdicts, name),
        "known": lambda *values: None not in values,
        "named": numbers[0],
        "as_printed": numbers[1],
        "boundary": results_page.boundary(found["phase_boundary"], law),
        "readings": results_page.readings(printed["readings"]),
        "doubts": results_page.doubts(uncertainty),
        "uncertain": uncertainty is not None,
        "cells": results_page.finer_cells(found.get("lattice_cells")),
        "lattices": results_page.lattices(found.get("boundary_lattices")),
        "starts": results_page.starts(found["second_starts"]),
        "rules": results_page.rules(found["a_priori_summary"]),
        "times": results_page.times(found["stage_times"]),
    }


def main():
    names = ["plan", "results", "verdicts", "claims", "numbers", "template", "root", "output"]
    arguments = required_arguments(__doc__, *names)
    page = filled(arguments.template, context(arguments), keep_trailing_newline=True)
    Path(arguments.output).write_text(page, encoding="utf-8")


main()
