"""The built solver and a passage of seconds, for the tests that run it."""

import os
from pathlib import Path

import pytest

DLD = Path(os.environ.get("DLD", Path(__file__).resolve().parents[2] / "build/dld"))
needs_solver = pytest.mark.skipif(not DLD.exists(), reason="the solver is not built")
PASSAGE = {
    "scene": "passage",
    "geometry": {"row_shift_um": 8.8},
    "fluid": {"lattice_spacing_um": 0.8, "relaxation_time": 1.0, "force_density": 0.0009},
    "cell": {"capillary_number": 0.7, "mesh_frequency": 5},
    "stop": {"max_rows": 3},
}
