"""Figure 4: streamlines and speed in the mid plane of one unit cell without a blood cell."""

import matplotlib.pyplot as plt
import numpy as np
from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.planning.documents import read_json

RADIUS, PITCH = 10.0, 32.0  # um


def grids(field):
    """Coordinates and (ny, nx) arrays of one field, closed periodically in y for drawing."""
    x, y = np.unique(field.x_um), np.unique(field.y_um)
    shape = (len(x), len(y))
    ordered = field.sort_values(["x_um", "y_um"])
    u, v = (ordered[name].to_numpy().reshape(shape).T for name in ("velocity_x_lu", "velocity_y_lu"))
    return x, y, u, v


def draw(axes, field, separatrices, shift, scale):
    """One panel; returns the picture of the speed."""
    x, y, u, v = grids(field)
    half = 0.5 * (x[1] - x[0])
    extent = (x[0] - half, x[-1] + half, y[0] - half, y[-1] + half)
    speed = np.hypot(u, v) / scale
    picture = axes.imshow(
        speed, origin="lower", extent=extent, cmap="viridis", vmin=0, vmax=1, interpolation="bicubic"
    )
    left, starts = x[0] + 1e-6, np.linspace(y[0], y[-1], 22)[1:-1]
    axes.streamplot(
        x,
        y,
        u,
        v,
        start_points=np.column_stack([np.full_like(starts, left), starts]),
        color="white",
        linewidth=0.5,
        arrowsize=0.5,
        density=8,
        broken_streamlines=False,
        integration_direction="forward",
    )
    for _, line in separatrices.groupby("side"):
        for offset in (-PITCH, 0, PITCH):
            for row in (-1, 0, 1):
                copy = line.x_um + row * PITCH, line.y_um + offset + row * shift
                if copy[0].between(*extent[:2]).sum() > 2:  # fewer points would be a speck at the edge
                    axes.plot(*copy, color=style.ORANGE, lw=1.2, ls="--")
    axes.add_patch(plt.Circle((0, 0), RADIUS, fc=style.PILLAR, ec="none", zorder=3))
    axes.set(xlim=extent[:2], ylim=extent[2:], aspect="equal", xlabel="$x$ / μm", ylabel="$y$ / μm")
    axes.set_title(rf"$d$ = {shift:.1f} μm, $\epsilon$ = {80 * shift / PITCH:g}/80")
    return picture


def main():
    arguments = required_arguments(__doc__, "plan", "fields", "separatrices", "output")
    fields, separatrices = read_table(arguments.fields), read_table(arguments.separatrices)
    scale = np.hypot(fields.velocity_x_lu, fields.velocity_y_lu).max()
    figure = style.new_figure(style.PAGE, 3.5)
    shifts = sorted(fields.row_shift_um.unique())
    panels = np.atleast_1d(figure.subplots(1, len(shifts), sharey=True))
    for axes, shift in zip(panels, shifts, strict=True):
        lines = separatrices[separatrices.row_shift_um == shift]
        picture = draw(axes, fields[fields.row_shift_um == shift], lines, shift, scale)
    for axes in panels[1:]:
        axes.set_ylabel("")
    names = [plt.Line2D([], [], color=style.ORANGE, lw=1.2, ls="--", label="separatrix, ends at a pillar")]
    names.append(plt.Line2D([], [], color="#999999", lw=0.5, label="other streamlines (white)"))
    figure.legend(handles=names, loc="outside lower center", ncols=2)
    figure.colorbar(picture, ax=list(panels), label="speed / largest speed of both", shrink=0.85)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
