"""The devices of a study: pillars of two rows and two lanes, and the two streamlines that divide the flow
between them. Below the lower one a stream falls back by a lane, above the upper one it keeps to its own."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

LOOKS = {
    "below": (style.BLUE, "-", "ends at the next pillar"),
    "above": (style.ORANGE, "--", "left the last one"),
}
WIDTH = 2.2  # of one panel, inches


def draw_pillars(axes, outline, facts, shift):
    """The pillars in the drawn window."""
    for n in (-1, 0, 1):
        for m in (-1, 0, 1, 2):
            centre = (n * facts.pitch_x_um, m * facts.pitch_y_um + n * shift)
            points = outline + np.array(centre)
            axes.fill(*points.T, color=style.PILLAR, lw=0, zorder=1)


def draw(axes, facts, lines, shift):
    """One device at one row shift."""
    outline = lines[lines.kind == "outline"][["x_um", "y_um"]].to_numpy(float)
    if len(outline):
        draw_pillars(axes, outline, facts, shift)
    for kind, (colour, dash, label) in LOOKS.items():
        line = lines[(lines.kind == kind) & (lines.row_shift_um == shift)]
        if len(line):
            axes.plot(line.x_um, line.y_um, color=colour, ls=dash, label=label, zorder=2)
    axes.set_xlim(-0.7 * facts.pitch_x_um, 1.4 * facts.pitch_x_um)
    axes.set_ylim(-0.6 * facts.pitch_y_um, 1.6 * facts.pitch_y_um)
    axes.set_aspect("equal")
    axes.set_xlabel("x (µm), flow to the right")
    axes.set_title(
        f"{facts.device}, d = {shift:g} µm\nG = {facts.gap_um:.3g} µm, H = {facts.depth_um:.3g} µm"
    )


def main():
    arguments = required_arguments(__doc__, "plan", "devices", "lines", "output")
    devices, lines = read_table(arguments.devices), read_table(arguments.lines)
    figure = style.new_figure(max(style.COLUMN, WIDTH * len(devices)), 3.4)
    for number, facts in enumerate(devices.itertuples()):
        own = lines[lines.device == facts.device]
        shifts = sorted(own.row_shift_um.dropna().unique())
        axes = figure.add_subplot(1, len(devices), number + 1)
        draw(axes, facts, own, shifts[len(shifts) // 2] if shifts else 0.0)
        if number == 0:
            axes.set_ylabel("y (µm)")
    style.legend_below(figure, 2)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
