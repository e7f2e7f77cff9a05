"""The page of the pillar shapes says what the solver's schema says, and shows every shape."""

import json

import pandas as pd
from study.analysis.shapes import example_of, name_of, parameters_of, shapes_of
from study.planning.documents import SCHEMAS, problems, read_json

SCHEMA = read_json(SCHEMAS / "case.schema.json")


def test_the_page_is_that_of_the_schema(root, call, tmp_path):
    page = tmp_path / "shapes.md"
    call("shapes_page", schema=SCHEMAS / "case.schema.json", output=page)
    assert page.read_text(encoding="utf-8") == (root / "docs/shapes.md").read_text(encoding="utf-8")


def test_the_picture_has_every_shape_with_its_gap(root, call, tmp_path):
    table = pd.read_csv(root / "docs/shapes.csv")
    shown = {name for name, rows in table.groupby("shape") if set(rows.kind) == {"outline", "gap"}}
    assert shown == {name_of(shape) for shape in shapes_of(SCHEMA)} - {"none"}
    call("shapes_picture", outlines=root / "docs/shapes.csv", output=tmp_path / "shapes.pdf")
    assert (tmp_path / "shapes.png").read_bytes() == (root / "docs/shapes.png").read_bytes()


def test_every_parameter_has_a_default_or_an_example(root):
    for shape in shapes_of(SCHEMA):
        for name, part in parameters_of(shape).items():
            assert "default" in part or "examples" in part, (name_of(shape), name)
        case = {"scene": "streamlines", "geometry": {"pillar": example_of(shape)}}
        assert problems(json.loads(json.dumps(case)), SCHEMA) == []
