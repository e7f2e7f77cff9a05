"""Animation of one passage: the cell's outline in the mid plane on its way through the array, with the path
of its centre. The time between pictures follows the simulation: a cell that lingers is seen to linger."""

import numpy as np
from PIL import Image
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

RADIUS, PITCH = 10.0, 32.0  # um
SECONDS = 12.0  # length of the animation
SHORTEST_MS = 20  # between two pictures; viewers slow shorter ones down
DPI = 150


def frame_times(steps):
    """Time in ms for which each picture is shown: in proportion to the steps until the next one, multiples of
    10 as the format wants."""
    waits = np.diff(steps, append=steps[-1])
    waits[-1] = waits[:-1].max() if len(waits) > 1 else 1
    times = 1000 * SECONDS * waits / max(waits.sum(), 1)
    return [int(max(SHORTEST_MS, 10 * round(time / 10))) for time in times]


def stage(table, title, note):
    """Figure with the pillars alone, and its axes."""
    low, high = table.y_um.min() - 8, table.y_um.max() + 8
    left, right = -PITCH / 2, table.x_um.max() + 4
    width = 7.5
    figure = style.new_figure(width, width * (high - low) / (right - left) + 0.45)
    figure.set_layout_engine("none")
    axes = figure.add_axes((0, 0, 1, 1 - 0.4 / figure.get_figheight()))
    style.add_pillars(axes, RADIUS, PITCH, table.row_shift_um.iloc[0], (left, right), (low, high))
    axes.set(xlim=(left, right), ylim=(low, high), aspect="equal")
    axes.set_axis_off()
    figure.text(0.01, 0.99, f"{note}  {title}".strip(), va="top", fontsize=9)
    return figure, axes


def frames(figure, axes, table):
    """One RGB picture for each snapshot; the background is drawn once."""
    (cell,) = axes.fill([0], [0], fc=style.VERMILION, ec="#7A1F00", lw=1, alpha=0.9, animated=True)
    (trail,) = axes.plot([], [], color=style.BLUE, lw=1, animated=True)
    canvas = figure.canvas
    canvas.draw()
    background, path = canvas.copy_from_bbox(figure.bbox), []
    for _, line in table.groupby("step"):
        points = line[["x_um", "y_um"]].to_numpy()
        path.append(points.mean(axis=0))
        canvas.restore_region(background)
        trail.set_data(*np.transpose(path))
        cell.set_xy(points)
        axes.draw_artist(trail)
        axes.draw_artist(cell)
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def main():
    arguments = required_arguments(__doc__, "plan", "outlines", "name", "output")
    plan, table = read_json(arguments.plan), read_table(arguments.outlines)
    capillary = plan["figures"]["animations"][arguments.name]
    table = table[table.capillary_number == capillary]
    if table.empty:  # diverged at once: a picture that says so
        figure = style.new_figure(4.0, 0.5)
        figure.text(0.02, 0.5, f"{plan['note']}  Ca = {capillary:g}: no snapshots", va="center")
        figure.savefig(arguments.output, pil_kwargs={"format": "GIF"})
        return
    shift, label = table.row_shift_um.iloc[0], table["class"].iloc[0]
    title = f"Ca = {capillary:g}, row shift {shift:.1f} µm: {label}"
    figure, axes = stage(table, title, plan["note"])
    figure.set_dpi(DPI)
    pictures = list(frames(figure, axes, table))
    palette = pictures[-1].quantize(48)
    pictures = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    times = frame_times(table.step.unique())
    options = {
        "save_all": True,
        "append_images": pictures[1:],
        "duration": times,
        "loop": 0,
        "optimize": False,
    }
    pictures[0].save(arguments.output, **options)


main()
