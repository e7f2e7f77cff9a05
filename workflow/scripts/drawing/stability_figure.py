"""Stability maps: works, inaccurate or fails in planes of two parameters, and the limit stated
beforehand."""

import numpy as np
from matplotlib.colors import ListedColormap
from study.analysis.arguments import figure_arguments
from study.analysis.tables import read_table
from study.drawing.style import BLACK, BLUE, PAGE, SKY, VERMILION, YELLOW, new_figure, plt, save
from study.planning.documents import read_json
from study.planning.stability import STATUSES

FACES = {"works": SKY, "inaccurate": YELLOW, "fails": VERMILION}
MARKERS = {"works": "o", "inaccurate": "^", "fails": "x"}
NAMES = {
    "/fluid/relaxation_time": r"$\tau - 1/2$",
    "/fluid/force_density": r"force density $f$ / lu",
    "/fluid/precision": "precision",
    "/cell/capillary_number": "Ca",
    "/cell/local_area_modulus": r"$k_\alpha$ / ($p' l r$)",
    "/cell/volume_modulus": r"$k_V$ / ($p' l$)",
    "/cell/mesh_frequency": "mesh frequency",
    "/cell/viscosity_ratio": "viscosity ratio",
    "/cell/bending_ratio": r"$k_B$ / ($k_S r^2$)",
    "/coupling/steps_per_update": "fluid steps per update",
    "/coupling/pillar_repulsion": r"repulsion / ($p' l\,dx^2$)",
}
TITLES = {
    "relaxation-bgk": "BGK",
    "relaxation-trt": "TRT",
    "relaxation-inertia": "TRT, full equilibrium",
    "relaxation-corrected": "corrected kernel",
    "stiffness-phi4": "kernel phi4",
    "stiffness-phi3": "kernel phi3",
    "stiffness-phi2": "kernel phi2",
    "stiffness-corrected": "corrected kernel",
    "mesh-bare": "mesh, bare",
    "viscosity-ratio-bgk": "BGK",
    "viscosity-ratio-trt": "TRT",
    "viscosity-ratio-corrected": "corrected kernel",
    "bending-viscosity": "bending, viscosity",
}  # other maps: their name
COLUMNS = 4
#: The maps that a user meets, in the order in which they are drawn, and what they ask.
USER = {
    "stiffness-phi4": "How fast may the flow be? (plain kernel)",
    "stiffness-corrected": "How fast may the flow be? (corrected)",
    "mesh": "Which mesh for which cell?",
    "bending": "How stiff against bending?",
}
EDGE_UM = 4.0  # um, mean edge of the mesh times its frequency
SHEAR_MODULUS, CELL_RADIUS = 5.3e-6, 3.9e-6  # N/m, m: a healthy cell
PHYSICAL_NAMES = {
    "/fluid/force_density": "Reynolds number",
    "/cell/mesh_frequency": "edge of the mesh / μm",
    "/cell/bending_ratio": r"$\kappa_\mathrm{B}$ of a healthy cell / $10^{-19}$ J",
    "/cell/capillary_number": "capillary number Ca",
}


def reynolds(force, case):
    """Reynolds number u G / nu of the slit flow u = f H^2 / (12 nu) that a force density drives."""
    fluid, geometry = case["fluid"], case["geometry"]
    dx, viscosity = fluid["lattice_spacing_um"], (fluid["relaxation_time"] - 0.5) / 3
    depth, gap = geometry["depth_um"] / dx, (geometry["pitch_um"] - 2 * geometry["pillar_radius_um"]) / dx
    return force * depth**2 * gap / (12 * viscosity**2)


def physical(values, key, case):
    """The values of an axis in physical numbers."""
    values = np.asarray(values, float)
    if key == "/fluid/force_density":
        return reynolds(values, case)
    if key == "/cell/mesh_frequency":
        return EDGE_UM / values
    if key == "/cell/bending_ratio":
        return values * SHEAR_MODULUS * CELL_RADIUS**2 * 1e19
    return values


def edges(values):
    """Borders of the cells around values on a logarithmic axis, n + 1 for n values."""
    logs = np.log(values)
    if len(logs) == 1:
        return np.exp(np.array([logs[0] - 0.5, logs[0] + 0.5]))
    inner = 0.5 * (logs[1:] + logs[:-1])
    return np.exp(np.concatenate([[2 * logs[0] - inner[0]], inner, [2 * logs[-1] - inner[-1]]]))


def axis_of(values, key):
    """Places of the values on the axis and their names: numbers as they are, words as 1, 2, ...

    The relaxation time is drawn by its distance from 1/2, to which the viscosity is proportional.
    """
    if key == "/fluid/relaxation_time":
        return np.asarray(values, float) - 0.5, None
    words = not np.issubdtype(np.asarray(values).dtype, np.number)
    places = np.arange(1, len(values) + 1, dtype=float) if words else np.asarray(values, float)
    return places, list(values) if words else None


