"""The optical-tweezer test of the membrane against two sets of experiments."""

EXPERIMENT = "params/experiment/tweezer_experiment.csv"
STRETCHING_TABLES = expand(
    "{folder}/{name}.csv", folder=TABLES, name=["stretching", "stretching_comparison"]
)


rule stretching_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "stretching"),
        script=f"{SCRIPTS}/analysis/stretching_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stretching_table.py"),
    output:
        f"{TABLES}/stretching.csv",
    log:
        f"{LOGS}/stretching_table.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule stretching_comparison:
    input:
        table=rules.stretching_table.output,
        experiment=EXPERIMENT,
        script=f"{SCRIPTS}/analysis/stretching_comparison.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stretching_comparison.py"),
    output:
        f"{TABLES}/stretching_comparison.csv",
    log:
        f"{LOGS}/stretching_comparison.log",
    shell:
        "python {input.script} --table {input.table} --experiment {input.experiment} --output {output} 2> {log}"
