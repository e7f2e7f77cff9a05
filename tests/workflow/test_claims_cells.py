"""What the checks of the claims on cells in the array find, at the edges of the criteria."""

import pandas as pd
import pytest
from claim_tables import NUMBERS, SHIFTS, bracket, grade_of, judged, passage, tables
from study.paper.claims import Undecidable, load_claims
from study.paper.grades import CONTRADICTS, HOLDS, NOT_REPRODUCED, NOT_RUN, REPRODUCED


@pytest.fixture(scope="module")
def claims(root):
    return load_claims(root / "params/claims.json")


@pytest.fixture
def grade(claims):
    """The grade of a claim by tables of the default reading, with some classes changed."""

    def found(name, changed=(), given=None):
        given = given or tables()
        for (shift, number), label in dict(changed).items():
            put(given, shift, number, "class", label)
        return grade_of(claims, name, given)

    return found


def put(given, shift, number, column, value):
    """Changes a cell of the grid."""
    rows = given["passages"]
    at = (rows.sweep == "grid") & (rows.row_shift_um == shift) & (rows.capillary_number == number)
    assert at.sum() == 1
    rows.loc[at, column] = value


def zigzag_from(shift, capillary):
    """The classes of a row shift that switches at a capillary number."""
    return {(shift, ca): "zigzag" if ca >= capillary else "displaced" for ca in NUMBERS}


def test_a_switch_of_class_near_the_printed_one_holds(grade):
    assert grade("eps-11-soft-zigzag", zigzag_from(4.4, 1.2)) == REPRODUCED
    assert grade("eps-11-soft-zigzag", zigzag_from(4.4, 1.0)) == HOLDS  # at 0.9
    assert grade("eps-13-zigzag", zigzag_from(5.2, 0.5)) == REPRODUCED
    assert grade("eps-13-zigzag", zigzag_from(5.2, 0.6)) == HOLDS  # at 0.55
    assert grade("eps-13-zigzag", zigzag_from(5.2, 0.7)) == NOT_REPRODUCED  # at 0.65
    mixed = {(5.2, 0.4): "zigzag", (5.2, 0.5): "displaced"}
    assert grade("eps-13-zigzag", mixed) == NOT_REPRODUCED  # it does not switch once


def test_the_print_contradicts_itself_where_the_other_statement_holds(grade):
    assert grade("eps-11-soft-zigzag", zigzag_from(4.4, 0.8)) == CONTRADICTS  # as by Eq. (5)
    assert grade("eps-11-soft-zigzag", zigzag_from(4.4, 0.6)) == NOT_REPRODUCED
    assert grade("eps-11-soft-zigzag", zigzag_from(4.4, 1.9)) == NOT_REPRODUCED
    assert grade("eps-17-stiff-displaced", zigzag_from(6.8, 0.2)) == REPRODUCED
    assert grade("eps-17-stiff-displaced", zigzag_from(6.8, 0.5)) == NOT_REPRODUCED


def test_an_undecided_class_counts_against_nothing_and_for_nothing(claims, grade):
    assert grade("eps-5-all-displaced", {(2.0, 0.1): "undecided", (2.0, 1.5): "zigzag"}) == NOT_REPRODUCED
    with pytest.raises(Undecidable, match=r"d = 2, Ca = 0\.1"):
        grade("eps-5-all-displaced", {(2.0, 0.1): "undecided"})
    given, other = tables(brackets=[bracket("other", 2.0, 1.2, None)]), {"id": "other", "series": "other"}
    with pytest.raises(Undecidable, match=r"d = 2, Ca = 1\.5"):  # beyond what the bracket tried
        judged(claims, "eps-5-all-displaced", given, other)


