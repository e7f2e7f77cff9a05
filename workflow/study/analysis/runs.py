"""Reading what solver runs left behind: results/runs/<id>/{case.json,run.h5,summary.json,benchmark.tsv}."""

import csv
import json
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from study.planning.plan import read_json, study_brackets


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
        return read_json(self.folder / "summary.json")

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
        return h5py.File(self.folder / "run.h5", "r")

    def data(self, name):
        """One dataset, or None if the run did not write it."""
        with self.open() as file:
            return np.asarray(file[name]) if name in file else None

    def provenance(self):
        with self.open() as file:
            return json.loads(file.attrs["provenance"])

    def wall_s(self):
        """Seconds that the run took by Snakemake's benchmark; None if there is none."""
        path = self.folder / "benchmark.tsv"
        if not path.exists():
            return None
        with path.open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file, delimiter="\t"))
        return float(rows[-1]["s"]) if rows else None


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
