"""What decides the boundary: the choices on which the paper is silent, one at a time and in pairs; and the
measured times."""

SENSITIVITY_TABLES = expand("{folder}/{name}.csv", folder=TABLES, name=["sensitivity", "stage_times"])


rule stage_times:
    input:
        plan=PLAN_FILE,
        runs=ALL_RUNS,
        brackets=BRACKET_FILES + CONFIRMATION_FILES,
        script=f"{SCRIPTS}/analysis/stage_times.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stage_times.py"),
    output:
        f"{TABLES}/stage_times.csv",
    log:
        f"{LOGS}/stage_times.log",
    params:
        runs=RUNS,
        brackets=BRACKETS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --brackets {params.brackets} \
            --output {output} 2> {log}
        """
