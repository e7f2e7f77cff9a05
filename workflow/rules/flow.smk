"""The flow without cells: separation distances and flow resistance of every device."""

SEPARATION_TABLE = f"{TABLES}/streamline_separation.csv"


rule streamline_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "streamlines"),
        script=f"{SCRIPTS}/analysis/streamline_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/streamline_table.py"),
    output:
        SEPARATION_TABLE,
    log:
        f"{LOGS}/streamline_table.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"
