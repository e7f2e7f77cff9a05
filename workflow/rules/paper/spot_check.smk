"""Passages drawn at random from the committed results and made again: `snakemake --cores 2 spot_check`, on request.

A reader with minutes instead of hours checks the study with it. Its runs have a folder of their own, so that the
study's own runs do not stand in for them. The table is what was committed, not what this checkout would make: it
is no input, and nothing of the study has to be there.

    --config sample=20 seed=1               how many, and which
    --config most_node_updates=5e9          only shorter ones (5e9: about two minutes)

In the same way `bash workflow/reproduce claim=d-perp-6.8` makes the runs behind a claim again.
"""

import pandas as pd

from study.paper.claim_runs import runs_of_claim
from study.analysis.spot_check import drawn
from study.analysis.spot_check import asked, drawn

SPOT = f"{RESULTS}/spot_check"
COMMITTED_PASSAGES = f"{TABLES}/passages.csv"


def spot_results(_):
    """Files of the passages that are drawn."""
    if not Path(COMMITTED_PASSAGES).exists():
        raise ValueError(f"{COMMITTED_PASSAGES} is not there: nothing to check against")
    limit, count, seed = asked(config)
    runs = drawn(pd.read_csv(COMMITTED_PASSAGES), count, seed, limit)
    return expand(f"{SPOT}/{{run}}.json", run=runs)


def claim_results(_):
    """Files of the runs behind the claim of --config claim=ID."""
    if "claim" not in config:
        raise ValueError("claim: which one? for example claim=d-perp-6.8")
    runs = runs_of_claim(pd.read_csv(CLAIM_FILES[0]), config["claim"])
    return expand(f"{SPOT}/{{run}}.json", run=runs)


def committed_row(wildcards):
    """Text of the row of a passage: if another one is committed, the run is compared anew."""
    table = pd.read_csv(COMMITTED_PASSAGES, dtype=str, keep_default_na=False)
    return "\n".join(",".join(row) for row in table[table.run == wildcards.run].head(1).to_numpy())


rule spot_check:
    input:
        results=spot_results,
        script=f"{SCRIPTS}/analysis/spot_check.py",
    params:
        table=f"{SPOT}/spot_check.csv",  # beside the committed one
    shell:
        "python {input.script} --results {input.results} --output {params.table}"


rule claim:
    input:
        results=claim_results,
        script=f"{SCRIPTS}/analysis/spot_check.py",
    params:
        table=f"{SPOT}/claim.csv",
    shell:
        "python {input.script} --what runs --results {input.results} --output {params.table}"


rule spot_run:
    input:
        dld=DLD,
        plan=ancient(PLAN_FILE),
        runner=ancient(f"{SCRIPTS}/run_case"),
        script=f"{SCRIPTS}/planning/spot_run.py",
        code=["workflow/study/analysis/spot_check.py", "workflow/study/paper/claim_runs.py", "workflow/study/analysis/passages.py"],
    output:
        f"{SPOT}/{{run}}.json",
    log:
        f"{LOGS}/spot_check/{{run}}.log",
    params:
        runs=f"{SPOT}/runs",
        tables=TABLES,
        own=RUNS,
        row=committed_row,
    threads: 1
    shell:
        """
        python {input.script} --plan {input.plan} --tables {params.tables} --run {wildcards.run} --runs {params.runs} \
            --own {params.own} --dld {input.dld} --runner {input.runner} --output {output} 2> {log}
        """
