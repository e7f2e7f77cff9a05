"""The verdict on every claim of the paper."""

CLAIM_FILES = [f"{RESULTS}/claims.csv", f"{RESULTS}/claims.md"]


rule claims:
    input:
        claims=CLAIMS,
        tables=FLOW_TABLES + STRETCHING_TABLES + BOUNDARY_TABLES + PASSAGE_TABLES,
        experiment=EXPERIMENT,
        script=f"{SCRIPTS}/claims_table.py",
        package=PACKAGE,
    output:
        csv=CLAIM_FILES[0],
        md=CLAIM_FILES[1],
    log:
        f"{LOGS}/claims.log",
    params:
        tables=TABLES,
        tier=TIER,
        whole="" if TIER == "smoke" else "--whole",
    shell:
        """
        python {input.script} --claims {input.claims} --tables {params.tables} --tier {params.tier} {params.whole} \
            --experiment {input.experiment} --csv {output.csv} --markdown {output.md} 2> {log}
        """
