"""Where a study is read from and where its results go."""

from pathlib import Path

from study.planning.validation import hint

STUDIES = Path("params/studies")
#: The study that a bare command runs.
PAPER = "krueger2014"
#: Folders of results/ that no study may take for its own.
TAKEN = {"runs", "brackets", "tables", "figures", "logs", "spot_check"}


def study_file(name):
    """The file of a study; a ValueError that names the known ones where there is none."""
    path = STUDIES / f"{name}.json"
    known = sorted(file.stem for file in STUDIES.glob("*.json"))
    if name not in known:
        raise ValueError(f"there is no study '{name}' in {STUDIES}; {hint(name, known)}")
    return str(path)


def results_folder(file, tier, tiers):
    """Folder of the results of a tier: results/ for the paper's study, results/<study>/ for another one, and
    below it the tier's name unless it is the study's first."""
    name = Path(file).stem
    if name in TAKEN:
        raise ValueError(f"{file}: results/{name} has another use; give the study another name")
    place = Path("results") if name == PAPER else Path("results") / name
    return str(place if tier == next(iter(tiers)) else place / tier)
