"""Solver runs, one folder each, named by the hash of the resolved case.

The solver and the plan are `ancient`: a run depends on its case alone, which its name identifies. A change of
the solver that changes results raises `solver_model` in solver/parameters/schema.cpp, and with it every identity. The
plan is written when the Snakefile is read, if it has changed, and by no rule: Snakemake (9.27) looks no further
than a job that it has to do, and would find a changed bracket behind the plan in its next run only.
"""


from study.planning.schedule import run_priorities

RUN_PRIORITIES = run_priorities(PLAN, SECONDS)


def run_priority(wildcards):
    """Priority of a run: the work that waits for it."""
    planned_case(wildcards)
    return RUN_PRIORITIES[wildcards.run]


rule solve:
    input:
        dld=ancient(DLD),
        plan=ancient(PLAN_FILE),
        writer=ancient(f"{SCRIPTS}/planning/write_case.py"),
        runner=ancient(f"{SCRIPTS}/run_case"),
    output:
        case=f"{RUNS}/{{run}}/case.json",
        h5=f"{RUNS}/{{run}}/run.h5",
        summary=f"{RUNS}/{{run}}/summary.json",
    log:
        f"{RUNS}/{{run}}/run.log",
    benchmark:
        f"{RUNS}/{{run}}/benchmark.tsv"
    priority: run_priority
    group: job_group
    threads: 1
    resources:
        runtime=job_minutes,
        mem_mb=job_memory,
        in_series=1,
    shell:
        """
        python {input.writer} --plan {input.plan} --run {wildcards.run} > {output.case}
        {input.runner} {input.dld} {output.case} {output.h5} {output.summary} {threads} {log}
        """


def of_runs(name, *groups):
    """The file `name` of every run of the given groups of the plan."""
    return expand(f"{RUNS}/{{run}}/{name}", run=ids(PLAN, *groups))


ALL_RUNS = expand(f"{RUNS}/{{run}}/summary.json", run=ids(PLAN, *STUDY_GROUPS))
