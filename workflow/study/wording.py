"""The choices of the sensitivity study in words, for labels."""

WORDS = {
    ("bending_law", "hinge_sheet"): "bending law: hinge_sheet (c = 1/√3)",
    ("bending_law", "hinge_sphere"): "bending law: hinge_sphere (c = √3)",
    ("bending_law", "mean_curvature"): "bending law: mean_curvature",
    ("capillary_factor", "1.6"): "all Ca 1.6 times the printed ones",
    ("collision", "bgk"): "collision: BGK",
    ("crossing", "last"): "extent of the last crossing",
    ("crossing", "mean"): "mean extent of the crossings",
    ("crossing", "narrowest"): "extent of the narrowest crossing",
    ("crossing", "widest"): "extent of the widest crossing",
    ("equilibrium", "full"): "full equilibrium (inertia)",
    ("factor+denominator", "1.6+8"): "all Ca × 1.6, Skalak k = 8",
    ("height", "full"): "full height",
    ("height", "full-tilted"): "full height, tilted start",
    ("instant", "centre on the gap line"): "extent, centre on the gap line",
    ("kernel", "phi3"): "kernel: three points",
    ("kernel", "phi4_corrected"): "kernel: corrected",
    ("kernel+flow", "corrected+blocked"): "corrected kernel, no lateral flow",
    ("lateral_flow", "blocked"): "no net lateral flow",
    ("law+kernel", "hinge_sheet+corrected"): "hinge_sheet, corrected kernel",
    ("law+kernel", "hinge_sphere+corrected"): "hinge_sphere, corrected kernel",
    ("local_area_modulus", "x2"): "local area modulus × 2",
    ("mesh_frequency", "14"): "finer mesh (frequency 14)",
    ("mesh_frequency", "8"): "coarser mesh (frequency 8)",
    ("paper-method", "bgk+full+half-way"): "BGK, inertia and staircase walls",
    ("pillar_center", "between-nodes"): "pillar centred between nodes",
    ("regularisation", "x2"): "regularisation × 2",
    ("repulsion_range", "2"): "repulsion over two lattice spacings",
    ("skalak_denominator", "4"): "Skalak denominator k = 4",
    ("skalak_denominator", "8"): "Skalak denominator k = 8",
    ("start", "gap-centre"): "start in the middle of the gap",
    ("viscosity_ratio", "1"): "viscosity ratio 1",
    ("viscosity_ratio", "10"): "viscosity ratio 10",
    ("walls", "half-way"): "half-way (staircase) walls",
}


def words(choice, value):
    """A choice and its value in words; those without a wording under their names."""
    return WORDS.get((str(choice), str(value)), f"{choice}: {value}")
