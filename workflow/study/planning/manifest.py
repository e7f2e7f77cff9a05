"""Checksums of the tables, figures and verdicts of a study, kept in a table beside them: whether they are as
the pipeline made them.

Only the pipeline writes to the table, when a call ends; so a file that was changed by hand differs from it.
A call that is killed cannot write: what it was to make stands in a journal, which the next call settles.
"""

import csv
import hashlib
import json
from pathlib import Path

MANIFEST = "manifest.csv"
HEADER = ["file", "bytes", "sha256"]
FOLDERS = ("tables", "figures")  # with results; files beside them are verdicts and pages
CURE = (
    "restore each (git checkout -- FILE), have it made again (snakemake --force FILE), or, if all are as "
    "they should be, say so (python workflow/scripts/planning/manifest.py --accept FOLDER)"
)


class Changed(Exception):
    """Results are not as they were made."""

    def __init__(self, paths):
        listed = "\n".join(f"  {path}" for path in paths)
        super().__init__(f"not as the pipeline made them:\n{listed}\n{CURE}")


def is_result(path):
    """Is a path, relative to the folder of a study, that of a table, a figure or a page of results?"""
    return len(path.parts) == 1 or (len(path.parts) == 2 and path.parts[0] in FOLDERS)


def entry(path):
    """Size and checksum of a file, as they stand in the table."""
    content = path.read_bytes()
    return str(len(content)), hashlib.sha256(content).hexdigest()


def recorded(folder):
    """{file: (size, checksum)} of the table of a folder of results."""
    try:
        with (Path(folder) / MANIFEST).open(encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
    except FileNotFoundError:
        return {}
    if not rows or rows[0] != HEADER or any(len(row) != len(HEADER) for row in rows):
        raise ValueError(f"{Path(folder) / MANIFEST} is damaged: restore it (git checkout -- FILE)")
    return {row[0]: tuple(row[1:]) for row in rows[1:]}


def within(folder, paths):
    """Those of some paths that are results of a folder, relative to it."""
    inside = (Path(path) for path in paths)
    found = (path.relative_to(folder) for path in inside if path.is_relative_to(folder))
    return [path for path in found if is_result(path) and path.name != MANIFEST]


def record(folder, paths):
    """Puts files of a folder of results, by their names in it, into its table; takes out what is gone."""
    folder, known = Path(folder), recorded(folder)
    for path in paths:
        if (folder / path).is_file():
            known[Path(path).as_posix()] = entry(folder / path)
        else:
            known.pop(Path(path).as_posix(), None)
    part = folder / f"{MANIFEST}.part"
    with part.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADER)
        table.writerows([name, *known[name]] for name in sorted(known))
    part.replace(folder / MANIFEST)


def changed(folder, paths=None):
    """Files of the table (or those of them among some paths) that are there with another content."""
    folder, known = Path(folder), recorded(folder)
    asked = known if paths is None else {path.as_posix() for path in within(folder, paths)} & set(known)
    there = (name for name in sorted(asked) if (folder / name).is_file())
    return [str(folder / name) for name in there if entry(folder / name) != known[name]]


def begin(folder, journal, jobs):
    """Before the jobs of a call, each as (files that it reads, files that it makes): what they read and do
    not make has to be as it was made, or Changed is raised; what they will make goes into the journal."""
    made = {path for _, outputs in jobs for path in outputs}
    read = {path for inputs, _ in jobs for path in inputs} - made
    if wrong := changed(folder, read):
        raise Changed(wrong)
    journal = Path(journal)
    journal.parent.mkdir(parents=True, exist_ok=True)
    names = [path.as_posix() for path in within(folder, made)]
    journal.write_text(json.dumps({"folder": str(folder), "files": sorted(names)}), encoding="utf-8")


def settle(journal):
    """Records what the call of a journal has made: what is younger than it. Ends the journal."""
    journal = Path(journal)
    try:
        told = json.loads(journal.read_text(encoding="utf-8"))
        folder, names = Path(told["folder"]), told["files"]
    except FileNotFoundError:
        return
    except (ValueError, KeyError):  # the call was killed while it wrote: before its first job
        journal.unlink()
        return
    begun = journal.stat().st_mtime_ns
    there = [name for name in names if (folder / name).is_file()]
    if made := [name for name in there if (folder / name).stat().st_mtime_ns >= begun]:
        record(folder, made)
    journal.unlink()


def accept(folder):
    """Makes the table anew from what is there; the names of its files."""
    folder = Path(folder)
    files = [path for path in folder.glob("*") if path.suffix in (".csv", ".md")]
    for name in FOLDERS:
        files += [path for path in (folder / name).glob("*") if path.is_file()]
    names = sorted({path.as_posix() for path in within(folder, files)} | set(recorded(folder)))
    record(folder, names)
    return names
