"""Where the methods fail: two-parameter maps and the drift over a long run."""

STABILITY_TABLES = expand(f"{TABLES}/{{name}}.csv", name=["stability", "long_run"])
STABILITY_FIGURES = expand(f"{FIGURES}/{{name}}.{{suffix}}", name=["stability", "stability_all", "long_run"], suffix=["pdf", "png", "csv"])


rule stability:
    input:
        STABILITY_TABLES,
        STABILITY_FIGURES,


rule stability_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "stability"),
        script=f"{SCRIPTS}/analysis/stability_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stability_table.py"),
    output:
        f"{TABLES}/stability.csv",
    log:
        f"{LOGS}/stability_table.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule stability_figure:
    input:
        plan=PLAN_FILE,
        table=f"{TABLES}/stability.csv",
        script=f"{SCRIPTS}/drawing/stability_figure.py",
        modules=modules_of(f"{SCRIPTS}/drawing/stability_figure.py"),
    output:
        csv=f"{FIGURES}/stability.csv",
        pdf=f"{FIGURES}/stability.pdf",
        png=f"{FIGURES}/stability.png",
    log:
        f"{LOGS}/stability_figure.log",
    params:
        maps="user",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --maps {params.maps} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule stability_figure_all:
    input:
        plan=PLAN_FILE,
        table=f"{TABLES}/stability.csv",
        script=f"{SCRIPTS}/drawing/stability_figure.py",
        modules=modules_of(f"{SCRIPTS}/drawing/stability_figure.py"),
    output:
        csv=f"{FIGURES}/stability_all.csv",
        pdf=f"{FIGURES}/stability_all.pdf",
        png=f"{FIGURES}/stability_all.png",
    log:
        f"{LOGS}/stability_figure_all.log",
    params:
        maps="all",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --maps {params.maps} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule long_run_table:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "long-run") + of_runs("run.h5", "long-run"),
        script=f"{SCRIPTS}/analysis/stability_long_run_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/stability_long_run_table.py"),
    output:
        f"{TABLES}/long_run.csv",
    log:
        f"{LOGS}/long_run_table.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule long_run_figure:
    input:
        plan=PLAN_FILE,
        table=f"{TABLES}/long_run.csv",
        script=f"{SCRIPTS}/drawing/stability_long_run_figure.py",
        modules=modules_of(f"{SCRIPTS}/drawing/stability_long_run_figure.py"),
    output:
        csv=f"{FIGURES}/long_run.csv",
        pdf=f"{FIGURES}/long_run.pdf",
        png=f"{FIGURES}/long_run.png",
    log:
        f"{LOGS}/long_run_figure.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """
