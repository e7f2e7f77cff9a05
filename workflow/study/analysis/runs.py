"""Reading what solver runs left behind: results/runs/<id>/{case.json,run.h5,summary.json,benchmark.tsv}."""

import csv
import json
import re
import zlib
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from study.planning.documents import read_json
from study.planning.plan_file import study_brackets

#: What the solver writes behind the HDF5 data: length and CRC-32 of every byte before it.
SEAL_BEGIN = b"\ndld seal "
SEAL = re.compile(re.escape(SEAL_BEGIN) + rb"([0-9a-f]{16}) ([0-9a-f]{16})\n")
SEAL_LENGTH = 44
#: Attribute of the files that end with a seal; those of earlier versions do not.
SEALED = "sealed"


class DamagedRun(ValueError):
    """The files of a run are not what the solver wrote, or do not belong together."""

    def __init__(self, path, reason):
        super().__init__(f"{path}: {reason}. Remove {path.parent} and start again: its run is made again")


def seal_holds(path):
    """Whether a file ends with a seal and has every byte that it had then; None for a file without a seal."""
    content = path.read_bytes()
    found, data = content[-SEAL_LENGTH:], memoryview(content)[:-SEAL_LENGTH]
    if not found.startswith(SEAL_BEGIN):
        return None
    seal = SEAL.fullmatch(found)
    return bool(seal) and [int(part, 16) for part in seal.groups()] == [len(data), zlib.crc32(data)]


def differing(part, whole, place=""):
    """Places where a case differs from a more complete one; `epsilon` is another way of giving a length."""
    for name, value in part.items():
        if name == "epsilon":
            continue
        if isinstance(value, dict):
            yield from differing(value, whole.get(name, {}), f"{place}/{name}")
        elif whole.get(name, value) != value:
            yield f"{place}/{name}"


def opened(path):
    """The HDF5 file of a finished run, for a `with`; DamagedRun if it is not as it was written."""
    broken = "has changed since it was written: its seal is broken"
    try:
        seal = seal_holds(path)
        if seal is False:
            raise DamagedRun(path, broken)
        file = h5py.File(path, "r")
    except FileNotFoundError:
        raise DamagedRun(path, "is not there") from None
    except OSError:
        raise DamagedRun(path, "is not a complete HDF5 file") from None
    if SEALED in file.attrs and not seal:
        file.close()
        raise DamagedRun(path, broken)
    return file


def checked_summary(folder, case=None):
    """summary.json of a finished run; DamagedRun if its run.h5 says otherwise, or is of another case."""
    path, run = folder / "summary.json", folder / "run.h5"
    try:
        summary = read_json(path)
    except FileNotFoundError:
        raise DamagedRun(path, "is not there") from None
    except ValueError:
        raise DamagedRun(path, "is empty or no JSON") from None
    with opened(run) as file:
        attributes = {
            name: json.loads(file.attrs[name]) for name in ("summary", "case") if name in file.attrs
        }
    if attributes.get("summary", summary) != summary:
        raise DamagedRun(path, "is not the summary in run.h5: it was changed, or is of another run")
    if case is not None and (places := list(differing(case, attributes.get("case", case)))):
        raise DamagedRun(run, f"is of another case: {', '.join(places)} differ")
    return summary


@dataclass(frozen=True)
class Run:
    """One run of the plan and the folder of its results."""

    id: str
    group: str
    labels: dict
    case: dict
    folder: Path

    @property
    def summary(self):
        return checked_summary(self.folder, self.case)

    @property
    def dx_um(self):
        return self.case["fluid"]["lattice_spacing_um"]

    @property
    def pitch_across_um(self):
        """Distance of neighbouring lanes, um."""
        geometry = self.case["geometry"]
        return geometry.get("pitch_y_um", geometry["pitch_um"])

    @property
    def row_shift_um(self):
        geometry = self.case["geometry"]
        return geometry.get("row_shift_um", geometry.get("epsilon", 0.0) * self.pitch_across_um)

    @property
    def epsilon(self):
        return self.row_shift_um / self.pitch_across_um

    def open(self):
        """The run's HDF5 file, to be used in a `with`."""
        return opened(self.folder / "run.h5")

    def data(self, name):
        """One dataset, or None if the run did not write it."""
        with self.open() as file:
            return np.asarray(file[name]) if name in file else None

    def provenance(self):
        with self.open() as file:
            return json.loads(file.attrs["provenance"])

    def core_s(self):
        """Seconds of a core that the run took by Snakemake's benchmark; None if there is none. Where other
        programs ran beside it, the clock says nothing; the load that was seen turns it into a core's."""
        path = self.folder / "benchmark.tsv"
        if not path.exists():
            return None
        with path.open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file, delimiter="\t"))
        if not rows:
            return None
        clock, load = float(rows[-1]["s"]), float(rows[-1].get("mean_load") or 0)
        return clock * load / 100 if load > 0 else clock


def load_runs(plan_path, folder, group):
    """The runs of one group of a plan."""
    plan = read_json(plan_path)
    return [Run(folder=Path(folder) / run["id"], **run) for run in plan["runs"] if run["group"] == group]


def bracket_runs(plan_path, brackets, folder):
    """Every run of the final state of every bracket, labelled as sweep boundary/<series>."""
    for name, definition in study_brackets(read_json(plan_path)).items():
        state = read_json(Path(brackets) / name / f"level-{definition['levels']}.json")
        labels = {"sweep": f"boundary/{definition['series']}"}
        labels |= {name: definition[name] for name in ("device", "cell")}
        for point in state["points"]:
            place = Path(folder) / point["run"]
            yield Run(point["run"], "boundary", labels, read_json(place / "case.json"), place)


def passage_runs(plan_path, brackets, folder):
    """All passages of the study: those of the sweeps and those of the brackets."""
    return [*load_runs(plan_path, folder, "passages"), *bracket_runs(plan_path, brackets, folder)]
