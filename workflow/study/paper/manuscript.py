"""Numbers and tables of the article, looked up in the results as paper/numbers.toml declares them.

Nothing is computed here but counts, means and ranges: what needs a formula belongs in a table of the study,
or in article_tables.py if it sets the print beside the results. A row that a tier lacks gives MISSING; a name
that no table has is an error, so that a slip of the pen shows.
"""

import math
import re
from fnmatch import fnmatchcase
from itertools import product

import numpy as np
import pandas as pd

MISSING = "n/a"

SPECIAL = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
SPECIAL |= {letter: "\\" + letter for letter in "&%$#_{}"}

#: Plain notation of the tables and its typeset form, applied in this order after escaping.
NOTATION = [
    (r"\b\d{7,}(?:\.0)?\b", lambda m: scientific(float(m[0]), 1)),
    (r"(\d(?:\.\d+)?)e([+-]?)0*(\d+)", lambda m: rf"${m[1]}\times10^{{{m[2].strip('+')}{m[3]}}}$"),
    (r"D\\_perp", r"$D_\\perp$"),
    (r"D\\_cr", r"$D_\\mathrm{cr}$"),
    (r"u\\_mean", r"$\\bar u$"),
    (r"\\textasciicircum\{\}(\d+(?:\.\d+)?)", r"$^{\1}$"),
    (r"\beps\b", r"$\\varepsilon$"),
    (r"(?<![A-Za-z])um\b", r"\\textmu{}m"),
    (r"\+-", r"$\\pm$"),
    (r">=", r"$\\ge$"),
    (r"<=", r"$\\le$"),
    (r">", r"$>$"),
    (r"<", r"$<$"),
    (r"sqrt\(G H\)", r"$\\sqrt{GH}$"),
    (r" \.\.\. ", r"\\,\\dots\\,"),
    (r"\\_", " "),
]


def typeset(text):
    """Text of a table as LaTeX: special letters escaped, the tables' plain notation typeset."""
    result = "".join(SPECIAL.get(letter, letter) for letter in str(text))
    for pattern, replacement in NOTATION:
        result = re.sub(pattern, replacement, result)
    return result


def scientific(value, digits):
    """A number as LaTeX: mantissa with `digits` decimals times a power of ten."""
    mantissa, exponent = format(value, f".{digits}e").split("e")
    return rf"\ensuremath{{{mantissa}\times10^{{{int(exponent)}}}}}"


