"""The figures: each as PDF and PNG with the CSV that it is drawn from beside it.

Data rules read HDF5 and write CSV; drawing rules read CSV alone.
"""

FIGURE_NAMES = ["fig01", "fig02", "fig03", "fig04", "fig05", "fig06", "fig06_classes", "fig07", "table01", "glossary"]
FIGURE_FILES = expand("{folder}/{name}.{ext}", folder=FIGURES, name=FIGURE_NAMES, ext=["pdf", "png", "csv"])
FIGURE_FILES += expand("{folder}/fig08{part}", folder=FIGURES, part=[".pdf", ".png"])
ANIMATION_FILES = expand("{folder}/animation_{name}.gif", folder=FIGURES, name=PLAN["figures"]["animations"])


rule array_lines:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "streamlines", "passages"),
        script=f"{SCRIPTS}/analysis/array_lines.py",
        modules=modules_of(f"{SCRIPTS}/analysis/array_lines.py"),
    output:
        f"{FIGURES}/fig01.csv",
    log:
        f"{LOGS}/array_lines.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule figure_array:
    input:
        plan=PLAN_FILE,
        lines=rules.array_lines.output,
        script=f"{SCRIPTS}/drawing/fig01_array.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig01_array.py"),
    output:
        multiext(f"{FIGURES}/fig01", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig01.log",
    shell:
        "python {input.script} --plan {input.plan} --lines {input.lines} --output {output.pdf} 2> {log}"


rule figure_geometry:
    input:
        plan=PLAN_FILE,
        script=f"{SCRIPTS}/drawing/fig02_geometry.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig02_geometry.py"),
    output:
        multiext(f"{FIGURES}/fig02", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig02.log",
    shell:
        "python {input.script} --plan {input.plan} --csv {output.csv} --output {output.pdf} 2> {log}"


rule figure_glossary:
    input:
        plan=PLAN_FILE,
        script=f"{SCRIPTS}/drawing/fig_glossary.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig_glossary.py"),
    output:
        multiext(f"{FIGURES}/glossary", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/glossary.log",
    shell:
        "python {input.script} --plan {input.plan} --csv {output.csv} --output {output.pdf} 2> {log}"


rule cell_shapes:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "passages", "stretching"),
        script=f"{SCRIPTS}/analysis/cell_shapes.py",
        modules=modules_of(f"{SCRIPTS}/analysis/cell_shapes.py"),
    output:
        fig03=f"{FIGURES}/fig03.csv",
        fig05=f"{FIGURES}/fig05_shapes.csv",
        faces=f"{FIGURES}/faces.csv",
    log:
        f"{LOGS}/cell_shapes.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --fig03 {output.fig03} \
            --fig05 {output.fig05} --faces {output.faces} 2> {log}
        """


rule figure_mesh:
    input:
        plan=PLAN_FILE,
        shapes=rules.cell_shapes.output.fig03,
        faces=rules.cell_shapes.output.faces,
        script=f"{SCRIPTS}/drawing/fig03_mesh.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig03_mesh.py"),
    output:
        multiext(f"{FIGURES}/fig03", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig03.log",
    shell:
        """
        python {input.script} --plan {input.plan} --shapes {input.shapes} --faces {input.faces} \
            --output {output.pdf} 2> {log}
        """


rule flow_fields:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "streamlines"),
        script=f"{SCRIPTS}/analysis/flow_fields.py",
        modules=modules_of(f"{SCRIPTS}/analysis/flow_fields.py"),
    output:
        fields=f"{FIGURES}/fig04.csv",
        separatrices=f"{FIGURES}/fig04_separatrices.csv",
    log:
        f"{LOGS}/flow_fields.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --fields {output.fields} \
            --separatrices {output.separatrices} 2> {log}
        """


