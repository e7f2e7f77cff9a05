"""Passages against the print: the fitted law of the boundary, second starts, rules that need no passage."""

BOUNDARY_TABLES += [f"{TABLES}/fits.csv"]
PASSAGE_TABLES += expand(
    "{folder}/{name}.csv", folder=TABLES, name=["second_starts", "a_priori", "a_priori_summary"]
)


rule boundary_fits:
    input:
        table=rules.boundary_tables.output.boundary,
        separation=rules.separation_law_fits.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/analysis/boundary_fits.py",
        modules=modules_of(f"{SCRIPTS}/analysis/boundary_fits.py"),
    output:
        f"{TABLES}/fits.csv",
    log:
        f"{LOGS}/boundary_fits.log",
    shell:
        """
        python {input.script} --table {input.table} --separation {input.separation} --claims {input.claims} \
            --output {output} 2> {log}
        """



rule second_starts:
    input:
        passages=rules.passages_table.output,
        confirmation=rules.boundary_tables.output.confirmation,
        script=f"{SCRIPTS}/analysis/second_starts_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/second_starts_table.py"),
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
        script=f"{SCRIPTS}/analysis/a_priori_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/a_priori_table.py"),
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
