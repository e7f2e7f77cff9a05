"""The page of a study: what it asks, its devices and cells, what came out, and what it cost."""

import ast
from pathlib import Path

import pandas as pd
from study.analysis.arguments import required_arguments
from study.analysis.devices import pressure_gradient_bar_per_m, shear_modulus
from study.analysis.tables import markdown_table, read_table
from study.planning.documents import read_json

DRAWING = Path(__file__).resolve().parents[1] / "drawing"
TITLES = {
    "fig_devices": "The devices. Grey: pillars, with the gap G. The lines divide the flow: fluid below the "
    "blue one passes under the next pillar and falls back by a lane, fluid above the orange one came over "
    "the last pillar.",
    "fig_separation": "Separation distance against the relative row shift.",
    "fig_phase_space": "What the cells do. A green bar is the interval of the critical Ca.",
    "fig_stretching": "Stretched cells: axial (filled) and transverse (open) diameters against the force.",
    "fig_sensitivity": "What choices of the model change: lateral extent, critical Ca, separation distance.",
    "fig_window": "The window in which the device tells the cells apart; bars stand around their row shift.",
}
#: Figures that stand in a section of their own; the others follow at the end.
PLACED = ("fig_devices", "fig_separation", "fig_phase_space", "fig_window")
#: What the states of a bracket mean.
BRACKETS = {
    "open": "wider than its tolerance",
    "bracketed": "within its tolerance",
    "all-displaced": "displaced in the whole range",
    "all-zigzag": "zigzag in the whole range",
}


def device_lines(devices):
    """What the devices are."""
    rows = [
        [
            row.device,
            f"{row.pitch_x_um:g} x {row.pitch_y_um:g}",
            f"{row.gap_um:.4g}",
            f"{row.depth_um:g}",
            f"{row.length_scale_um:.4g}",
            f"{100 * row.open_share:.1f} %",
        ]
        for row in devices.itertuples()
    ]
    return markdown_table(
        ["device", "pitch (µm)", "gap G (µm)", "depth H (µm)", "l = √(GH) (µm)", "open"], rows
    )


def separation_lines(separation):
    """The best value of s for every device and row shift: a limit where there is one."""
    good = separation[separation.status == "converged"].sort_values("dx_um")
    best = good.groupby(["device", "row_shift_um"]).first().reset_index()

    def with_error(value, error):
        if pd.isna(error):
            return f"{value:.3f}"
        return f"{value:.3f} ± {error:.3f}" if error >= 0.0005 else f"{value:.4f} ± {error:.1g}"

    rows = [
        [
            row.device,
            f"{row.row_shift_um:g}",
            f"{row.epsilon:.4g}",
            row.variant,
            with_error(row.s_um, row.s_uncertainty_um),
            with_error(row.s_upper_um, row.s_upper_uncertainty_um),
            f"{row.resistance_Pa_s_per_m2:.4g}",
        ]
        for row in best.itertuples()
    ]
    titles = ["device", "d (µm)", "ε", "lattice", "s at the pillar below (µm)", "s at the pillar above (µm)"]
    return markdown_table([*titles, "resistance (Pa s/m²)"], rows)


def bracket_words(row):
    """The state of a bracket; one without both ends is open for want of decided points."""
    if row.status == "open" and pd.isna([row.ca_displaced, row.ca_zigzag]).any():
        return "not decided"
    return BRACKETS.get(row.status, row.status)


def boundary_lines(boundary):
    """The brackets of the critical capillary number."""

    def end(value):
        return f"{value:.3g}" if pd.notna(value) else "none"

    rows = [
        [
            row.device,
            row.cell,
            f"{row.row_shift_um:g}",
            end(row.ca_displaced),
            end(row.ca_zigzag),
            bracket_words(row),
        ]
        for row in boundary.sort_values(["device", "cell", "row_shift_um"]).itertuples()
    ]
    return markdown_table(
        ["device", "cell", "d (µm)", "displaced up to Ca", "zigzag from Ca", "bracket"], rows
    )


def class_lines(passages):
    """What the cell does at each point of the sweeps, one column a sweep, with its extent."""
    grids = passages[~passages.sweep.str.startswith("boundary/")]
    sweeps = list(dict.fromkeys(grids.sweep))
    texts = grids.assign(
        text=[
            name + (f", {extent:.2f} µm" if pd.notna(extent) else "")
            for name, extent in zip(grids["class"], grids.d_perp_um, strict=True)
        ]
    )
    table = texts.pivot_table(
        index=["row_shift_um", "capillary_number"], columns="sweep", values="text", aggfunc="first"
    )
    rows = [
        [f"{shift:g}", f"{ca:.3g}", *(row.get(sweep) if pd.notna(row.get(sweep)) else "" for sweep in sweeps)]
        for (shift, ca), row in table.iterrows()
    ]
    return markdown_table(["d (µm)", "Ca", *sweeps], rows)


