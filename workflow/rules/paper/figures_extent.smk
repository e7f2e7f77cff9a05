"""The figures of the lateral extent of a cell and of what decides its class: CSV in, PDF, PNG and CSV out."""

EXTENT_FIGURES = expand(
    "{folder}/{name}.{ext}",
    folder=FIGURES,
    name=["fig09", "fig10", "fig_return_maps", "fig_film", "fig_speed"]
    + ["fig_a_priori", "fig_sensitivity"],
    ext=["pdf", "png", "csv"],
) + [f"{FIGURES}/fig09_factors.csv"]


rule figure_extent_row_shift:
    input:
        plan=PLAN_FILE,
        table=rules.passages_table.output,
        fits=rules.boundary_fits.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig09_extent_row_shift.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig09_extent_row_shift.py"),
    output:
        multiext(f"{FIGURES}/fig09", pdf=".pdf", png=".png", csv=".csv"),
        factors=f"{FIGURES}/fig09_factors.csv",
    log:
        f"{LOGS}/fig09.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --fits {input.fits} \
            --claims {input.claims} --factors {output.factors} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_extent_capillary:
    input:
        plan=PLAN_FILE,
        table=rules.passages_table.output,
        stretching=rules.stretching_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig10_extent_capillary.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig10_extent_capillary.py"),
    output:
        multiext(f"{FIGURES}/fig10", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig10.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --stretching {input.stretching} \
            --claims {input.claims} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_return_maps:
    input:
        plan=PLAN_FILE,
        table=rules.crossings_table.output.maps,
        script=f"{SCRIPTS}/drawing/fig_return_maps.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_return_maps.py"),
    output:
        multiext(f"{FIGURES}/fig_return_maps", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_return_maps.log",
    shell:
        "python {input.script} --plan {input.plan} --table {input.table} --csv {output.csv} --output {output.pdf} 2> {log}"


rule figure_film:
    input:
        plan=PLAN_FILE,
        table=rules.passages_table.output,
        script=f"{SCRIPTS}/drawing/fig_film.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_film.py"),
    output:
        multiext(f"{FIGURES}/fig_film", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_film.log",
    shell:
        "python {input.script} --plan {input.plan} --table {input.table} --csv {output.csv} --output {output.pdf} 2> {log}"


rule figure_speed:
    input:
        plan=PLAN_FILE,
        table=rules.passages_table.output,
        crossings=rules.crossings_table.output.crossings,
        boundary=rules.boundary_tables.output.boundary,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig_speed.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_speed.py"),
    output:
        multiext(f"{FIGURES}/fig_speed", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_speed.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --crossings {input.crossings} \
            --boundary {input.boundary} --claims {input.claims} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_a_priori:
    input:
        plan=PLAN_FILE,
        table=rules.a_priori.output.table,
        summary=rules.a_priori.output.summary,
        script=f"{SCRIPTS}/drawing/fig_a_priori.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_a_priori.py"),
    output:
        multiext(f"{FIGURES}/fig_a_priori", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_a_priori.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --summary {input.summary} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_sensitivity:
    input:
        plan=PLAN_FILE,
        table=rules.sensitivity_table.output,
        script=f"{SCRIPTS}/drawing/fig_sensitivity.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_sensitivity.py"),
    output:
        multiext(f"{FIGURES}/fig_sensitivity", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig_sensitivity.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} \
            --csv {output.csv} --output {output.pdf} 2> {log}
        """
