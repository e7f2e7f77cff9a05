"""Accuracy against cost: error of every method and setting, and what it takes. Made by the target `accuracy`."""

ACCURACY_STUDIES = ["flow", "tweezer", "passages"]
ACCURACY_GROUPS = [f"accuracy-{study}" for study in ACCURACY_STUDIES]
WORK_PRECISION_FILES = expand(
    "{folder}/work_precision_{study}.{ext}", folder=FIGURES, study=ACCURACY_STUDIES, ext=["pdf", "png", "csv"]
)
ACCURACY_FILES = [
    f"{TABLES}/accuracy_cost.csv",
    f"{TABLES}/settings_check.csv",
    f"{RESULTS}/accuracy_conclusions.md",
    *WORK_PRECISION_FILES,
    *expand("{folder}/fig_convergence.{ext}", folder=FIGURES, ext=["pdf", "png", "csv"]),
]


rule accuracy:
    input:
        ACCURACY_FILES,


rule accuracy_cheap_models:
    input:
        plan=PLAN_FILE,
        script=f"{SCRIPTS}/analysis/accuracy_cheap_models.py",
        modules=modules_of(f"{SCRIPTS}/analysis/accuracy_cheap_models.py"),
    output:
        f"{TABLES}/accuracy_cheap_models.csv",
    log:
        f"{LOGS}/accuracy_cheap_models.log",
    # One thread of the linear algebra, as the lattice Boltzmann runs have; its seconds are compared with theirs.
    shell:
        "OPENBLAS_NUM_THREADS=1 python {input.script} --plan {input.plan} --output {output} 2> {log}"


rule accuracy_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", *ACCURACY_GROUPS),
        cheap=rules.accuracy_cheap_models.output,
        script=f"{SCRIPTS}/analysis/accuracy_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/accuracy_table.py"),
    output:
        f"{TABLES}/accuracy_cost.csv",
    log:
        f"{LOGS}/accuracy_table.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --cheap {input.cheap} \
            --output {output} 2> {log}
        """


rule settings_check:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "settings-check"),
        script=f"{SCRIPTS}/analysis/settings_check.py",
        modules=modules_of(f"{SCRIPTS}/analysis/settings_check.py"),
    output:
        f"{TABLES}/settings_check.csv",
    log:
        f"{LOGS}/settings_check.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule accuracy_conclusions:
    input:
        plan=PLAN_FILE,
        table=rules.accuracy_table.output,
        check=rules.settings_check.output,
        script=f"{SCRIPTS}/analysis/accuracy_conclusions.py",
        modules=modules_of(f"{SCRIPTS}/analysis/accuracy_conclusions.py"),
    output:
        f"{RESULTS}/accuracy_conclusions.md",
    log:
        f"{LOGS}/accuracy_conclusions.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --check {input.check} \
            --runs {params.runs} --output {output} 2> {log}
        """


rule work_precision:
    input:
        plan=PLAN_FILE,
        table=rules.accuracy_table.output,
        script=f"{SCRIPTS}/drawing/work_precision.py",
        modules=modules_of(f"{SCRIPTS}/drawing/work_precision.py"),
    output:
        multiext(f"{FIGURES}/work_precision_{{study}}", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/work_precision_{{study}}.log",
    wildcard_constraints:
        study="|".join(ACCURACY_STUDIES),
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --study {wildcards.study} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_convergence:
    input:
        plan=PLAN_FILE,
        table=rules.accuracy_table.output,
        script=f"{SCRIPTS}/drawing/fig_convergence.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_convergence.py"),
    output:
        multiext(f"{FIGURES}/fig_convergence", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_convergence.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --runs {params.runs} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule accuracy_class_table:
    input:
        plan=PLAN_FILE,
        passages=rules.passages_table.output,
        crossings=rules.crossings_table.output.crossings,
        summary=rules.a_priori.output.summary,
        script=f"{SCRIPTS}/drawing/accuracy_class.py",
        modules=modules_of(f"{SCRIPTS}/drawing/accuracy_class.py"),
    output:
        f"{TABLES}/accuracy_class.csv",
    log:
        f"{LOGS}/accuracy_class.log",
    shell:
        """
        python {input.script} --plan {input.plan} --passages {input.passages} --crossings {input.crossings} \
            --summary {input.summary} --output {output} 2> {log}
        """


rule work_precision_class:
    input:
        plan=PLAN_FILE,
        table=rules.accuracy_class_table.output,
        script=f"{SCRIPTS}/drawing/work_precision.py",
        modules=modules_of(f"{SCRIPTS}/drawing/work_precision.py"),
    output:
        multiext(f"{FIGURES}/work_precision_class", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/work_precision_class.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --study class \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_speed_accuracy:
    input:
        plan=PLAN_FILE,
        accuracy=rules.accuracy_table.output,
        boundary=rules.boundary_tables.output.boundary,
        uncertainty=rules.uncertainty_table.output,
        a_priori=rules.a_priori.output.table,
        times=rules.stage_times.output,
        cheap=rules.accuracy_cheap_models.output,
        script=f"{SCRIPTS}/drawing/fig_speed_accuracy.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_speed_accuracy.py"),
    output:
        multiext(f"{FIGURES}/speed_accuracy", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/speed_accuracy.log",
    shell:
        """
        python {input.script} --plan {input.plan} --accuracy {input.accuracy} --boundary {input.boundary} \
            --uncertainty {input.uncertainty} --a-priori {input.a_priori} --times {input.times} \
            --cheap {input.cheap} --csv {output.csv} --output {output.pdf} 2> {log}
        """


# Targets of their own: the one needs the passages of the whole study, the other its brackets and those of the
# target `uncertainty`.
rule accuracy_class:
    input:
        rules.work_precision_class.output,


rule speed_accuracy:
    input:
        rules.figure_speed_accuracy.output,
