"""The report: one HTML file without outside parts, for reading the results in a browser; and, on request,
the numbers of README.md."""

import hashlib

REPORT_FILES = [f"{RESULTS}/report.html"]
REPORT_GROUPS = ["streamlines", "stokes", "stretching", "passages", "sensitivity"]  # runs of the study itself


def made_on_request(_):
    """Digest of the tables and figures of other targets, which report and article show if they are there."""
    digest = hashlib.sha256()
    others = [*ACCURACY_FILES, *rules.accuracy_class.input, *STABILITY_TABLES, *STABILITY_FIGURES, *PERFORMANCE_FILES]
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
        script=f"{SCRIPTS}/report_data.py",
        package=PACKAGE,
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
        script=f"{SCRIPTS}/report.py",
        package=PACKAGE,
    output:
        REPORT_FILES,
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


# On request: the text is the project's own, and only its numbers come from the results. What the boundary
# depends on is shown if the target `uncertainty` was made.
rule readme:
    input:
        tables=expand("{folder}/{name}.csv", folder=TABLES, name=["stage_times", "phase_boundary", "second_starts"]),
        verdicts=rules.claims.output.csv,
        claims=CLAIMS,
        script=f"{SCRIPTS}/readme_numbers.py",
        package=PACKAGE,
    log:
        f"{LOGS}/readme.log",
    params:
        tables=TABLES,
    shell:
        """
        python {input.script} --readme README.md --tables {params.tables} --verdicts {input.verdicts} \
            --claims {input.claims} 2> {log}
        """
