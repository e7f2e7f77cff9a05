"""The devices of a study: pillars of two rows and two lanes, and the two streamlines that divide the flow
between them. Below the lower one a stream falls back by a lane, above the upper one it keeps to its own."""

import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

LOOKS = {
    "below": (style.BLUE, "-", "fluid below it passes under the next pillar"),
    "above": (style.ORANGE, "--", "fluid above it came over the last pillar"),
}
PANELS, HEIGHT = 3, 2.3  # in a row at the most; inches of a row
X_PITCHES, Y_PITCHES = (-1.35, 1.35), (-0.65, 1.65)  # window in pitches


def draw_pillars(axes, outline, facts, shift):
    """The pillars in the drawn window."""
    for n in (-2, -1, 0, 1, 2):
        for m in (-1, 0, 1, 2):
            centre = (n * facts.pitch_x_um, m * facts.pitch_y_um + n * shift)
            points = outline + np.array(centre)
            axes.fill(*points.T, color=style.PILLAR, lw=0, zorder=1)


def mark_gap(axes, facts, outline):
    """G between two pillars of one row, where it is narrowest."""
    (x0, y0), (x1, y1) = outline.T, np.roll(outline, -1, axis=0).T
    met = np.minimum(x0, x1) <= facts.gap_line_x_um
    met &= np.maximum(x0, x1) >= facts.gap_line_x_um
    share = (facts.gap_line_x_um - x0[met]) / np.where(x1 == x0, 1, x1 - x0)[met]
    lower = (y0[met] + share * (y1 - y0)[met]).max(initial=y0.min())
    arrow = {"arrowstyle": "<->", "lw": 0.7, "shrinkA": 0, "shrinkB": 0}
    x, upper = facts.gap_line_x_um, lower + facts.gap_um
    axes.annotate("", (x, lower), (x, upper), arrowprops=arrow, zorder=3)
    axes.annotate("G", (x, 0.5 * (lower + upper)), (3, 0), textcoords="offset points", va="center")


def draw(axes, facts, lines, shift):
    """One device at one row shift."""
    outline = lines[lines.kind == "outline"][["x_um", "y_um"]].to_numpy(float)
    if len(outline):
        draw_pillars(axes, outline, facts, shift)
        mark_gap(axes, facts, outline)
    for kind, (colour, dash, label) in LOOKS.items():
        line = lines[(lines.kind == kind) & (lines.row_shift_um == shift)]
        if len(line):
            axes.plot(line.x_um, line.y_um, color=colour, ls=dash, label=label, zorder=2)
    axes.set_xlim(*(edge * facts.pitch_x_um for edge in X_PITCHES))
    axes.set_ylim(*(edge * facts.pitch_y_um for edge in Y_PITCHES))
    axes.set_aspect("equal")
    axes.set_xlabel("x (µm), flow to the right")
    axes.set_title(
        f"{facts.device}, d = {shift:g} µm\nG = {facts.gap_um:.3g} µm, H = {facts.depth_um:.3g} µm"
    )


def main():
    arguments = required_arguments(__doc__, "plan", "devices", "lines", "output")
    devices, lines = read_table(arguments.devices), read_table(arguments.lines)
    columns = min(PANELS, len(devices))
    rows = -(-len(devices) // columns)
    figure = style.new_figure(style.COLUMN if columns == 1 else style.PAGE, HEIGHT * rows + 0.7)
    for number, facts in enumerate(devices.itertuples()):
        own = lines[lines.device == facts.device]
        shifts = sorted(own.row_shift_um.dropna().unique())
        axes = figure.add_subplot(rows, columns, number + 1)
        draw(axes, facts, own, shifts[len(shifts) // 2] if shifts else 0.0)
        if number % columns == 0:
            axes.set_ylabel("y (µm)")
    style.legend_below(figure, min(2, columns))
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
