"""All figures, the claims' page, the report and the article anew from the tables that are there, without a run and
without the solver: `bash workflow/reproduce redraw`, or `redraw=fig07` for one figure.

Rules that read tables alone may run (study/planning/redraw.py finds them). What is made from the runs themselves
stays as it is.
"""

ON_REQUEST_FIGURES = [*WORK_PRECISION_FILES, *rules.accuracy_class.input, *STABILITY_FIGURES, *PERFORMANCE_FILES[1:]]
ON_REQUEST_FIGURES += UNCERTAINTY_FIGURE
DRAWN = [
    name
    for name in [*FIGURE_FILES, *EXTENT_FIGURES, *ANIMATION_FILES, *ON_REQUEST_FIGURES]
    if name.endswith((".pdf", ".gif"))
]


def redrawn(_):
    """Files that are made anew: one figure, or everything; of the other targets what was made before."""
    if only := config.get("only"):
        known = {Path(name).stem: name for name in DRAWN}
        if only not in known:
            raise ValueError(f"redraw={only}: there is no such figure; {hint(only, known)}")
        return known[only]
    figures = [name for name in DRAWN if name not in ON_REQUEST_FIGURES or Path(name).exists()]
    return [*figures, *CLAIM_FILES, *REPORT_FILES, *PAPER_FILES]


rule redraw:
    input:
        redrawn,
    shell:
        "echo 'redrawn from the tables: {input}; fig_convergence and all data of figures need the runs and stay'"
