"""Cells passing through the array: class of the trajectory, lateral extent, every crossing of a pillar line."""

PASSAGE_TABLES = expand(
    "{folder}/{name}.csv",
    folder=TABLES,
    name=["passages", "crossings", "return_maps"],
)


rule passages_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "passages") + of_runs("run.h5", "passages"),
        brackets=BRACKET_FILES,
        script=f"{SCRIPTS}/analysis/passages_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/passages_table.py"),
    output:
        f"{TABLES}/passages.csv",
    log:
        f"{LOGS}/passages_table.log",
    params:
        runs=RUNS,
        brackets=BRACKETS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --brackets {params.brackets} \
            --output {output} 2> {log}
        """


rule crossings_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "passages"),
        brackets=BRACKET_FILES,
        script=f"{SCRIPTS}/analysis/crossings_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/crossings_table.py"),
    output:
        crossings=f"{TABLES}/crossings.csv",
        maps=f"{TABLES}/return_maps.csv",
    log:
        f"{LOGS}/crossings_table.log",
    params:
        runs=RUNS,
        brackets=BRACKETS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --brackets {params.brackets} \
            --output {output.crossings} --maps {output.maps} 2> {log}
        """
