"""A study without a print to compare with: figures of its devices, of the flow and of the phase space, and a
page that tells what came out. What a study has no section for is left out."""

STUDY_NAME = Path(STUDY).stem
STUDY_PAGE = f"{RESULTS}/README.md"
STUDY_TABLES, STUDY_FIGURES = [], []
if "streamlines" in PLAN["sections"]:
    STUDY_TABLES += [SEPARATION_TABLE, f"{TABLES}/devices.csv"]
    STUDY_FIGURES += ["fig_devices", "fig_separation"]
if "passages" in PLAN["sections"] or "boundary" in PLAN["sections"]:
    STUDY_TABLES += [*PASSAGE_TABLES, *BOUNDARY_TABLES]
    STUDY_FIGURES += ["fig_phase_space"]
if {"streamlines", "boundary"} <= set(PLAN["sections"]) and len(PLAN["cells"]) > 1:
    STUDY_TABLES += [f"{TABLES}/window.csv"]
    STUDY_FIGURES += ["fig_window"]
STUDY_FIGURE_FILES = expand("{folder}/{name}.{ext}", folder=FIGURES, name=STUDY_FIGURES, ext=["pdf", "png"])
STUDY_FILES = [*STUDY_TABLES, *STUDY_FIGURE_FILES, STUDY_PAGE]


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


rule figure_devices:
    input:
        plan=PLAN_FILE,
        devices=rules.study_devices.output.devices,
        lines=rules.study_devices.output.lines,
        script=f"{SCRIPTS}/drawing/fig_devices.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_devices.py"),
    output:
        multiext(f"{FIGURES}/fig_devices", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig_devices.log",
    shell:
        """
        python {input.script} --plan {input.plan} --devices {input.devices} --lines {input.lines} \
            --output {output.pdf} 2> {log}
        """


rule figure_study_separation:
    input:
        plan=PLAN_FILE,
        table=SEPARATION_TABLE,
        script=f"{SCRIPTS}/drawing/fig_separation.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_separation.py"),
    output:
        multiext(f"{FIGURES}/fig_separation", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig_separation.log",
    shell:
        "python {input.script} --plan {input.plan} --table {input.table} --output {output.pdf} 2> {log}"


rule figure_study_phase_space:
    input:
        plan=PLAN_FILE,
        passages=rules.passages_table.output,
        boundary=rules.boundary_tables.output.boundary,
        script=f"{SCRIPTS}/drawing/fig_study_phase_space.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_study_phase_space.py"),
    output:
        multiext(f"{FIGURES}/fig_phase_space", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig_phase_space.log",
    shell:
        """
        python {input.script} --plan {input.plan} --passages {input.passages} --boundary {input.boundary} \
            --output {output.pdf} 2> {log}
        """


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


rule figure_window:
    input:
        plan=PLAN_FILE,
        window=rules.study_window.output,
        script=f"{SCRIPTS}/drawing/fig_window.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_window.py"),
    output:
        multiext(f"{FIGURES}/fig_window", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig_window.log",
    shell:
        "python {input.script} --plan {input.plan} --window {input.window} --output {output.pdf} 2> {log}"


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
