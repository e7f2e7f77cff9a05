"""What the checks of the claims on the flow, the units and the tweezer find, at the edges of the criteria."""

import pytest
from claim_tables import DEFAULT, grade_of, tables
from study.paper.claims import load_claims
from study.paper.grades import CONTRADICTS, HOLDS, NOT_REPRODUCED, REPRODUCED


@pytest.fixture(scope="module")
def claims(root):
    return load_claims(root / "params/claims.json")


@pytest.fixture
def grades(claims):
    """The grades of a claim with each of some values in a column of a table; `where` chooses its rows."""

    def found(name, table, column, values, where=None):
        result = []
        for value in values:
            given = tables()
            rows = given[table]
            rows.loc[rows.index if where is None else rows.query(where).index, column] = value
            result.append(grade_of(claims, name, given))
        return result

    return found


FLOW = "streamline_separation"
PAPER = "variant == 'paper'"
FIRST = "variant == 'paper' and row_shift_um == 2.0"
EDGES = [REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]


def test_the_mobility_holds_to_what_the_paper_calls_the_same(grades):
    values = [2.9e-5, 3.1e-5, -9.9e-3, 1.01e-2]
    assert grades("stokes-linear", "stokes_checks", "relative_change", values) == EDGES


def test_streamlines_hold_to_the_printed_digits(grades, claims):
    assert grades("stokes-mirror", "stokes_checks", "reversal_max_high", [0.0099, 0.011]) == EDGES[:2]
    given = tables()
    given["stokes_checks"]["reversal_max_high"] = 0.011
    given["stokes_checks"]["s_upper_um_high"] = 1.2 + 0.051
    assert grade_of(claims, "stokes-mirror", given) == NOT_REPRODUCED


def test_the_reynolds_number_is_that_of_the_printed_resistance(grades):
    assert grades("reynolds", FLOW, "reynolds_number", [0.756, 0.754, 0.723, 0.70]) == EDGES
    assert grades("reynolds", FLOW, "reynolds_number", [0.476, 0.478]) == [CONTRADICTS, NOT_REPRODUCED]


def test_the_resistance_holds_to_the_depth_of_a_device_and_if_it_is_the_same_for_all(grades):
    column = "resistance_Pa_s_per_m2"
    assert grades("resistance", FLOW, column, [8.84e8, 8.86e8, 8.37e8, 8.35e8], PAPER) == EDGES
    assert grades("resistance", FLOW, column, [8.8e8 * 1.011, 8.8e8 * 1.012], FIRST) == [
        REPRODUCED,
        NOT_REPRODUCED,
    ]
    assert grades("device-pressure", FLOW, column, [8.7e8, 8.6e8, 8.56e8, 8.54e8], PAPER) == EDGES


def test_distances_hold_to_half_a_lattice_spacing(grades):
    assert grades("table-1", FLOW, "s_um", [1.249, 1.251, 1.01, 0.99], FIRST) == EDGES


def test_the_law_of_separation_holds_to_the_papers_own_correction(grades):
    law = "name == 'separation-law/paper' and parameter == 'A_um'"
    assert grades("separation-law", "fits", "value", [19.6, 19.8, 20.7, 20.8], law) == EDGES


def test_the_area_holds_to_what_a_membrane_keeps(grades):
    values = [8.724, 8.735, 8.80, 8.81]
    assert grades("cell-area", "stretching", "area_over_radius_squared", values) == EDGES


def test_the_tweezer_holds_to_two_error_bars(grades):
    at = "force_pN == 50.0"  # where the experiment has 10 um and an error bar of 1 um
    assert grades("tweezer", "stretching", "axial_um", [10.9, 11.1, 8.1, 12.1], at) == EDGES


def test_units_contradict_the_printed_definition(claims, grades):
    assert grade_of(claims, "unit-conversion", tables()) == CONTRADICTS
    factor = DEFAULT | {"capillary_factor": 1.6}
    assert grade_of(claims, "unit-conversion", tables(), factor) == REPRODUCED
    other = DEFAULT | {"capillary_factor": 1.3}
    assert grade_of(claims, "unit-conversion", tables(), other) == NOT_REPRODUCED
