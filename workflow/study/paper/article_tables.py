"""Tables of the article that set the print beside the results. Nothing is fitted here."""

import numpy as np
import pandas as pd

from study.analysis.boundary import PARAMETERS, UNDISPUTED, critical_capillary_number
from study.paper.claims import SWEEP
from study.paper.claims_page import column_of
from study.paper.grades import GRADES

EXTENTS_UM = 6.8  # row shift (um) of the printed extents


def claim_of(printed, name):
    """A claim by its id."""
    return next(claim for claim in printed["claims"] if claim["id"] == name)


def beside_print(boundary, claim):
    """The table of the boundary with two more series: `eq-5`, where the paper's law has a row shift, and
    `text`, the classes that the paper states at it."""
    law = [claim["value"][name] for name in PARAMETERS]
    shifts = sorted(set(boundary.row_shift_um))
    at = pd.Series([critical_capillary_number(shift, law) for shift in shifts], dtype=float)
    printed = pd.DataFrame({"series": "eq-5", "row_shift_um": shifts} | dict.fromkeys(UNDISPUTED, at))
    said = pd.DataFrame(claim["statements"]).assign(series="text")
    said = said.rename(columns=dict(zip(("displaced_to", "zigzag_from"), UNDISPUTED, strict=True)))
    said = said[said.row_shift_um.isin(shifts)][list(printed)].astype(dict.fromkeys(UNDISPUTED, float))
    return pd.concat([boundary, printed, said], ignore_index=True)


def extents(passages, predictions, claim):
    """Extents at the row shift of the printed ones, by sweep; the print as `printed` and the transverse
    diameter of the stretched cell as `tweezer`."""
    columns = ["sweep", "capillary_number", "d_perp_um"]
    tweezer = predictions[predictions.sweep == SWEEP].assign(sweep="tweezer")
    tweezer = tweezer.assign(d_perp_um=tweezer.tweezer_um)
    here = [table[np.isclose(table.row_shift_um, EXTENTS_UM)] for table in (passages, tweezer)]
    printed = [("printed", float(capillary), extent) for capillary, extent in claim["value"].items()]
    tables = [*(table[columns] for table in here), pd.DataFrame(printed, columns=columns)]
    return pd.concat(tables, ignore_index=True)


def grades_by_reading(verdicts, readings):
    """How many claims got each grade, a row for every reading that was judged."""
    rows = []
    for reading in readings:
        column = column_of(reading, readings)
        if column in verdicts:
            counts = verdicts[column].value_counts()
            rows.append({"reading": reading["id"], "description": reading["description"]})
            rows[-1] |= {grade: counts.get(grade, 0) for grade in GRADES}
    return pd.DataFrame(rows, columns=["reading", "description", *GRADES])


def with_moduli(laws, case):
    """The bending laws with the modulus (N m) stated for a healthy cell and the one that its fold feels."""

    def default(section, name):
        return case["properties"][section]["properties"][name]["default"]

    radius, shear = default("cell", "radius_um"), default("stretching", "shear_modulus_uN_per_m")
    stated = default("cell", "bending_ratio") * shear * 1e-6 * (radius * 1e-6) ** 2
    return laws.assign(stated_modulus_Nm=stated, fold_modulus_Nm=stated * laws.fold_modulus_ratio)


def article_tables(tables, printed, case):
    """The tables of the study with those of the article, as far as what they are made of is there."""
    found = dict(tables)
    found["readings"] = grades_by_reading(tables["claims"], printed["readings"])
    if "phase_boundary" in tables:
        found["phase_boundary"] = beside_print(tables["phase_boundary"], claim_of(printed, "phase-boundary"))
    if {"passages", "a_priori"} <= set(tables):
        claim = claim_of(printed, "d-perp-6.8")
        found["extents"] = extents(tables["passages"], tables["a_priori"], claim)
    if "bending_laws" in tables:
        found["bending_laws"] = with_moduli(tables["bending_laws"], case)
    return found