def shown(value, style):
    """One value as LaTeX. Styles: a number format such as .2f, sci:2, percent:1, text."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return MISSING
    name, _, digits = style.partition(":")
    if name == "text":
        return typeset(value)
    try:
        number = float(value)
    except (TypeError, ValueError):  # text in a column of numbers
        return typeset(value)
    if name == "sci":
        return scientific(number, int(digits))
    text = format(100 * number, f".{digits}f") if name == "percent" else format(number, style)
    return text.lstrip("-") if float(text) == 0 else text.replace("-", r"\ensuremath{-}", text[0] == "-")


def matches(value, wanted):
    """Whether a cell has the wanted value: one of a list, a pattern with *, or a number to rounding."""
    if isinstance(wanted, list):
        return any(matches(value, one) for one in wanted)
    if isinstance(wanted, str):
        return fnmatchcase(str(value), wanted)
    try:
        return math.isclose(float(value), wanted, rel_tol=1e-4, abs_tol=1e-9)
    except (TypeError, ValueError):
        return False


def select(frame, where):
    """The rows that match every condition {column: wanted}; of a list of such conditions one of them."""
    if isinstance(where, list):
        return frame[frame.index.isin([row for one in where for row in select(frame, one).index])]
    keep = pd.Series(True, index=frame.index)
    for column, wanted in where.items():
        if column not in frame:
            raise KeyError(f"there is no column '{column}' among {', '.join(frame)}")
        keep &= frame[column].map(lambda value, wanted=wanted: matches(value, wanted)).astype(bool)
    return frame[keep]


def reduced(values, how):
    """A pair (first, last) that stands for a series of values: `range` gives two values, others twice one."""
    if how == "count":
        return values.nunique(), values.nunique()
    values = values.dropna()
    if values.empty:
        return None, None
    if how == "only":
        if values.nunique() > 1:
            raise ValueError(f"one row expected, found {len(values)} different ones")
        return values.iloc[0], values.iloc[0]
    if how == "range":
        return values.min(), values.max()
    value = getattr(values, how)()
    return value, value


def at_pointer(document, pointer):
    """The value at a path such as /claims/id=reynolds/value; None if a step is not there."""
    for step in pointer.strip("/").split("/"):
        key, _, wanted = step.partition("=")
        if isinstance(document, list) and wanted:
            document = next((item for item in document if str(item.get(key)) == wanted), None)
        elif isinstance(document, list):
            document = document[int(step)] if int(step) < len(document) else None
        else:
            document = document.get(step) if isinstance(document, dict) else None
    return document


def expanded(entry):
    """An entry for every combination of the values in its `each`, put in for {name} wherever it stands."""
    names = entry.get("each", {})
    for combination in product(*names.values()):
        filling = dict(zip(names, combination, strict=True))

        def filled(value, filling=filling):
            if isinstance(value, dict):
                return {key: filled(part) for key, part in value.items()}
            if isinstance(value, list):
                return [filled(part) for part in value]
            if isinstance(value, str):
                whole = re.fullmatch(r"\{(\w+)\}", value)
                if whole and whole[1] in filling:
                    return filling[whole[1]]
                return re.sub(r"\{(\w+)\}", lambda m: str(filling.get(m[1], m[0])), value)
            return value

        yield filled({key: value for key, value in entry.items() if key != "each"})


def number(entry, tables, documents):
    """The text of one declared number."""
    style = entry.get("format", "text")
    if "json" in entry:
        first = last = at_pointer(documents[entry["json"]], entry["at"])
    else:
        frame = tables.get(entry["table"])
        if frame is None:
            return MISSING
        how = entry.get("reduce", "only")
        rows = select(frame, entry.get("where", {}))
        if entry["column"] not in frame:
            raise KeyError(f"{entry['key']}: table {entry['table']} has no column '{entry['column']}'")
        first, last = reduced(rows[entry["column"]], how)
    if isinstance(first, dict | list):
        raise ValueError(f"{entry['key']}: {entry['at']} is not one value but {first}")
    if "words" in entry:
        return entry["words"].get(str(first), MISSING if first is None else typeset(first))
    low, high = shown(first, style), shown(last, style)
    return low if low == high else f"{low}--{high}"


def numbers(declared, tables, documents):
    """Texts of all declared numbers by key."""
    found = {}
    for entry in (one for group in declared for one in expanded(group)):
        if entry["key"] in found:
            raise ValueError(f"the number '{entry['key']}' is declared twice")
        found[entry["key"]] = number(entry, tables, documents)
    return found


def sorted_by(frame, keys):
    """Rows sorted by columns; `-|name|` means by falling magnitude."""
    for key in reversed(keys):
        size = re.fullmatch(r"-\|(\w+)\|", key)
        if size:
            magnitude = pd.to_numeric(frame[size[1]], errors="coerce").abs()
            frame = frame.loc[magnitude.sort_values(ascending=False, kind="stable").index]
        else:
            frame = frame.sort_values(key, kind="stable", key=as_numbers_first)
    return frame


def as_numbers_first(column):
    """Sort key of a column that may hold words among its numbers."""
    numeric = pd.to_numeric(column, errors="coerce")
    return numeric.fillna(float("inf")) if numeric.notna().any() else column.astype(str)


def spread(frame, pivot):
    """The frame with one row for each `index` and columns named `value name` for each name in `columns`."""
    keys = [*pivot["index"], pivot["columns"]]
    wide = frame.drop_duplicates(keys).set_index(keys)[pivot["values"]].unstack()
    wide.columns = [f"{value} {name}" for value, name in wide.columns]
    return wide.reset_index()


def interval(low, high):
    """Text of a bracket, open where an end is missing."""
    if MISSING in (low, high):
        ends = [sign + text for sign, text in (("$>$", low), ("$<$", high)) if text != MISSING]
        return ends[0] if ends else MISSING
    return f"{low}--{high}"


def cell(row, column):
    """Text of one cell; a pair of values is a bracket."""
    names = column["value"] if isinstance(column["value"], list) else [column["value"]]
    texts = [shown(row.get(name), column.get("format", "text")) for name in names]
    text = interval(*texts) if len(texts) == 2 else texts[0]
    text = column.get("words", {}).get(str(row.get(names[0])), text)
    return "" if text == MISSING else text.removeprefix(column.get("drop", ""))


def body(entry, tables):
    """The lines of a declared table between its rules; one line that says so where there are no rows."""
    columns, frame = entry["columns"], tables.get(entry["table"])
    rows = pd.DataFrame() if frame is None else select(frame, entry.get("where", {}))
    if len(rows) and "pivot" in entry:
        rows = spread(rows, entry["pivot"])
        rows = rows.dropna(subset=[name for name in entry.get("require", []) if name in rows])
    if rows.empty:
        return [rf"\multicolumn{{{len(columns)}}}{{l}}{{(no rows in this tier)}} \\"]
    for name in (name for column in columns for name in np.atleast_1d(column["value"])):
        if name not in rows and "pivot" not in entry:
            raise KeyError(f"table {entry['table']} has no column '{name}'")
    rows = sorted_by(rows, entry.get("sort", [])).head(entry.get("rows", len(rows)))
    gap = r" \\[2pt]" if entry.get("long") else r" \\"
    return [" & ".join(cell(row, column) for column in columns) + gap for _, row in rows.iterrows()]


def table(entry, tables):
    """A declared table as LaTeX: a tabular, or a longtable with a repeated head."""
    layout = "".join(column.get("layout", "l") for column in entry["columns"])
    head = " & ".join(column["head"] for column in entry["columns"]) + r" \\"
    lines = body(entry, tables)
    if entry.get("long"):
        top = [rf"\begin{{longtable}}{{{layout}}}", r"\toprule", head, r"\midrule", r"\endhead"]
        top += [r"\bottomrule", r"\endfoot"]
        return "\n".join([*top, *lines, r"\end{longtable}"]) + "\n"
    top = [rf"\begin{{tabular}}{{{layout}}}", r"\toprule", head, r"\midrule"]
    return "\n".join([*top, *lines, r"\bottomrule", r"\end{tabular}"]) + "\n"
