"""The devices and cells of a study: what a section of the study says about them becomes part of a case."""

from study.planning.validation import hint, load_json


def case_parts(study, folder):
    """{"devices": {name: part of a case}, "cells": {name: part of a case}} of a study, and the shear moduli
    of the cells where they are given. A cell of a `type` begins with the values of that file in `folder`; a
    ValueError where there is none of that name."""
    cells, moduli = {}, {}
    for name, entry in study["cells"].items():
        below = {}
        if kind := entry.get("type"):
            known = sorted(path.stem for path in folder.glob("*.json"))
            if kind not in known:
                raise ValueError(f"/cells/{name}/type: there is no cell '{kind}'; {hint(kind, known)}")
            file = load_json(folder / f"{kind}.json")
            below, moduli[name] = file["cell"], file.get("shear_modulus_uN_per_m")
        cells[name] = {"cell": below | entry.get("cell", {})}
        moduli[name] = entry.get("shear_modulus_uN_per_m", moduli.get(name))
    return {
        "devices": {name: {"geometry": geometry} for name, geometry in study["devices"].items()},
        "cells": cells,
        "shear_moduli_uN_per_m": moduli,
    }


def device_of(tier, name=None):
    """(labels, part of a case) of a device by its name; without one the first of the study."""
    name = name or next(iter(tier["devices"]))
    return {"device": name}, tier["devices"][name]


def placed(tier, entry):
    """(labels, parts of a case) of the device and the cell that an entry names, else of the first ones."""
    labels, device = device_of(tier, entry.get("device"))
    name = entry.get("cell", next(iter(tier["cells"])))
    return labels | {"cell": name}, (device, tier["cells"][name])


def with_moduli(cells, tier):
    """The cells of a study with the shear moduli of their types, where these give it."""
    known = {name: modulus for name, modulus in tier["shear_moduli_uN_per_m"].items() if modulus is not None}
    return {
        name: entry | ({"shear_modulus_uN_per_m": known[name]} if name in known else {})
        for name, entry in cells.items()
    }
