"""The results of a study as an RO-Crate 1.1: one JSON-LD file beside them that says what each file is, how it
was made and by which software, with its size and checksum."""

import hashlib
import mimetypes
from pathlib import Path

from study.analysis.software import project_version

PROFILE = "https://w3id.org/ro/crate/1.1"
PAPER = "https://doi.org/10.1063/1.4897913"
LICENCES = {"code": "https://spdx.org/licenses/MIT", "results": "https://spdx.org/licenses/CC-BY-4.0"}
METADATA = "ro-crate-metadata.json"
#: What lies in the folder of a study and is no result: raw runs, logs, what the next run makes anew.
LEFT_OUT = {"runs", "logs", "brackets", "spot_check", METADATA, "plan.json"}
KINDS = {"tables": "Table", "figures": "Figure", "claims": "Verdicts on the claims of the paper"}


def result_files(folder, others=()):
    """Files of the results of a study, relative to their folder; not those of other tiers within it."""
    out = LEFT_OUT | set(others)
    files = (path.relative_to(folder) for path in Path(folder).rglob("*") if path.is_file())
    return sorted(path for path in files if path.parts[0] not in out and not path.name.startswith("."))


def media_type(path):
    """Media type of a file by its name."""
    return mimetypes.guess_type(path.name)[0] or "application/octet-stream"


def file_entity(folder, path):
    """What the crate says of one file."""
    content = (Path(folder) / path).read_bytes()
    kind = KINDS.get(path.parts[0].split(".")[0], "Result")
    return {
        "@id": path.as_posix(),
        "@type": "File",
        "name": f"{kind}: {path.stem.replace('_', ' ')}",
        "encodingFormat": media_type(path),
        "contentSize": str(len(content)),
        "sha256": hashlib.sha256(content).hexdigest(),
    }


def software_entities():
    """The workflow that made the results, and the solver that it runs."""
    code = {"license": {"@id": LICENCES["code"]}, "version": project_version()}
    workflow = {
        "@id": "#workflow",
        "@type": ["SoftwareSourceCode", "ComputationalWorkflow"],
        "name": "Snakefile of DLD-RBC",
        "programmingLanguage": {"@id": "https://snakemake.github.io"},
        "hasPart": {"@id": "#solver"},
    }
    solver = {"@id": "#solver", "@type": "SoftwareApplication", "name": "dld, the solver"}
    language = {
        "@id": "https://snakemake.github.io",
        "@type": "ComputerLanguage",
        "name": "Snakemake",
    }
    return [workflow | code, solver | code, language]


def crate(folder, others=()):
    """The document of a folder of results; without a date, so that the same results are the same file."""
    files = [file_entity(folder, path) for path in result_files(folder, others)]
    parts = [{"@id": entity["@id"]} for entity in files]
    root = {
        "@id": "./",
        "@type": "Dataset",
        "name": "Results of DLD-RBC",
        "description": "Tables, figures and verdicts of a reproduction study of red blood cells in a "
        "deterministic lateral displacement array.",
        "license": {"@id": LICENCES["results"]},
        "author": {"@id": "#authors"},
        "citation": {"@id": PAPER},
        "hasPart": parts,
        "mentions": {"@id": "#made"},
    }
    made = {
        "@id": "#made",
        "@type": "CreateAction",
        "name": "The study",
        "instrument": {"@id": "#workflow"},
        "result": parts,
    }
    described = {
        "@id": METADATA,
        "@type": "CreativeWork",
        "conformsTo": {"@id": PROFILE},
        "about": {"@id": "./"},
    }
    paper = {"@id": PAPER, "@type": "ScholarlyArticle", "name": "Krueger, Holmes and Coveney (2014)"}
    authors = {"@id": "#authors", "@type": "Organization", "name": "The DLD-RBC authors"}
    graph = [described, root, made, authors, paper, *software_entities(), *files]
    return {"@context": f"{PROFILE}/context", "@graph": graph}
