"""Figure 3: the mesh of the cell, undeformed and deformed at a pillar line."""

from study.analysis.arguments import required_arguments
from study.analysis.surface import draw_cell
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json


def main():
    arguments = required_arguments(__doc__, "plan", "shapes", "faces", "output")
    plan = read_json(arguments.plan)
    shapes, faces = read_table(arguments.shapes), read_table(arguments.faces)
    corners = faces[faces.figure == "fig03"][["a", "b", "c"]].to_numpy()
    place = plan["figures"]["deformed_cell"]
    titles = {
        "undeformed": f"undeformed, {len(corners)} faces",
        "deformed": f"at a pillar, Ca = {place['capillary_number']:g}, $d$ = {place['row_shift_um']:.1f} μm",
    }
    figure = style.new_figure(style.PAGE, 2.3)
    for column, (shape, title) in enumerate(titles.items(), start=1):
        axes = figure.add_subplot(1, 2, column, projection="3d")
        vertices = shapes[shapes["shape"] == shape][["x_um", "y_um", "z_um"]].to_numpy()
        draw_cell(axes, vertices, corners, half_width=4.9)
        axes.set_title(title, y=-0.02)
    style.save(figure, arguments.output, plan["note"])


main()
