"""Where a study is read from and where its results go."""

from pathlib import Path

from study.planning.validation import hint, load_json

STUDIES = Path("params/studies")
#: The study that a bare command runs.
PAPER = "krueger2014"
#: Folders that the results of a tier have; no study and no tier may be called so.
TAKEN = {"runs", "brackets", "tables", "figures", "logs", "spot_check", "claims", "paper"}


def study_file(name):
    """The file of a study; a ValueError that names the known ones where there is none."""
    path = STUDIES / f"{name}.json"
    known = sorted(file.stem for file in STUDIES.glob("*.json"))
    if name not in known:
        raise ValueError(f"there is no study '{name}' in {STUDIES}; {hint(name, known)}")
    return str(path)


def _tiers_of_the_paper():
    """Tiers of the paper's study beside its first, which have folders in results/ as other studies have."""
    file = STUDIES / f"{PAPER}.json"
    return list(load_json(file)["tiers"])[1:] if file.is_file() else []


def _check_names(file, tiers):
    """A ValueError where a folder of the study's results would be another one's too."""
    name, places = Path(file).stem, list(tiers)[1:]  # the first tier has no folder of its own
    others = {path.stem for path in STUDIES.glob("*.json")} if name == PAPER else set()
    if name in TAKEN or (name != PAPER and name in _tiers_of_the_paper()):
        raise ValueError(f"{file}: results/{name} has another use; give the study another name")
    for tier in places:
        if tier in TAKEN or tier in others:
            where = "results" if name == PAPER else f"results/{name}"
            raise ValueError(
                f"{file}: /tiers/{tier}: {where}/{tier} has another use; give the tier another name"
            )


def results_folder(file, tier, tiers):
    """Folder of the results of a tier: results/ for the paper's study, results/<study>/ for another one, and
    below it the tier's name unless it is the study's first."""
    _check_names(file, tiers)
    name = Path(file).stem
    place = Path("results") if name == PAPER else Path("results") / name
    return str(place if tier == next(iter(tiers)) else place / tier)