def window_lines(window):
    """The windows between two cells."""
    rows = [
        [
            row.device,
            f"{row.row_shift_um:g}",
            row.zigzag_cell,
            row.displaced_cell,
            f"{row.from_bar_per_m:.3g}",
            f"{row.to_bar_per_m:.3g}",
        ]
        for row in window.itertuples()
    ]
    titles = ["device", "d (µm)", "zigzags", "is displaced", "from (bar/m)", "to (bar/m)"]
    return markdown_table(titles, rows)


def cell_lines(plan):
    """What the cells are."""
    rows = [
        [
            name,
            entry.get("type", "the solver's default"),
            f"{kS:g}" if (kS := shear_modulus(plan, name)) else "",
            ", ".join(f"{key} = {value}" for key, value in entry.get("cell", {}).items()),
        ]
        for name, entry in plan["cells"].items()
    ]
    return markdown_table(["cell", "type", "shear modulus kS (µN/m)", "other settings"], rows)


def caption(name):
    """The caption of a figure; of one that has none here the first sentence of its program."""
    program = DRAWING / f"{name}.py"
    if name in TITLES or not program.exists():
        return TITLES.get(name, name)
    said = ast.get_docstring(ast.parse(program.read_text(encoding="utf-8"))) or name
    return " ".join(said.split()).split(". ")[0].rstrip(".") + "."


def pressure_lines(plan, devices):
    """Ca as a pressure gradient, for every device and every cell whose stiffness is known."""
    rows = [
        [row.device, name, f"{pressure_gradient_bar_per_m(1, kS, row.length_scale_um, radius):.4g}"]
        for row in devices.itertuples()
        for name, radius in plan["radius_um"].items()
        if radius and (kS := shear_modulus(plan, name))
    ]
    return (
        [*markdown_table(["device", "cell", "pressure gradient at Ca = 1 (bar/m)"], rows), ""] if rows else []
    )


def picture(name, folder):
    """A figure with its caption; nothing if it was not made."""
    if not (Path(folder) / "figures" / f"{name}.png").exists():
        return []
    return [f"![{caption(name)}](figures/{name}.png)", "", f"*{caption(name)}*", ""]


def other_pictures(folder):
    """The figures that no section above shows."""
    names = sorted(path.stem for path in (Path(folder) / "figures").glob("fig_*.png"))
    found = [line for name in names if name not in PLACED for line in picture(name, folder)]
    return ["## Further figures", "", *found] if found else []


def main():
    arguments = required_arguments(__doc__, "plan", "tables", "name", "output")
    plan, folder = read_json(arguments.plan), Path(arguments.output).parent
    tables = {path.stem: read_table(path) for path in sorted(Path(arguments.tables).glob("*.csv"))}
    lines = [f"# {plan['study']}", "", plan["purpose"], ""]
    lines += [f"**{plan['note']}**", ""] if plan["note"] else []
    lines += [f"Made by `bash workflow/reproduce --config study={arguments.name}` from "]
    lines[-1] += f"[params/studies/{arguments.name}.json](../../params/studies/{arguments.name}.json)."
    lines += ["Words are explained in [docs/glossary.md](../../docs/glossary.md).", ""]
    lines += ["## Devices and cells", ""]
    if "devices" in tables:
        lines += [*picture("fig_devices", folder), *device_lines(tables["devices"]), ""]
    lines += [*cell_lines(plan), ""]
    if "devices" in tables:
        lines += pressure_lines(plan, tables["devices"])
    if "streamline_separation" in tables:
        lines += ["## Flow without cells", "", *picture("fig_separation", folder)]
        lines += [*separation_lines(tables["streamline_separation"]), ""]
    if "passages" in tables:
        counts = tables["passages"]["class"].value_counts()
        lines += ["## Cells in the device", "", *picture("fig_phase_space", folder)]
        lines += [
            f"{len(tables['passages'])} passages: "
            + ", ".join(f"{n} {name}" for name, n in counts.items())
            + "."
        ]
        if "phase_boundary" in tables and len(tables["phase_boundary"]):
            lines += ["", "### Critical capillary number", "", *boundary_lines(tables["phase_boundary"])]
        if "window" in tables and len(tables["window"]):
            lines += ["", "### Pressure", "", *picture("fig_window", folder), *window_lines(tables["window"])]
        lines += ["", "### Every point of the sweeps", ""]
        lines += [
            "Class of the trajectory and lateral extent D_perp.",
            "",
            *class_lines(tables["passages"]),
            "",
        ]
        work = tables["passages"].node_updates.sum()
        lines += [f"Work of the passages: {work:.3g} updates of a lattice node.", ""]
    lines += other_pictures(folder)
    Path(arguments.output).write_text("\n".join(lines), encoding="utf-8")


main()
