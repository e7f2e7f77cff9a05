"""Cells passing through the array: class of the trajectory, lateral extent, every crossing of a pillar line."""

PASSAGE_TABLES = expand(
    "{folder}/{name}.csv",
    folder=TABLES,
    name=["passages", "crossings", "return_maps", "second_starts", "a_priori", "a_priori_summary"],
)


rule passages_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "passages") + of_runs("run.h5", "passages"),
        brackets=BRACKET_FILES,
        script=f"{SCRIPTS}/passages_table.py",
        package=PACKAGE,
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
        script=f"{SCRIPTS}/crossings_table.py",
        package=PACKAGE,
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


rule second_starts:
    input:
        passages=rules.passages_table.output,
        confirmation=rules.boundary_tables.output.confirmation,
        script=f"{SCRIPTS}/second_starts_table.py",
        package=PACKAGE,
    output:
        f"{TABLES}/second_starts.csv",
    log:
        f"{LOGS}/second_starts.log",
    shell:
        """
        python {input.script} --passages {input.passages} --confirmation {input.confirmation} \
            --output {output} 2> {log}
        """


rule a_priori:
    input:
        passages=rules.passages_table.output,
        separation=rules.streamline_table.output,
        stretching=rules.stretching_table.output,
        claims=CLAIMS,
        runs=of_runs("summary.json", "streamlines"),
        script=f"{SCRIPTS}/a_priori_table.py",
        package=PACKAGE,
    output:
        table=f"{TABLES}/a_priori.csv",
        summary=f"{TABLES}/a_priori_summary.csv",
    log:
        f"{LOGS}/a_priori.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --passages {input.passages} --separation {input.separation} \
            --stretching {input.stretching} --claims {input.claims} --runs {params.runs} \
            --output {output.table} --summary {output.summary} 2> {log}
        """
