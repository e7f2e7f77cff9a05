"""docs/faults.md from the outcomes of the attacks."""

from collections import Counter

HEAD = """# Attacks on the solver and what became of them

Each line is an input or an event that could crash the solver, make it hang, lose a result or pass nonsense
for one.
"Held" means: the right exit code, a message that names the place, no file lost, no label that was not proved.
"Open" means that it does not hold yet; the reason stands beside it.
The inputs and their right answers are data in [tests/attacks](../tests/attacks); `bash workflow/test-deep`
tries all of them and writes this page.

"""


def cell(text):
    """Text that a cell of a Markdown table shows as it is."""
    plain = "".join(letter if letter.isprintable() else f"\\u{ord(letter):04x}" for letter in text)
    for letter in "\\`*_<>|$[]":
        plain = plain.replace(letter, f"\\{letter}")
    return plain


def merged_rows(outcomes):
    """Rows of the table: (group, what, times, faults); those of one kind are one row."""
    kinds = {}
    for outcome in outcomes:
        row = outcome.row
        name = f"every parameter: {row['kind']}" if "kind" in row else row["what"]
        times, faults = kinds.setdefault((row["group"], name), (0, []))
        added = [f"{row['what']}: {fault}" if "kind" in row else fault for fault in outcome.faults]
        kinds[row["group"], name] = (times + row.get("times", 1), faults + added)
    return [(*name, *found) for name, found in kinds.items()]


def faults_page(outcomes):
    """The page as text."""
    outcomes = list(outcomes)
    tries = sum(outcome.row.get("times", 1) for outcome in outcomes)
    held = sum(outcome.row.get("times", 1) for outcome in outcomes if outcome.held)
    counts = Counter(outcome.held for outcome in outcomes)
    lines = [
        f"{len(outcomes)} attacks, {tries} tries: {counts[True]} attacks ({held} tries) held, "
        f"{counts[False]} are open.\n",
        "| group | what was done | how often | outcome |",
        "| --- | --- | ---: | --- |",
    ]
    for group, what, times, faults in merged_rows(outcomes):
        end = "held" if not faults else "open: " + "; ".join(faults[:3]) + (" ..." if len(faults) > 3 else "")
        lines.append(f"| {cell(group)} | {cell(what)} | {times} | {cell(end)} |")
    return HEAD + "\n".join(lines) + "\n"
