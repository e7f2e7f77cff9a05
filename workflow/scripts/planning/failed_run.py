"""The files of a run that failed: its status and why, no data. Tables show it as a row without numbers."""

import argparse
import json
from pathlib import Path

import h5py
from study.planning.failures import FAILED

parser = argparse.ArgumentParser(description=__doc__)
for name in ("--case", "--output", "--summary", "--log", "--status"):
    parser.add_argument(name, required=True)
arguments = parser.parse_args()

lines = Path(arguments.log).read_text(encoding="utf-8", errors="replace").splitlines()
reason = f"exit status {arguments.status}: {' '.join(lines[-3:])}"
with h5py.File(arguments.output, "w") as file:
    file.attrs["status"] = FAILED
    file.attrs["provenance"] = "{}"
scene = json.loads(Path(arguments.case).read_text(encoding="utf-8"))["scene"]
summary = {"scene": scene, "status": FAILED, "reason": reason}
Path(arguments.summary).write_text(json.dumps(summary, indent=2) + "\n", encoding="utf-8")
