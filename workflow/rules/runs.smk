"""Solver runs, one folder each, named by the hash of the resolved case.

The solver and the plan are `ancient`: a run depends on its case alone, which its name identifies. A change
of the solver that changes results raises `solver_model` in params/study.json, and with it every identity.
"""


rule plan:
    input:
        study=STUDY,
        schemas=expand("workflow/schemas/{name}.schema.json", name=["study", "case"]),
        script=f"{SCRIPTS}/write_plan.py",
        package=PACKAGE,
    output:
        f"{RESULTS}/plan.json",
    log:
        f"{LOGS}/plan.log",
    params:
        tier=TIER,
    shell:
        "python {input.script} --study {input.study} --tier {params.tier} --output {output} 2> {log}"


rule solve:
    input:
        dld=ancient(DLD),
        plan=ancient(rules.plan.output[0]),
        writer=ancient(f"{SCRIPTS}/write_case.py"),
        runner=ancient(f"{SCRIPTS}/run_case"),
    output:
        case=f"{RUNS}/{{run}}/case.json",
        h5=f"{RUNS}/{{run}}/run.h5",
        summary=f"{RUNS}/{{run}}/summary.json",
    log:
        f"{RUNS}/{{run}}/run.log",
    benchmark:
        f"{RUNS}/{{run}}/benchmark.tsv"
    threads: 1
    shell:
        """
        python {input.writer} --plan {input.plan} --run {wildcards.run} > {output.case}
        {input.runner} {input.dld} {output.case} {output.h5} {output.summary} {threads} {log}
        """


def of_runs(name, *groups):
    """The file `name` of every run of the given groups of the plan."""
    return expand(f"{RUNS}/{{run}}/{name}", run=ids(PLAN, *groups))


ALL_RUNS = expand(f"{RUNS}/{{run}}/summary.json", run=ids(PLAN, *STUDY_GROUPS))
