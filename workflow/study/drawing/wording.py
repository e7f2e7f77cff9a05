"""The choices of the sensitivity study in words, for labels."""

WORDS = {
    ("bending_law", "hinge_sheet"): "softer folds (hinge_sheet)",
    ("bending_law", "hinge_sphere"): "stiffer folds (hinge_sphere)",
    ("bending_law", "mean_curvature"): "bending by mean curvature",
    ("capillary_factor", "1.6"): "all Ca × 1.6",
    ("collision", "bgk"): "collision: BGK",
    ("crossing", "last"): "extent: last crossing",
    ("crossing", "mean"): "extent: mean of crossings",
    ("crossing", "narrowest"): "extent: narrowest crossing",
    ("crossing", "widest"): "extent: widest crossing",
    ("equilibrium", "full"): "full equilibrium (inertia)",
    ("factor+denominator", "1.6+8"): "all Ca × 1.6, Skalak k = 8",
    ("height", "full"): "full height",
    ("height", "full-tilted"): "full height, tilted start",
    ("instant", "centre on the gap line"): "extent, centre on the gap line",
    ("kernel", "phi3"): "three-point kernel",
    ("kernel", "phi4_corrected"): "corrected kernel",
    ("kernel+flow", "corrected+blocked"): "corrected kernel, no lateral flow",
    ("lateral_flow", "blocked"): "no net lateral flow",
    ("law+kernel", "hinge_sheet+corrected"): "softer folds, corrected kernel",
    ("law+kernel", "hinge_sphere+corrected"): "stiffer folds, corrected kernel",
    ("local_area_modulus", "x2"): "local area modulus × 2",
    ("mesh_frequency", "14"): "finer mesh (frequency 14)",
    ("mesh_frequency", "8"): "coarser mesh (frequency 8)",
    ("paper-method", "bgk+full+half-way"): "the paper's method: BGK, staircase",
    ("pillar_center", "between-nodes"): "pillar between nodes",
    ("regularisation", "x2"): "regularisation × 2",
    ("repulsion_range", "2"): "wider repulsion",
    ("skalak_denominator", "4"): "Skalak's law, k = 4",
    ("skalak_denominator", "8"): "Skalak's law, k = 8",
    ("start", "gap-centre"): "start: middle of the gap",
    ("viscosity_ratio", "1"): "viscosity ratio 1",
    ("viscosity_ratio", "10"): "viscosity ratio 10",
    ("walls", "half-way"): "half-way (staircase) walls",
}


def words(choice, value):
    """A choice and its value in words; those without a wording under their names."""
    return WORDS.get((str(choice), str(value)), f"{choice}: {value}")
