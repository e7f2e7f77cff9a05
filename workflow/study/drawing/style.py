"""One look for all figures, and the one function that saves them: same data, same bytes."""

from io import BytesIO
from pathlib import Path

import matplotlib
from PIL import Image

from study.drawing.pictures import png_with_palette

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.text import Text
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

#: Print widths in inches, one column and the full page of the article, which shows figures at their own size.
COLUMN, PAGE = 3.25, 6.7
#: Smallest type of a figure in points.
SMALLEST_TYPE = 7

#: Okabe and Ito's colours, distinguishable with any colour vision.
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, VERMILION, PURPLE = "#F0E442", "#0072B2", "#D55E00", "#CC79A7"
PILLAR = "#BDBDBD"

#: Colour, line style and marker of a class of trajectories.
CLASSES = {
    "displaced": (BLUE, "displaced"),
    "zigzag": (VERMILION, "zigzag"),
    "undecided": (PURPLE, "undecided"),
    "diverged": (BLACK, "diverged"),
    "failed": (BLACK, "run failed"),
    "interrupted": ("#777777", "interrupted"),
}

SERIES = [
    (BLACK, "-"),
    (BLUE, "--"),
    (GREEN, "-."),
    (ORANGE, (0, (4, 1, 1, 1, 1, 1))),
    (VERMILION, (0, (1, 1))),
    (PURPLE, (0, (6, 2))),
    (SKY, "-"),
]

SETTINGS = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8,
    "axes.labelsize": 8,
    "axes.titlesize": 8,
    "legend.fontsize": 8,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.2,
    "lines.markersize": 4,
    "legend.frameon": False,
    "figure.constrained_layout.use": True,
    "pdf.fonttype": 42,
    "svg.hashsalt": "dld",
}


#: Pixels across: a full screen; the PDF has the rest.
WIDEST_PNG = 2100


def new_figure(width, height, **options):
    """A figure of this print size in inches, in the project's style."""
    plt.rcParams.update(SETTINGS)
    return plt.figure(figsize=(width, height), **options)


def say_no_runs(axes):
    """Says in an empty plot why it is empty."""
    look = {"ha": "center", "va": "center", "color": VERMILION, "fontsize": 8}
    axes.text(0.5, 0.5, "no runs in this tier", transform=axes.transAxes, zorder=9, **look)


def unreadable(figure):
    """What of a figure could not be read in print: too wide for the page, or type that is too small."""
    if figure.get_figwidth() > PAGE + 1e-6:
        yield f"{figure.get_figwidth():.2f} in wide, the page has {PAGE}"
    for text in figure.findobj(Text):
        if text.get_visible() and text.get_text().strip() and text.get_fontsize() < SMALLEST_TYPE:
            yield f"'{text.get_text()}' in {text.get_fontsize():g} pt, at least {SMALLEST_TYPE}"


def save(figure, pdf_path, note=""):
    """Saves the figure as PDF and, beside it, PNG, without dates; a tier's `note` is shown on top. A figure
    that could not be read in the article's width is an error. Plots without data say so."""
    for axes in figure.axes:
        if axes.axison and not axes.has_data() and not axes.texts:
            say_no_runs(axes)
    faults = list(unreadable(figure))
    if faults:
        raise ValueError(f"{pdf_path}: {'; '.join(faults)}")
    if note:
        figure.suptitle(note, fontsize=8, color=VERMILION, weight="bold")
    path = Path(pdf_path)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"CreationDate": None, "Producer": None, "Creator": None})
    pixels = BytesIO()
    figure.savefig(pixels, format="png", dpi=min(300, WIDEST_PNG / figure.get_figwidth()))
    path.with_suffix(".png").write_bytes(png_with_palette(Image.open(pixels)))
    plt.close(figure)


def log_numbers(axis, low, high):
    """A logarithmic axis of less than two decades with plain numbers at 1, 2 and 5."""
    values = [digit * 10.0**power for power in range(-3, 4) for digit in (1, 2, 5)]
    axis.set_major_locator(FixedLocator([value for value in values if 0.9 * low <= value <= 1.1 * high]))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def legend_below(figure, ncols, **options):
    """One legend under all panels of a figure, every label once."""
    entries = {}
    for axes in figure.axes:
        handles, labels = axes.get_legend_handles_labels()
        entries |= dict(zip(labels, handles, strict=True))
    figure.legend(entries.values(), entries.keys(), loc="outside lower center", ncols=ncols, **options)


def add_pillars(axes, radius, pitch, row_shift, x_range, y_range):
    """Draws the circular pillars (n pitch, m pitch + n d) that reach into the given ranges."""
    first, last = round((x_range[0] - radius) // pitch), round((x_range[1] + radius) // pitch) + 1
    for n in range(first, last + 1):
        offset = n * row_shift
        low = round((y_range[0] - radius - offset) // pitch)
        high = round((y_range[1] + radius - offset) // pitch) + 1
        for m in range(low, high + 1):
            centre = (n * pitch, m * pitch + offset)
            axes.add_patch(plt.Circle(centre, radius, facecolor=PILLAR, edgecolor="none", zorder=0))


def panel_label(axes, letter, **options):
    """The letter of a panel, at its upper left outside the axes."""
    text = f"({letter})"
    axes.annotate(text, (0, 1), (-2, 4), xycoords="axes fraction", textcoords="offset points", **options)
