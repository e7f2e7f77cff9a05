"""The report: one HTML file without outside parts, for reading the results in a browser; the page of the
results; and, on request, the line of verdicts in README.md."""

import hashlib

RESULTS_PAGE = "docs/results.md" if TIER == "paper" else f"{RESULTS}/results.md"
REPORT_FILES = [f"{RESULTS}/report.html", RESULTS_PAGE]
REPORT_GROUPS = ["streamlines", "stokes", "stretching", "passages", "sensitivity"]  # runs of the study itself


def made_on_request(_):
    """Digest of the tables and figures of other targets, which report and article show if they are there."""
    digest = hashlib.sha256()
    others = [*ACCURACY_FILES, *rules.accuracy_class.input, *rules.speed_accuracy.input, *STABILITY_TABLES, *STABILITY_FIGURES, *PERFORMANCE_FILES]
    others += [UNCERTAINTY_TABLE, *UNCERTAINTY_FIGURE]
    for path in map(Path, others):
        if path.exists():
            digest.update(path.read_bytes())
    return digest.hexdigest()


rule report_data:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", *REPORT_GROUPS),
        brackets=BRACKET_FILES,
        script=f"{SCRIPTS}/paper/report_data.py",
        modules=modules_of(f"{SCRIPTS}/paper/report_data.py"),
    output:
        trajectories=f"{TABLES}/thumbnails.csv",
        provenance=f"{TABLES}/provenance.csv",
    log:
        f"{LOGS}/report_data.log",
    params:
        runs=RUNS,
        groups=REPORT_GROUPS,
        brackets=BRACKETS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --groups {params.groups} \
            --brackets {params.brackets} --trajectories {output.trajectories} --provenance {output.provenance} 2> {log}
        """


rule report:
    input:
        plan=PLAN_FILE,
        tables=FLOW_TABLES + STRETCHING_TABLES + BOUNDARY_TABLES + PASSAGE_TABLES + SENSITIVITY_TABLES,
        figures=[name for name in FIGURE_FILES + EXTENT_FIGURES + ANIMATION_FILES if name.endswith((".png", ".gif"))],
        verdicts=rules.claims.output.csv,
        claims=CLAIMS,
        trajectories=rules.report_data.output.trajectories,
        provenance=rules.report_data.output.provenance,
        captions="workflow/templates/figures.toml",
        template="workflow/templates/report.html.j2",
        parts=expand("workflow/templates/report.{ext}", ext=["css", "js"]),
        script=f"{SCRIPTS}/paper/report.py",
        modules=modules_of(f"{SCRIPTS}/paper/report.py"),
    output:
        REPORT_FILES[0],
    log:
        f"{LOGS}/report.log",
    params:
        tables=TABLES,
        figures=FIGURES,
        others=made_on_request,
    shell:
        """
        python {input.script} --plan {input.plan} --tables {params.tables} --figures {params.figures} \
            --verdicts {input.verdicts} --claims {input.claims} --trajectories {input.trajectories} \
            --provenance {input.provenance} --captions {input.captions} --template {input.template} \
            --output {output} 2> {log}
        """


rule results_page:
    input:
        plan=PLAN_FILE,
        tables=FLOW_TABLES + STRETCHING_TABLES + BOUNDARY_TABLES + PASSAGE_TABLES,
        verdicts=rules.claims.output.csv,
        claims=CLAIMS,
        numbers="paper/numbers.toml",
        template="workflow/templates/results.md.j2",
        script=f"{SCRIPTS}/paper/results_page.py",
        modules=modules_of(f"{SCRIPTS}/paper/results_page.py"),
    output:
        RESULTS_PAGE,
    log:
        f"{LOGS}/results_page.log",
    params:
        results=RESULTS,
        root=".",
        others=made_on_request,
    shell:
        """
        python {input.script} --plan {input.plan} --results {params.results} --verdicts {input.verdicts} \
            --claims {input.claims} --numbers {input.numbers} --template {input.template} --root {params.root} \
            --output {output} 2> {log}
        """


# On request: the text is the project's own, and only the line of verdicts comes from the results.
rule readme:
    input:
        verdicts=rules.claims.output.csv,
        script=f"{SCRIPTS}/paper/readme_verdicts.py",
        modules=modules_of(f"{SCRIPTS}/paper/readme_verdicts.py"),
    log:
        f"{LOGS}/readme.log",
    shell:
        "python {input.script} --readme README.md --verdicts {input.verdicts} 2> {log}"
