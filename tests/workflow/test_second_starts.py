"""Passages from a second start are set against the right ones and counted by what became of them."""

import pandas as pd
from study.analysis.second_starts import end_pairs, grid_pairs, rows_of

POINT = {
    "device": "circle",
    "cell": "healthy",
    "dx_um": 0.4,
    "lateral_flow": "free",
    "skalak_denominator": 12,
    "capillary_number": 0.5,
}


def passages(*pairs):
    return pd.DataFrame(
        POINT | {"row_shift_um": shift, "epsilon": shift / 32, "sweep": sweep, "class": label}
        for shift, *labels in pairs
        for sweep, label in zip(("grid", "second-start"), labels, strict=True)
    )


def confirmation(*rows):
    names = ["series", "ca_displaced", "class_at_displaced", "ca_zigzag", "class_at_zigzag"]
    return pd.DataFrame(rows, columns=names).assign(confirmation="second-start")


def test_the_grid_gives_its_decided_points_only():
    table = passages(
        (4.4, "displaced", "displaced"), (6.0, "displaced", "zigzag"), (6.8, "undecided", "zigzag")
    )
    alone = pd.DataFrame([POINT | {"row_shift_um": 8.0, "epsilon": 0.25, "sweep": "grid", "class": "zigzag"}])
    pairs = grid_pairs(pd.concat([table, alone]))
    assert sorted(pairs) == [("displaced", "displaced"), ("displaced", "zigzag")]


def test_an_end_that_a_bracket_does_not_have_is_not_counted():
    table = confirmation(
        ("default", 0.5, "displaced", 0.6, "displaced"), ("default", 2.4, "displaced", None, None)
    )
    assert end_pairs(table) == {
        "default": [("displaced", "displaced"), ("zigzag", "displaced"), ("displaced", "displaced")]
    }


def test_a_confirmation_of_another_kind_is_no_second_start():
    table = confirmation(("default", 0.5, "displaced", 0.6, "displaced"))
    assert end_pairs(table.assign(confirmation="finer-mesh")) == {}


def test_every_passage_is_counted_once():
    table = passages((4.4, "displaced", "diverged"), (6.0, "zigzag", "zigzag"))
    found = rows_of(table, confirmation(("a", 0.5, "undecided", 0.6, "displaced")))
    assert found == [
        {"set": "grid", "points": 2, "same_class": 1, "other_class": 0, "no_class": 1},
        {"set": "ends of a", "points": 2, "same_class": 0, "other_class": 1, "no_class": 1},
    ]


def test_a_tier_without_second_starts_gives_an_empty_table():
    assert rows_of(passages((4.4, "displaced", "displaced")).query("sweep == 'grid'"), confirmation()) == []
