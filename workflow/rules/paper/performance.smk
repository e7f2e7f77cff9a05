"""How fast the solver is on this machine: made on request, `snakemake --cores 1 performance`, with the machine quiet."""

PERFORMANCE_FILES = [
    f"{TABLES}/performance.csv",
    *multiext(f"{FIGURES}/performance", ".pdf", ".png", ".csv"),
]


rule performance:
    input:
        PERFORMANCE_FILES,


rule performance_table:
    input:
        sources=solver_sources(),
        bench="tests/bench/performance.cpp",
        cmake="CMakeLists.txt",
    output:
        f"{TABLES}/performance.csv",
    log:
        f"{LOGS}/performance.log",
    threads: 2
    shell:
        """
        workflow/scripts/configure > {log} 2>&1
        cmake --build build --target performance >> {log} 2>&1
        build/performance > {output} 2>> {log}
        """


rule performance_figure:
    input:
        plan=PLAN_FILE,
        table=rules.performance_table.output,
        script=f"{SCRIPTS}/drawing/performance_figure.py",
        modules=modules_of(f"{SCRIPTS}/drawing/performance_figure.py"),
    output:
        multiext(f"{FIGURES}/performance", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/performance_figure.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --csv {output.csv} \
            --output {output.pdf} 2> {log}
        """