def apart(places, beside):
    """The places whose labels do not touch on a logarithmic axis, where they stand beside one another (x) or
    above one another (y).

    A letter takes about a twentieth of the axis, which is longer than the span of the places.
    """
    length, kept = 1.3 * np.log(places[-1] / places[0]), [places[0]]
    for place in places[1:]:
        letters = 0.5 * (len(label(place)) + len(label(kept[-1]))) + 1 if beside else 2.2
        if np.log(place / kept[-1]) > 0.055 * letters * length:
            kept.append(place)
    return kept


def label(value):
    """Text of a tick."""
    return f"{value:.2g}"


def grid(frame, column, xs, ys):
    """Values of a column on the plane, ny x nx; missing points are NaN or None."""
    table = frame.pivot_table(index="y", columns="x", values=column, aggfunc="first")
    return table.reindex(index=ys, columns=xs).to_numpy()


def numbers(values):
    """The distinct values in order, as numbers if all of them are."""
    try:
        return sorted({float(value) for value in values})
    except ValueError:
        return sorted(set(values))


def draw(axes, frame, case=None):
    """One map; in physical numbers where the case that it was made with is given."""
    xs, ys = numbers(frame.x), numbers(frame.y)
    frame = frame.assign(x=[type(xs[0])(v) for v in frame.x], y=[type(ys[0])(v) for v in frame.y])
    (px, x_words), (py, y_words) = axis_of(xs, frame.x_name.iloc[0]), axis_of(ys, frame.y_name.iloc[0])
    names = NAMES
    if case:
        px, py = (
            physical(places, frame[key].iloc[0], case) for places, key in ((px, "x_name"), (py, "y_name"))
        )
        names = PHYSICAL_NAMES
    status = grid(frame, "status", xs, ys)
    axes.set(xscale="linear" if x_words else "log", yscale="linear" if y_words else "log")
    x_edges = np.arange(len(px) + 1) + 0.5 if x_words else edges(px)
    y_edges = np.arange(len(py) + 1) + 0.5 if y_words else edges(py)
    for name in STATUSES:
        chosen = np.where(status == name, 1.0, np.nan)
        colour = ListedColormap([FACES[name]])
        axes.pcolormesh(x_edges, y_edges, chosen, cmap=colour, alpha=0.5, linewidth=0, rasterized=True)
        j, i = np.nonzero(status == name)
        axes.scatter(px[i], py[j], s=9, marker=MARKERS[name], color=BLACK, linewidths=0.7)
    share = grid(frame, "predicted_share", xs, ys).astype(float)
    if min(share.shape) > 1 and np.nanmin(share) < 1 < np.nanmax(share):
        axes.contour(px, py, np.log(share), levels=[0], colors=BLUE, linewidths=1.4)
    for axis, words, places in ((axes.xaxis, x_words, px), (axes.yaxis, y_words, py)):
        axis.set_minor_locator(plt.NullLocator())
        if words:
            axis.set_ticks(places, words)
        elif max(places) / min(places) < 50:
            axis.set_ticks(apart(np.sort(places), axis is axes.xaxis))
            axis.set_major_formatter(plt.FuncFormatter(lambda value, _: label(value)))
    axes.set_xlabel(names.get(frame.x_name.iloc[0], frame.x_name.iloc[0]))
    axes.set_ylabel(names.get(frame.y_name.iloc[0], frame.y_name.iloc[0]))
    name = frame["map"].iloc[0]
    axes.set_title(USER[name] if case else TITLES.get(name, name.replace("-", " ")))


def cases(plan):
    """The case of the first run of every map."""
    found = {}
    for run in plan["runs"]:
        if run["group"] == "stability":
            found.setdefault(run["labels"]["map"], run["case"])
    return found


def main():
    arguments = figure_arguments(__doc__, "table", "maps")
    plan, table = read_json(arguments.plan), read_table(arguments.table)
    known = list(dict.fromkeys(table["map"]))
    user = arguments.maps == "user"
    maps, columns = ([name for name in USER if name in known], 2) if user else (known, COLUMNS)
    table = table[table["map"].isin(maps)]
    table.to_csv(arguments.csv, index=False, lineterminator="\n")
    rows = max(1, -(-len(maps) // columns))
    figure = new_figure(PAGE, 0.5 + (2.1 if user else 1.7) * rows)
    panels, made = figure.subplots(rows, columns, squeeze=False).ravel(), cases(plan) if user else {}
    for axes, name in zip(panels, maps, strict=False):
        draw(axes, table[table["map"] == name], made.get(name))
    for axes in panels[len(maps) :]:
        axes.set_axis_off()
    keys = [
        plt.Line2D(
            [], [], color=FACES[name], marker=MARKERS[name], mec=BLACK, mfc=BLACK, lw=6, ms=4, label=name
        )
        for name in STATUSES
    ]
    keys.append(plt.Line2D([], [], color=BLUE, linewidth=1.4, label="limit stated by dld check"))
    figure.legend(handles=keys, loc="outside lower center", ncols=4)
    save(figure, arguments.output, plan["note"])


main()
