"""How sure the boundary is: one thing changed at a time, `snakemake --cores 2 uncertainty`, on request.

Its brackets have lattices of half the spacing and take hours; the study does without them.
"""

UNCERTAINTY_TABLE = f"{TABLES}/boundary_uncertainty.csv"
LATTICES_TABLE = f"{TABLES}/boundary_lattices.csv"
LATTICE_CELLS = f"{TABLES}/lattice_cells.csv"
UNCERTAINTY_FIGURE = expand(
    f"{FIGURES}/boundary_{{name}}.{{suffix}}", name=["uncertainty", "lattices"], suffix=["pdf", "png", "csv"]
)


rule uncertainty_table:
    input:
        plan=PLAN_FILE,
        brackets=[f"{BRACKETS}/{name}/level-{bracket['levels']}.json" for name, bracket in PLAN["brackets"].items()],
        script=f"{SCRIPTS}/analysis/boundary_uncertainty.py",
        modules=modules_of(f"{SCRIPTS}/analysis/boundary_uncertainty.py"),
    output:
        UNCERTAINTY_TABLE,
    log:
        f"{LOGS}/boundary_uncertainty.log",
    params:
        brackets=BRACKETS,
    shell:
        "python {input.script} --plan {input.plan} --brackets {params.brackets} --output {output} 2> {log}"


rule figure_uncertainty:
    input:
        plan=PLAN_FILE,
        table=rules.uncertainty_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig_boundary_uncertainty.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_boundary_uncertainty.py"),
    output:
        multiext(f"{FIGURES}/boundary_uncertainty", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_boundary_uncertainty.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --claims {input.claims} --csv {output.csv} \
            --output {output.pdf} 2> {log}
        """


rule lattices_table:
    input:
        boundary=rules.boundary_tables.output.boundary,
        uncertainty=rules.uncertainty_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/analysis/boundary_lattices.py",
        modules=modules_of(f"{SCRIPTS}/analysis/boundary_lattices.py"),
    output:
        LATTICES_TABLE,
    log:
        f"{LOGS}/boundary_lattices.log",
    shell:
        """
        python {input.script} --boundary {input.boundary} --uncertainty {input.uncertainty} --claims {input.claims} \
            --output {output} 2> {log}
        """


rule lattice_cells:
    input:
        plan=PLAN_FILE,
        runs=of_runs("summary.json", "uncertainty-cells"),
        passages=rules.passages_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/analysis/lattice_cells.py",
        modules=modules_of(f"{SCRIPTS}/analysis/lattice_cells.py"),
    output:
        LATTICE_CELLS,
    log:
        f"{LOGS}/lattice_cells.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --passages {input.passages} \
            --claims {input.claims} --output {output} 2> {log}
        """


rule figure_lattices:
    input:
        plan=PLAN_FILE,
        boundary=rules.boundary_tables.output.boundary,
        uncertainty=rules.uncertainty_table.output,
        laws=rules.lattices_table.output,
        cells=rules.lattice_cells.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig_boundary_lattices.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_boundary_lattices.py"),
    output:
        multiext(f"{FIGURES}/boundary_lattices", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_boundary_lattices.log",
    shell:
        """
        python {input.script} --plan {input.plan} --boundary {input.boundary} --uncertainty {input.uncertainty} \
            --laws {input.laws} --cells {input.cells} --claims {input.claims} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule uncertainty:
    input:
        UNCERTAINTY_TABLE,
        LATTICES_TABLE,
        LATTICE_CELLS,
        UNCERTAINTY_FIGURE,