def test_the_boundary_holds_within_a_row_of_the_printed_diagram_and_the_text_stands_against_it(claims, grade):
    text = [
        bracket("default", said["row_shift_um"], said["displaced_to"], said["zigzag_from"])
        for said in claims["phase-boundary"]["statements"]
    ]

    def moved(by, brackets=text):
        given = tables()
        given["phase_boundary"] = pd.DataFrame(brackets)
        given["fits"].loc[given["fits"].parameter == "offset_um", "value"] += by
        return grade("phase-boundary", given=given)

    assert [moved(by) for by in (0.0, 0.39, 0.41, 0.79)] == [REPRODUCED, REPRODUCED, HOLDS, HOLDS]
    assert moved(0.81) == CONTRADICTS
    wrong = [*text[:-1], bracket("default", 8.8, 0.1, 0.2)]
    assert moved(0.81, wrong) == moved(0.81, text[1:]) == NOT_REPRODUCED
    given = tables()
    given["fits"] = given["fits"][given["fits"].name != "boundary/default"]
    with pytest.raises(Undecidable, match="1 row shifts"):
        grade("phase-boundary", given=given)
    given["phase_boundary"] = given["phase_boundary"].assign(dx_um=0.8)
    assert grade("phase-boundary", given=given) == NOT_RUN


def test_the_window_may_end_one_row_later(grade):
    assert grade("window") == REPRODUCED
    assert grade("window", {(8.0, 0.1): "displaced"}) == HOLDS
    assert grade("window", {(8.8, 0.1): "displaced"}) == NOT_REPRODUCED  # no end there
    assert grade("window", {(3.2, 1.5): "zigzag"}) == NOT_REPRODUCED  # 1.2 um
    with pytest.raises(Undecidable, match=r"d = 8 um"):
        grade("window", {(8.0, 0.1): "undecided"})


def test_the_design_example_holds_while_the_middle_of_its_window_separates(grade):
    assert grade("design-example") == REPRODUCED
    assert grade("design-example", zigzag_from(5.2, 0.4)) == HOLDS  # the upper edge between 4.4 and 5.2 um
    soft = dict.fromkeys([(3.6, 1.2), (4.4, 1.2)], "displaced")
    assert grade("design-example", soft) == HOLDS  # the lower edge there
    assert grade("design-example", soft | zigzag_from(5.2, 0.4)) == NOT_REPRODUCED
    far = {(6.0, 0.4): "displaced", (6.8, 0.4): "displaced"}  # 6.8 to 7.2 um instead of 5.5
    assert grade("design-example", soft | far) == NOT_REPRODUCED
    with pytest.raises(Undecidable):
        grade("design-example", {(4.4, 1.2): "undecided"})


def with_speed(ratio):
    """Tables in which the cell of Ca = 0.3 at d = 6.0 um has this part of the speed of Ca = 0.1."""
    given = tables()
    put(given, 6.0, 0.3, "speed_um_per_kilostep", 6.0 * ratio)
    return given


def test_a_slower_cell_holds_if_it_loses_half_the_printed_speed(grade):
    name = "slow-near-boundary"
    found = [grade(name, given=with_speed(ratio)) for ratio in (0.5, 0.6, 0.75, 0.76, 0.25, 0.24)]
    assert found == [REPRODUCED, REPRODUCED, HOLDS, NOT_REPRODUCED, HOLDS, NOT_REPRODUCED]
    assert grade(name, {(6.0, 0.3): "zigzag"}, with_speed(0.5)) == NOT_REPRODUCED
    with pytest.raises(Undecidable):
        grade(name, {(6.0, 0.3): "undecided"}, with_speed(0.5))


def with_extents(off):
    """Tables with the printed D_perp at d = 6.8 um, off by so much at the softest cell."""
    given = tables()
    for number, extent in {0.15: 6.7, 0.3: 5.8, 0.7: 4.6, 1.2: 3.8 + off}.items():
        put(given, 6.8, number, "d_perp_um", extent)
    return given


def test_an_extent_holds_within_a_lattice_spacing_and_with_the_printed_classes(grade):
    found = [grade("d-perp-6.8", given=with_extents(off)) for off in (0.09, 0.2, 0.39, 0.41)]
    assert found == [REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]
    assert grade("d-perp-6.8", {(6.8, 0.3): "displaced"}, with_extents(0.0)) == NOT_REPRODUCED
    assert grade("d-perp-6.8", {(6.8, 0.7): "diverged"}, with_extents(0.2)) == NOT_REPRODUCED
    with pytest.raises(Undecidable, match="diverged"):
        grade("d-perp-6.8", {(6.8, 1.2): "diverged"}, with_extents(9.0))


