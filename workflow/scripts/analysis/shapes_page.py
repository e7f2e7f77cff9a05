"""The page of the pillar shapes: their picture and the parameters of each, from the schema of a case."""

from pathlib import Path

from study.analysis.arguments import required_arguments
from study.analysis.shapes import example_of, name_of, parameters_of, shapes_of
from study.analysis.tables import markdown_table
from study.planning.documents import read_json

HEAD = """# Pillar shapes

A pillar is the entry `pillar` of the section `geometry` of a case. Its coordinates are relative to its
centre, the flow comes from -x.

![Every pillar shape in its unit cell](shapes.png)

*Every shape with the values of the column "drawn", in a unit cell of 32 x 32 µm (dashed). G is the
shortest distance to the next pillar across the lane. The arrow stands on the line where s is measured. The
outlines are the solver's, [shapes.csv](shapes.csv).*

This page and its picture are made by `snakemake shapes`. Another shape is one file:
[extending.md](extending.md#a-pillar-shape).
"""


def range_of(part):
    """The range of a number, or of each number of a list."""
    while "items" in part:
        part = part["items"]
    low = f"above {part['exclusiveMinimum']:g}" if "exclusiveMinimum" in part else ""
    low = f"from {part['minimum']:g}" if "minimum" in part else low
    return f"{low} to {part['maximum']:g}" if "maximum" in part else low


def shown(value):
    return f"{value:g}" if isinstance(value, int | float) else "[" + ", ".join(map(shown, value)) + "]"


def lines_of(shape):
    """The heading and the table of a shape."""
    drawn = example_of(shape)
    rows = [
        [
            f"`{name}`",
            part["description"],
            range_of(part),
            shown(part["default"]) if "default" in part else "needed",
            shown(drawn[name]) if name in drawn else shown(part["default"]),
        ]
        for name, part in parameters_of(shape).items()
    ]
    yield from (
        f"## {name_of(shape)}",
        "",
        shape["description"][0].upper() + shape["description"][1:] + ".",
        "",
    )
    if rows:
        yield from markdown_table(["parameter", "meaning", "allowed", "default", "drawn"], rows)
        yield ""


def main():
    arguments = required_arguments(__doc__, "schema", "output")
    lines = [line for shape in shapes_of(read_json(arguments.schema)) for line in lines_of(shape)]
    Path(arguments.output).write_text(HEAD + "\n" + "\n".join(lines).rstrip() + "\n", encoding="utf-8")


main()
