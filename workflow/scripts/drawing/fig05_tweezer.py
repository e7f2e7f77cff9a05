"""Figure 5: the cell in the optical tweezer, relaxed and stretched, and its diameters against the force."""

import pandas as pd
from study.analysis.arguments import figure_arguments
from study.analysis.measured import read_measured
from study.analysis.surface import draw_cell
from study.analysis.tables import read_table, write_table
from study.drawing import style
from study.planning.documents import read_json

EXPERIMENTS = {
    "SURESH2005_FIG7": ("Suresh et al. 2005", "o", style.BLACK),
    "MILLS2004_FIG8": ("Mills et al. 2004", "s", "#888888"),
}
COLOURS = [style.BLUE, style.GREEN, style.VERMILION, style.ORANGE]
DASHES = ["-", "--", "-.", ":"]


def draw_shapes(figure, shapes, corners, force):
    """Panel (a): relaxed and stretched cell."""
    for number, (shape, title) in enumerate({"relaxed": "relaxed", "stretched": f"{force:g} pN"}.items()):
        axes = figure.add_subplot(2, 1, number + 1, projection="3d")
        vertices = shapes[shapes["shape"] == shape][["x_um", "y_um", "z_um"]].to_numpy()
        draw_cell(axes, vertices, corners, half_width=6.6, elevation=45, azimuth=-90)
        axes.set_title(("(a) " if number == 0 else "") + title, y=0.92)


def draw_diameters(axes, static, coupled, experiment):
    """Panel (b): diameters against the force."""
    for number, (k, curve) in enumerate(static.groupby("skalak_denominator")):
        look = {"color": COLOURS[number % 4], "ls": DASHES[number % 4]}
        axes.plot(curve.force_pN, curve.axial_um, label=f"simulation, $k$ = {k:g}", **look)
        axes.plot(curve.force_pN, curve.transverse_um, **look)
    for name, (label, marker, colour) in EXPERIMENTS.items():
        points = experiment[experiment.set == name]
        look = {"fmt": marker, "color": colour, "capsize": 2, "lw": 0.6, "ms": 3.5, "mfc": "white"}
        axes.errorbar(points.F_pN, points.DA_um, points.DA_err_um, label=label, **look)
        axes.errorbar(points.F_pN, points.DT_um, points.DT_err_um, **look)
    if len(coupled):
        k = coupled.skalak_denominator.iloc[0]
        look = {"color": style.PURPLE, "marker": "x", "ls": "none", "zorder": 5}
        axes.plot(coupled.force_pN, coupled.axial_um, label=f"through the fluid, $k$ = {k:g}", **look)
        axes.plot(coupled.force_pN, coupled.transverse_um, **look)
    axes.set(xlabel="force / pN", ylabel="diameter / μm", ylim=(0, 29), xlim=(-3, 203))
    axes.text(201, static.axial_um.max() + 0.7, "axial", ha="right")
    axes.text(201, 2.2, "transverse", ha="right")
    axes.set_title("(b)", loc="left")
    axes.legend(loc="upper left", handlelength=2.2, ncols=2, columnspacing=1.0)


def main():
    arguments = figure_arguments(__doc__, "table", "experiment", "shapes", "faces")
    plan = read_json(arguments.plan)
    table, experiment = read_table(arguments.table), read_measured(arguments.experiment)
    shown = table.skalak_denominator.isin(plan["figures"]["tweezer_denominators"])
    static, coupled = table[shown & (table.method == "static")], table[table.method == "coupled"]

    columns = ["source", "skalak_denominator", "force_pN", "axial_um", "axial_error_um"]
    columns += ["transverse_um", "transverse_error_um"]
    names = {"F_pN": "force_pN", "set": "source", "DA_um": "axial_um", "DA_err_um": "axial_error_um"}
    names |= {"DT_um": "transverse_um", "DT_err_um": "transverse_error_um"}
    measured = experiment.rename(columns=names)
    simulated = pd.concat([static, coupled]).rename(columns={"method": "source"})
    rows = pd.concat([simulated, measured]).to_dict("records")
    styles = dict.fromkeys(columns[3:], ".3f") | {"force_pN": ".1f"}
    write_table(rows, columns, arguments.csv, styles=styles)

    figure = style.new_figure(style.PAGE, 3.6)
    left, right = figure.subfigures(1, 2, width_ratios=[0.75, 1.25])
    shapes, faces = read_table(arguments.shapes), read_table(arguments.faces)
    corners = faces[faces.figure == "fig05"][["a", "b", "c"]].to_numpy()
    draw_shapes(left, shapes, corners, plan["figures"]["tweezer_force_pN"])
    draw_diameters(right.subplots(), static, coupled, experiment)
    style.save(figure, arguments.output, plan["note"])


main()