def with_spread(spread, others):
    """Tables in which one cell leaves the curve within the window and all outside it by others."""
    given = tables()
    for shift in (2.0, 3.2, 8.0, 8.8):
        for number in NUMBERS:
            put(given, shift, number, "d_perp_um", 7.0 - 2.5 * number + others)
    put(given, 6.0, 0.7, "d_perp_um", 7.0 - 2.5 * 0.7 + spread)
    return given


def test_a_collapse_holds_within_a_lattice_spacing_of_a_curve_that_the_others_leave(grade):
    found = [grade("collapse", given=with_spread(spread, 1.0)) for spread in (0.39, 0.41, 0.79, 0.81)]
    assert found == [REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]
    assert grade("collapse", given=with_spread(0.39, 0.3)) == NOT_REPRODUCED
    assert grade("collapse", given=with_spread(0.5, 0.45)) == HOLDS
    assert grade("collapse", given=with_spread(0.6, 0.45)) == NOT_REPRODUCED


def test_a_master_curve_holds_within_the_error_bar_of_the_experiment(grade):
    def above(by):
        given = tables()
        rows = given["passages"]
        rows["d_perp_um"] = 8 - 0.901 * rows.capillary_number + by  # the tweezer's diameter
        return grade("tweezer-master-curve", given=given)

    found = [above(by) for by in (0.39, -0.39, 0.41, 0.69, -0.71)]
    assert found == [REPRODUCED, REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]


def test_a_separation_holds_with_another_factor_if_it_is_sharp(grade):
    def factor(value, wrong=0):
        given = tables()
        rows = given["passages"]
        side = (rows["class"] == "displaced") * 0.06 - 0.03
        side.iloc[:wrong] *= -1
        rows["d_perp_um"] = 5.4 * value + side
        return grade("sharp-separation", given=given)

    found = [factor(value) for value in (1.08, 1.10, 1.12, 1.16, 1.17, 1.0, 0.99)]
    assert found == [REPRODUCED, REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED, HOLDS, NOT_REPRODUCED]
    assert factor(1.08, wrong=12) == NOT_REPRODUCED


def test_a_prediction_holds_if_it_misses_within_a_row_of_the_boundary(grade):
    def miss(share):
        given = tables()
        given["a_priori"].loc[0, ["right_tweezer", "tweezer_um"]] = [0.0, 5.0 * (1 + share)]
        return grade("a-priori", given=given)

    found = [miss(share) for share in (0.0, 0.079, 0.081, -0.119, 0.121)]
    assert found == [REPRODUCED, REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]


def test_cells_keep_away_with_half_a_spacing_if_the_others_come_closer(grade):
    def films(outside, inside):
        given = tables()
        put(given, 8.8, 0.1, "film_um", outside)
        put(given, 6.0, 0.1, "film_um", inside)
        return grade("open-symbols", given=given)

    assert films(0.4, 0.5) == REPRODUCED
    assert [films(0.21, 0.2), films(0.21, 0.22), films(0.19, 0.1)] == [HOLDS, NOT_REPRODUCED, NOT_REPRODUCED]


def test_inertia_holds_while_it_is_not_another_capillary_number(grade):
    def change(share, label="zigzag"):
        runs = [passage("inertia", 6.8, 0.7, label, d_perp_um=5.0 * (1 + share))]
        return grade("inertia", given=tables([*runs, passage("inertia-quarter", 6.8, 0.7, d_perp_um=5.0)]))

    found = [change(share) for share in (0.0099, 0.0101, -0.039, 0.041)]
    assert found == [REPRODUCED, HOLDS, HOLDS, NOT_REPRODUCED]
    assert change(0.0, "displaced") == NOT_REPRODUCED
    assert grade("inertia") == NOT_RUN


def test_a_claim_on_classes_needs_every_row_shift(grade):
    given = tables()
    rows = given["passages"]
    given["passages"] = rows[rows.row_shift_um != SHIFTS[-1]]
    assert grade("eps-20-22-all-zigzag", given=given) == grade("window", given=given) == NOT_RUN
    assert grade("eps-20-22-all-zigzag", {(8.0, 0.1): "displaced"}, given) == NOT_REPRODUCED
