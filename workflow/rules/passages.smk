"""Cells passing through the array: class of the trajectory and lateral extent."""

PASSAGE_TABLES = [f"{TABLES}/passages.csv"]


rule passages_table:
    input:
        plan=rules.plan.output,
        runs=of_runs("summary.json", "passages") + of_runs("run.h5", "passages"),
        script=f"{SCRIPTS}/passages_table.py",
        package=PACKAGE,
    output:
        f"{TABLES}/passages.csv",
    log:
        f"{LOGS}/passages_table.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"
