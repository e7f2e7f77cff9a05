"""Tables as CSV: sorted rows, fixed number formats, units in the header, so that `diff` compares studies."""

from pathlib import Path

import pandas as pd

#: What would end a cell of a Markdown table, or be HTML or a link in it, and what shows the same.
IN_MARKDOWN = {"|": "\\|", "<": "&lt;", "](": "]\\(", "\r": " ", "\n": " "}


def in_markdown(cell):
    """A text that shows itself in a cell of a Markdown table."""
    text = str(cell)
    for found, shown in IN_MARKDOWN.items():
        text = text.replace(found, shown)
    return text


def markdown_table(titles, rows):
    """The lines of a Markdown table from texts."""
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * len(titles)]
    return lines + ["| " + " | ".join(map(in_markdown, row)) + " |" for row in rows]


def formatted(value, style):
    """Text of one cell; a missing or undefined number is an empty cell."""
    if value is None or (isinstance(value, float) and value != value):
        return ""
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float) or (hasattr(value, "dtype") and value.dtype.kind == "f"):
        text = format(float(value), style)
        return text.lstrip("-") if float(text) == 0 else text
    return str(value)


def cell(name, value, styles):
    """Text of one cell in the style of its column, or with six digits."""
    return formatted(value, styles.get(name, ".6g"))


def write_table(rows, columns, path, sort_by=(), styles=None):
    """Writes rows (dictionaries) with these columns; `styles` maps a column to a number format."""
    styles = styles or {}
    frame = pd.DataFrame([{name: row.get(name) for name in columns} for row in rows], columns=columns)
    frame = frame.astype(object).where(frame.notna(), None)
    if len(frame) and sort_by:
        frame = frame.sort_values(list(sort_by), kind="stable")
    for name in columns:
        frame[name] = [cell(name, value, styles) for value in frame[name]]
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    frame.to_csv(path, index=False, lineterminator="\n")


def read_table(path):
    """A table as a data frame."""
    return pd.read_csv(path)
