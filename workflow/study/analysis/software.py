"""The software that the study is made with, as a CycloneDX document: the solver's libraries and the locked
Python packages, with versions, hashes and licences."""

import csv
import json
import re
import subprocess
from importlib import metadata
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
LIBRARIES = ROOT / "workflow/libraries.csv"
LOCK = ROOT / "workflow/requirements.txt"
SPEC = "1.6"


def locked_packages(text):
    """(name, version, marker, sha256 hashes) of every package of a lock."""
    lines = re.sub(r"\\\n\s*", " ", text).splitlines()
    for line in lines:
        found = re.match(
            r"([A-Za-z0-9_.-]+)==(\S+)\s*(?:;\s*(.*?))?((?:\s+--hash=sha256:[0-9a-f]{64})+)$", line
        )
        if found:
            name, version, marker, hashes = found.groups()
            yield name, version, marker or "", re.findall(r"[0-9a-f]{64}", hashes)


def libraries():
    """Rows of workflow/libraries.csv."""
    with LIBRARIES.open(encoding="utf-8", newline="") as table:
        return list(csv.DictReader(table))


def installed_version(package):
    """Version of an installed Debian package, without its epoch; "" where it is not known."""
    command = ["dpkg-query", "-W", "-f=${Version}", package]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return ""
    return done.stdout.split(":")[-1] if done.returncode == 0 else ""


def python_licence(name):
    """Licence of an installed Python package in its own words, at most a line; "" where it says nothing."""
    try:
        about = metadata.metadata(name)
    except metadata.PackageNotFoundError:
        return ""
    classifiers = [entry.split(" :: ")[-1] for entry in about.get_all("Classifier", []) if "License" in entry]
    given = about.get("License-Expression") or about.get("License") or ""
    return given if given and "\n" not in given else " AND ".join(classifiers)


def licences(text):
    """A licence as CycloneDX writes it: an expression of known identifiers, else a name."""
    if not text:
        return []
    known = re.fullmatch(r"[A-Za-z0-9.+-]+( (AND|OR|WITH) [A-Za-z0-9.+-]+)*", text)
    return [{"expression": text} if known else {"license": {"name": text}}]


def library_component(row):
    """A library of the solver."""
    version = installed_version(row["package"])
    return {
        "type": "library",
        "bom-ref": f"debian:{row['package']}",
        "name": row["name"],
        "version": version,
        "purl": f"pkg:deb/debian/{row['package']}" + (f"@{version}" if version else ""),
        "description": f"{row['used_for']}; {row['how']}",
        "scope": "excluded" if row["how"] == "tests alone" else "required",
        "licenses": licences(row["licence"]),
    }


def python_component(name, version, marker, hashes):
    """A package of the lock. Its hashes are those of all its files, of which an installation takes one."""
    return {
        "type": "library",
        "bom-ref": f"python:{name}@{version}",
        "name": name,
        "version": version,
        "purl": f"pkg:pypi/{name}@{version}",
        "licenses": licences(python_licence(name)),
        "properties": [{"name": "marker", "value": marker}] * bool(marker)
        + [{"name": "sha256 of a file", "value": value} for value in hashes],
    }


def software_list(version):
    """The CycloneDX document; without a date and a serial number: the same software is the same file."""
    components = [library_component(row) for row in libraries()]
    components += [python_component(*found) for found in locked_packages(LOCK.read_text(encoding="utf-8"))]
    return {
        "bomFormat": "CycloneDX",
        "specVersion": SPEC,
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": "dld-rbc",
                "name": "DLD-RBC",
                "version": version,
                "licenses": [{"expression": "MIT"}],
            }
        },
        "components": components,
        "dependencies": [{"ref": "dld-rbc", "dependsOn": [part["bom-ref"] for part in components]}],
    }


def project_version():
    """Version of the solver, from CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(dld VERSION (\S+)", text).group(1)


def as_text(document):
    """A JSON document as it is written to files."""
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
