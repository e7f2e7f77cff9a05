"""Content of the report: points of the phase space, trajectories, figures inside the page, tables as text."""

import base64
import json
import math

from PIL import Image

from study.drawing.pictures import png_with_palette
from study.paper.report_evidence import set_in_words

CLASSES = ["displaced", "zigzag", "undecided", "diverged", "failed", "interrupted"]
IMAGE_WIDTH = 1380  # pixels; twice the width at which the page shows a figure
SHOWN = ["d_perp_um", "film_um", "crossings", "steps"]


class Axes:
    """Maps capillary number (logarithmic) and row shift in um (linear) to the picture's coordinates."""

    width, height, left, right, top, bottom = 640, 420, 62, 14, 14, 50

    def __init__(self, capillary, row_shifts):
        self.low, self.high = min(capillary) / 1.15, max(capillary) * 1.15
        self.bottom_um, self.top_um = min(row_shifts) - 0.6, max(row_shifts) + 0.6

    def x(self, capillary):
        share = math.log(capillary / self.low) / math.log(self.high / self.low)
        return round(self.left + share * (self.width - self.left - self.right), 1)

    def y(self, row_shift):
        share = (row_shift - self.bottom_um) / (self.top_um - self.bottom_um)
        return round(self.height - self.bottom - share * (self.height - self.top - self.bottom), 1)

    def x_ticks(self):
        steps = [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10]
        return [(self.x(value), f"{value:g}") for value in steps if self.low <= value <= self.high]

    def y_ticks(self):
        whole = range(math.ceil(self.bottom_um), math.floor(self.top_um) + 1)
        return [(self.y(value), str(value)) for value in whole]

    def curve(self, offset, amplitude, rate, samples=80):
        """SVG path of d = offset + amplitude exp(-rate Ca) within the axes."""
        path = []
        for step in range(samples + 1):
            capillary = self.low * (self.high / self.low) ** (step / samples)
            row_shift = offset + amplitude * math.exp(-rate * capillary)
            if self.bottom_um <= row_shift <= self.top_um:
                path.append(f"{self.x(capillary)},{self.y(row_shift)}")
        return "M" + "L".join(path) if path else ""


def plain(value, digits=3):
    """A number for the page: rounded, None where there is none."""
    if value is None or value != value:
        return None
    return value if isinstance(value, str) else round(float(value), digits)


def phase_space(passages, readings):
    """(sets, points, axes): sets of passages of one sweep and lattice, largest first, and their points."""
    rows = passages.dropna(subset=["capillary_number", "row_shift_um"])
    if rows.empty:
        return [], [], None
    axes = Axes(rows.capillary_number, rows.row_shift_um)
    sets, points = {}, []
    for row in rows.to_dict("records"):
        key = (row["sweep"], row["dx_um"], row["lateral_flow"], row["skalak_denominator"])
        group = sets.setdefault(key, {"id": f"set-{len(sets)}", "count": 0})
        group["label"] = set_in_words(row["sweep"], row["dx_um"], row["lateral_flow"], readings)
        group["count"] += 1
        point = {"set": group["id"], "run": row["run"], "sweep": row["sweep"], "class": row["class"]}
        point |= {"ca": plain(row["capillary_number"], 4), "d": plain(row["row_shift_um"], 2)}
        point |= {"dx": plain(row["dx_um"], 4), "failing": plain(row.get("failing_quantity"))}
        point |= {name: plain(row.get(name)) for name in SHOWN}
        point |= {"x": axes.x(row["capillary_number"]), "y": axes.y(row["row_shift_um"])}
        points.append(point)
    return sorted(sets.values(), key=lambda one: -one["count"]), points, axes


def boundaries(fits, printed, axes):
    """Curves of the boundary in the phase space: the printed one and each fit `boundary/<series>`."""
    names = ("offset_um", "amplitude_um", "rate")
    curves = [{"label": "printed", "path": axes.curve(*(printed[name] for name in names))}]
    for name, rows in fits[fits.name.str.startswith("boundary/")].groupby("name"):
        values = rows.set_index("parameter").value
        if set(names) <= set(values.index):
            path = axes.curve(*(values[one] for one in names))
            curves.append({"label": name.removeprefix("boundary/"), "path": path})
    return curves


def trajectories(table):
    """Trajectories by run as flat lists x, y, x, y ... in whole tenths of um."""
    return {
        run: [round(10 * value) for pair in zip(rows.x_um, rows.y_um, strict=True) for value in pair]
        for run, rows in table.groupby("run")
    }


def embedded(path):
    """(data URI, width, height) of an image: animations as they are, pictures at screen size with a palette.
    The size is that at which the page shows it, so that the page keeps its place before it is loaded."""
    with Image.open(path) as picture:
        width, height = picture.size
        if path.suffix == ".gif":
            text = "data:image/gif;base64," + base64.b64encode(path.read_bytes()).decode()
            return text, width, height
        small = picture.convert("RGB")
        if small.width > IMAGE_WIDTH:
            size = (IMAGE_WIDTH, round(small.height * IMAGE_WIDTH / small.width))
            small = small.resize(size, Image.Resampling.LANCZOS)
        text = "data:image/png;base64," + base64.b64encode(png_with_palette(small)).decode()
        return text, small.width // 2, small.height // 2


def figures(folder, captions):
    """Figures and animations of a folder: first those with a caption, in its order, then the others."""
    found = {path.stem: path for path in sorted(folder.glob("*.gif"))}
    found = {path.stem: path for path in sorted(folder.glob("*.png"))} | found
    order = [name for name in captions if name in found] + [name for name in found if name not in captions]
    for name in order:
        data, width, height = embedded(found[name])
        yield {
            "name": name,
            "caption": captions.get(name, name),
            "data": data,
            "width": width,
            "height": height,
        }


def as_script(document):
    """JSON that may stand inside a script element."""
    return json.dumps(document, separators=(",", ":"), sort_keys=True).replace("<", "\\u003c")


def as_rows(frame, limit=None):
    """(header, rows) of a data frame as text, missing cells empty."""
    head = frame if limit is None else frame.head(limit)
    rows = [["" if cell != cell or cell is None else cell for cell in row] for row in head.to_numpy(object)]
    return list(frame.columns), [
        [f"{c:.6g}" if isinstance(c, float) else str(c) for c in row] for row in rows
    ]
