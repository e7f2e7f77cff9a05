"""The flow without cells against the print: power laws, Stokes checks, units."""

FLOW_TABLES = [SEPARATION_TABLE] + expand(
    "{folder}/{name}.csv", folder=TABLES, name=["fits_separation", "stokes_checks", "units"]
)


rule separation_law_fits:
    input:
        table=rules.streamline_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/analysis/separation_law_fits.py",
        modules=modules_of(f"{SCRIPTS}/analysis/separation_law_fits.py"),
    output:
        f"{TABLES}/fits_separation.csv",
    log:
        f"{LOGS}/separation_law_fits.log",
    shell:
        "python {input.script} --table {input.table} --claims {input.claims} --output {output} 2> {log}"


rule stokes_checks:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "stokes") + of_runs("run.h5", "stokes"),
        script=f"{SCRIPTS}/analysis/stokes_checks.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stokes_checks.py"),
    output:
        f"{TABLES}/stokes_checks.csv",
    log:
        f"{LOGS}/stokes_checks.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule units_table:
    input:
        table=rules.streamline_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/analysis/units_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/units_table.py"),
    output:
        f"{TABLES}/units.csv",
    log:
        f"{LOGS}/units_table.log",
    shell:
        "python {input.script} --table {input.table} --claims {input.claims} --output {output} 2> {log}"
