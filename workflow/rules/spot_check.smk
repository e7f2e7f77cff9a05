"""Passages drawn at random from the committed results and made again: `snakemake --cores 2 spot_check`, on request.

A reader with minutes instead of hours checks the study with it. Its runs have a folder of their own, so that the
study's own runs do not stand in for them. The table is what was committed, not what this checkout would make: it
is no input, and nothing of the study has to be there.

    --config sample=20 seed=1               how many, and which
    --config most_node_updates=5e9          only shorter ones (5e9: about two minutes)
"""

import pandas as pd

from study.spot_check import asked, drawn

SPOT = f"{RESULTS}/spot_check"
COMMITTED_PASSAGES = f"{TABLES}/passages.csv"


def spot_results(_):
    """Files of the passages that are drawn."""
    if not Path(COMMITTED_PASSAGES).exists():
        raise ValueError(f"{COMMITTED_PASSAGES} is not there: nothing to check against")
    limit, count, seed = asked(config)
    runs = drawn(pd.read_csv(COMMITTED_PASSAGES), count, seed, limit)
    return expand(f"{SPOT}/{{run}}.json", run=runs)


def committed_row(wildcards):
    """Text of the row of a run: if another one is committed, the run is compared anew."""
    table = pd.read_csv(COMMITTED_PASSAGES, dtype=str, keep_default_na=False)
    return ",".join(table[table.run == wildcards.run].iloc[0])


rule spot_check:
    input:
        results=spot_results,
        script=f"{SCRIPTS}/spot_check.py",
    params:
        table=f"{TABLES}/spot_check.csv",
    shell:
        "python {input.script} --results {input.results} --output {params.table}"


rule spot_run:
    input:
        dld=DLD,
        plan=ancient(PLAN_FILE),
        runner=ancient(f"{SCRIPTS}/run_case"),
        script=f"{SCRIPTS}/spot_run.py",
        code=["workflow/study/spot_check.py", "workflow/study/passages.py"],
    output:
        f"{SPOT}/{{run}}.json",
    log:
        f"{LOGS}/spot_check/{{run}}.log",
    params:
        runs=f"{SPOT}/runs",
        table=COMMITTED_PASSAGES,
        row=committed_row,
    threads: 1
    shell:
        """
        python {input.script} --plan {input.plan} --table {params.table} --run {wildcards.run} --runs {params.runs} \
            --dld {input.dld} --runner {input.runner} --output {output} 2> {log}
        """
