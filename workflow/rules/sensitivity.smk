"""What choices of the model change: at some points of the phase space, in the boundary and in s."""


rule sensitivity_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "sensitivity", "sensitivity-flow") + of_runs("run.h5", "sensitivity"),
        boundary=rules.boundary_tables.output.boundary,
        script=f"{SCRIPTS}/analysis/sensitivity_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/sensitivity_table.py"),
    output:
        f"{TABLES}/sensitivity.csv",
    log:
        f"{LOGS}/sensitivity_table.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --boundary {input.boundary} \
            --output {output} 2> {log}
        """
