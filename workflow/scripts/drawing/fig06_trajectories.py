"""Figure 6: trajectories of the cell's centre, a panel for each row shift, a line for each Ca. Lines
that lie on one another are nested, the stiffest cell widest, so that all can be seen; each panel says
which cells are displaced, here and in print."""

from study.analysis.arguments import required_arguments
from study.analysis.tables import read_table
from study.drawing import style
from study.paper.claims import load_claims
from study.planning.documents import read_json

RADIUS, PITCH = 10.0, 32.0  # um
WIDTHS = [4.6, 3.4, 2.3, 1.3, 0.5]  # points, stiff to soft
COLOURS = [style.BLACK, style.SKY, style.GREEN, style.YELLOW, style.VERMILION]


def y_range(panel):
    """Range of y of a panel: the trajectories with some room, at least one and a half gaps and pillars."""
    middle, half = 0.5 * (panel.y_um.min() + panel.y_um.max()), 0.5 * (panel.y_um.max() - panel.y_um.min())
    half = max(half + 6, 0.75 * PITCH)
    return middle - half, middle + half


def in_words(displaced, others, numbers):
    """Which of these capillary numbers are displaced, in words; `others` names the rest."""
    if len(displaced) == len(numbers):
        return "all displaced"
    if not displaced:
        return f"all {others}"
    return f"Ca = {', '.join(f'{number:g}' for number in displaced)} displaced, softer ones {others}"


def in_print(statements, shift, numbers):
    """The same for the classes that the paper states; None where it does not state all of them."""
    for said in (one for one in statements if abs(one["row_shift_um"] - shift) < 1e-6):
        displaced = [n for n in numbers if said["displaced_to"] is not None and n <= said["displaced_to"]]
        zigzag = [n for n in numbers if said["zigzag_from"] is not None and n >= said["zigzag_from"]]
        if len(displaced) + len(zigzag) == len(numbers):
            return in_words(displaced, "zigzag", numbers)
    return None


def draw(axes, panel, number, x_range, statements):
    """One panel with its classes in the title."""
    shift, (low, high) = panel.row_shift_um.iloc[0], y_range(panel)
    style.add_pillars(axes, RADIUS, PITCH, shift, x_range, (low, high))
    classes = {}
    for index, (capillary, line) in enumerate(panel.groupby("capillary_number")):
        k = min(index, len(WIDTHS) - 1)
        look = {"color": COLOURS[k], "lw": WIDTHS[k], "solid_capstyle": "round"}
        axes.plot(line.x_um, line.y_um, label=f"Ca = {capillary:g}", **look)
        classes[capillary] = line["class"].iloc[0]
    numbers = sorted(classes)
    displaced = [n for n in numbers if classes[n] == "displaced"]
    rest = sorted({classes[n] for n in numbers} - {"displaced"})
    found, printed = in_words(displaced, " or ".join(rest), numbers), in_print(statements, shift, numbers)
    said = "" if printed is None else "; in print the same" if printed == found else f"; in print {printed}"
    title = (
        rf"({'abcdefgh'[number]}) $\epsilon$ = {80 * shift / PITCH:g}/80, $d$ = {shift:.1f} μm: {found}{said}"
    )
    axes.set_title(title, loc="left")
    axes.set(xlim=x_range, ylim=(low, high), aspect="equal", ylabel="$y$ / μm")


def main():
    arguments = required_arguments(__doc__, "plan", "trajectories", "claims", "output")
    table = read_table(arguments.trajectories)
    statements = load_claims(arguments.claims)["phase-boundary"]["statements"]
    shifts = sorted(table.row_shift_um.unique())
    panels = [table[table.row_shift_um == shift] for shift in shifts]
    spans = [high - low for low, high in map(y_range, panels)]
    width = table.x_um.max() + PITCH / 2
    height = sum(max(span / width * 6.1, 0.7) + 0.28 for span in spans) + 0.7
    figure = style.new_figure(style.PAGE, height)
    grid = figure.subplots(len(panels), 1, squeeze=False, sharex=True, gridspec_kw={"height_ratios": spans})[
        :, 0
    ]
    for number, (axes, panel) in enumerate(zip(grid, panels, strict=True)):
        draw(axes, panel, number, (-PITCH / 2, table.x_um.max() + 2), statements)
    grid[-1].set_xlabel("$x$ / μm")
    style.legend_below(figure, 5)
    style.save(figure, arguments.output, read_json(arguments.plan)["note"])


main()
