"""A study without a print to compare with: figures of its devices, of the flow and of the phase space, and a
page that tells what came out. What a study has no section for is left out.

Every rule named figure_* in rules/study_figures.smk is a figure of the study and of its page.
"""

STUDY_NAME = Path(STUDY).stem
STUDY_PAGE = f"{RESULTS}/README.md"
STUDY_TABLES = []
HAS_FLOW = "streamlines" in PLAN["sections"]
HAS_CELLS = bool({"passages", "boundary"} & set(PLAN["sections"]))
HAS_STRETCHING = "stretching" in PLAN["sections"]
HAS_SENSITIVITY = "sensitivity" in PLAN["sections"]
HAS_WINDOW = {"streamlines", "boundary"} <= set(PLAN["sections"]) and len(PLAN["cells"]) > 1


if HAS_FLOW:

    STUDY_TABLES += [SEPARATION_TABLE, f"{TABLES}/devices.csv"]

    rule study_devices:
        input:
            plan=PLAN_FILE,
            runs=of_runs("run.h5", "streamlines") + of_runs("summary.json", "streamlines"),
            script=f"{SCRIPTS}/analysis/study_devices.py",
            modules=modules_of(f"{SCRIPTS}/analysis/study_devices.py"),
        output:
            devices=f"{TABLES}/devices.csv",
            lines=f"{TABLES}/device_lines.csv",
        log:
            f"{LOGS}/study_devices.log",
        params:
            runs=RUNS,
        shell:
            """
            python {input.script} --plan {input.plan} --runs {params.runs} --devices {output.devices} \
                --lines {output.lines} 2> {log}
            """


if HAS_CELLS:

    STUDY_TABLES += [*PASSAGE_TABLES, *BOUNDARY_TABLES]


if HAS_WINDOW:

    STUDY_TABLES += [f"{TABLES}/window.csv"]

    rule study_window:
        input:
            plan=PLAN_FILE,
            boundary=rules.boundary_tables.output.boundary,
            devices=rules.study_devices.output.devices,
            script=f"{SCRIPTS}/analysis/study_window.py",
            modules=modules_of(f"{SCRIPTS}/analysis/study_window.py"),
        output:
            f"{TABLES}/window.csv",
        log:
            f"{LOGS}/study_window.log",
        shell:
            """
            python {input.script} --plan {input.plan} --boundary {input.boundary} --devices {input.devices} \
                --output {output} 2> {log}
            """


if HAS_STRETCHING:

    STUDY_TABLES += [f"{TABLES}/stretching.csv"]

    rule study_stretching:
        input:
            plan=PLAN_FILE,
            runs=of_runs("run.h5", "stretching") + of_runs("summary.json", "stretching"),
            script=f"{SCRIPTS}/analysis/study_stretching.py",
            modules=modules_of(f"{SCRIPTS}/analysis/study_stretching.py"),
        output:
            f"{TABLES}/stretching.csv",
        log:
            f"{LOGS}/study_stretching.log",
        params:
            runs=RUNS,
        shell:
            "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


if HAS_SENSITIVITY:

    STUDY_TABLES += [f"{TABLES}/sensitivity.csv"]


include: "study_figures.smk"


STUDY_FIGURE_FILES = [
    str(file) for rule in workflow.rules if rule.name.startswith("figure_") for file in rule.output
]
STUDY_FILES = [*STUDY_TABLES, *STUDY_FIGURE_FILES, STUDY_PAGE]


rule study_page:
    input:
        plan=PLAN_FILE,
        tables=STUDY_TABLES,
        figures=STUDY_FIGURE_FILES,
        script=f"{SCRIPTS}/analysis/study_page.py",
        modules=modules_of(f"{SCRIPTS}/analysis/study_page.py"),
    output:
        STUDY_PAGE,
    log:
        f"{LOGS}/study_page.log",
    params:
        tables=TABLES,
        name=STUDY_NAME,
    shell:
        """
        python {input.script} --plan {input.plan} --tables {params.tables} --name {params.name} \
            --output {output} 2> {log}
        """


def redrawn(_):
    """Files that are made anew from the tables: one figure, or all and the page."""
    drawn = {Path(name).stem: name for name in STUDY_FIGURE_FILES if name.endswith(".pdf")}
    only = config.get("only")
    if only and only not in drawn:
        raise ValueError(f"redraw={only}: there is no such figure; {hint(only, drawn)}")
    return drawn[only] if only else [*drawn.values(), STUDY_PAGE]


rule redraw:
    input:
        redrawn,
    shell:
        "echo 'redrawn from the tables: {input}'"
