"""The verdict on every claim of the paper."""

CLAIM_FILES = [f"{RESULTS}/claims.csv", f"{RESULTS}/claims.md"]


rule claims:
    input:
        plan=PLAN_FILE,
        claims=CLAIMS,
        tables=FLOW_TABLES + STRETCHING_TABLES + BOUNDARY_TABLES + PASSAGE_TABLES,
        experiment=EXPERIMENT,
        script=f"{SCRIPTS}/paper/claims_table.py",
        modules=modules_of(f"{SCRIPTS}/paper/claims_table.py"),
    output:
        csv=CLAIM_FILES[0],
        md=CLAIM_FILES[1],
    log:
        f"{LOGS}/claims.log",
    params:
        tables=TABLES,
    shell:
        """
        python {input.script} --claims {input.claims} --tables {params.tables} --plan {input.plan} \
            --experiment {input.experiment} --csv {output.csv} --markdown {output.md} 2> {log}
        """