rule figure_streamlines:
    input:
        plan=PLAN_FILE,
        fields=rules.flow_fields.output.fields,
        separatrices=rules.flow_fields.output.separatrices,
        script=f"{SCRIPTS}/drawing/fig04_streamlines.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig04_streamlines.py"),
    output:
        multiext(f"{FIGURES}/fig04", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig04.log",
    shell:
        """
        python {input.script} --plan {input.plan} --fields {input.fields} \
            --separatrices {input.separatrices} --output {output.pdf} 2> {log}
        """


rule figure_tweezer:
    input:
        plan=PLAN_FILE,
        table=rules.stretching_table.output,
        experiment=EXPERIMENT,
        shapes=rules.cell_shapes.output.fig05,
        faces=rules.cell_shapes.output.faces,
        script=f"{SCRIPTS}/drawing/fig05_tweezer.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig05_tweezer.py"),
    output:
        multiext(f"{FIGURES}/fig05", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig05.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --experiment {input.experiment} \
            --shapes {input.shapes} --faces {input.faces} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule trajectories:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "passages"),
        script=f"{SCRIPTS}/analysis/trajectories.py",
        modules=modules_of(f"{SCRIPTS}/analysis/trajectories.py"),
    output:
        f"{FIGURES}/fig06.csv",
    log:
        f"{LOGS}/trajectories.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule figure_trajectories:
    input:
        plan=PLAN_FILE,
        trajectories=rules.trajectories.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig06_trajectories.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig06_trajectories.py"),
    output:
        multiext(f"{FIGURES}/fig06", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig06.log",
    shell:
        """
        python {input.script} --plan {input.plan} --trajectories {input.trajectories} --claims {input.claims} \
            --output {output.pdf} 2> {log}
        """


rule figure_classes:
    input:
        plan=PLAN_FILE,
        table=rules.passages_table.output,
        script=f"{SCRIPTS}/drawing/fig06_classes.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig06_classes.py"),
    output:
        multiext(f"{FIGURES}/fig06_classes", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig06_classes.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --csv {output.csv} \
            --output {output.pdf} 2> {log}
        """


rule figure_phase_space:
    input:
        plan=PLAN_FILE,
        passages=rules.passages_table.output,
        boundary=rules.boundary_tables.output.boundary,
        fits=rules.boundary_fits.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig07_phase_space.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig07_phase_space.py"),
    output:
        multiext(f"{FIGURES}/fig07", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/fig07.log",
    shell:
        """
        python {input.script} --plan {input.plan} --passages {input.passages} --boundary {input.boundary} \
            --fits {input.fits} --claims {input.claims} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule figure_separation:
    input:
        plan=PLAN_FILE,
        table=rules.streamline_table.output,
        fits=rules.separation_law_fits.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/table01_separation.py",
        modules=modules_of(f"{SCRIPTS}/drawing/table01_separation.py"),
    output:
        multiext(f"{FIGURES}/table01", pdf=".pdf", png=".png", csv=".csv"),
    log:
        f"{LOGS}/table01.log",
    shell:
        """
        python {input.script} --plan {input.plan} --table {input.table} --fits {input.fits} \
            --claims {input.claims} --csv {output.csv} --output {output.pdf} 2> {log}
        """


rule gap_sections:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "passages"),
        script=f"{SCRIPTS}/analysis/gap_sections.py",
        modules=modules_of(f"{SCRIPTS}/analysis/gap_sections.py"),
    output:
        shapes=f"{FIGURES}/fig08_shapes.csv",
        outlines=f"{FIGURES}/fig08_outlines.csv",
        faces=f"{FIGURES}/fig08_faces.csv",
        numbers=f"{FIGURES}/fig08.csv",
    log:
        f"{LOGS}/gap_sections.log",
    params:
        runs=RUNS,
    shell:
        """
        python {input.script} --plan {input.plan} --runs {params.runs} --shapes {output.shapes} \
            --outlines {output.outlines} --faces {output.faces} --numbers {output.numbers} 2> {log}
        """


rule figure_shapes:
    input:
        plan=PLAN_FILE,
        shapes=rules.gap_sections.output.shapes,
        outlines=rules.gap_sections.output.outlines,
        faces=rules.gap_sections.output.faces,
        numbers=rules.gap_sections.output.numbers,
        separation=rules.streamline_table.output,
        claims=CLAIMS,
        script=f"{SCRIPTS}/drawing/fig08_shapes.py",
        modules=modules_of(f"{SCRIPTS}/drawing/fig08_shapes.py"),
    output:
        multiext(f"{FIGURES}/fig08", pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/fig08.log",
    shell:
        """
        python {input.script} --plan {input.plan} --shapes {input.shapes} --outlines {input.outlines} \
            --faces {input.faces} --numbers {input.numbers} --separation {input.separation} --claims {input.claims} \
            --output {output.pdf} 2> {log}
        """


rule animation_outlines:
    input:
        plan=PLAN_FILE,
        runs=of_runs("run.h5", "passages"),
        script=f"{SCRIPTS}/analysis/animation_outlines.py",
        modules=modules_of(f"{SCRIPTS}/analysis/animation_outlines.py"),
    output:
        f"{FIGURES}/animation.csv",
    log:
        f"{LOGS}/animation_outlines.log",
    params:
        runs=RUNS,
    shell:
        "python {input.script} --plan {input.plan} --runs {params.runs} --output {output} 2> {log}"


rule animation:
    input:
        plan=PLAN_FILE,
        outlines=rules.animation_outlines.output,
        script=f"{SCRIPTS}/drawing/animation.py",
        modules=modules_of(f"{SCRIPTS}/drawing/animation.py"),
    output:
        f"{FIGURES}/animation_{{name}}.gif",
    wildcard_constraints:
        name="|".join(PLAN["figures"]["animations"]),
    log:
        f"{LOGS}/animation_{{name}}.log",
    shell:
        """
        python {input.script} --plan {input.plan} --outlines {input.outlines} --name {wildcards.name} \
            --output {output} 2> {log}
        """


rule animations:
    input:
        ANIMATION_FILES,
