"""Writes the list of the software of the study: CycloneDX JSON."""

import argparse
from pathlib import Path

from study.analysis.software import as_text, project_version, software_list

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", required=True)
arguments = parser.parse_args()
Path(arguments.output).write_text(as_text(software_list(project_version())), encoding="utf-8")
