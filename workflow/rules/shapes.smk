"""Every pillar shape on a picture and a page of the documents, on request: `snakemake shapes`."""

SHAPES = "docs/shapes"
CASE_SCHEMA_FILE = "workflow/schemas/case.schema.json"


rule shape_outlines:
    input:
        dld=DLD,
        schema=CASE_SCHEMA_FILE,
        script=f"{SCRIPTS}/analysis/shape_outlines.py",
        modules=modules_of(f"{SCRIPTS}/analysis/shape_outlines.py"),
    output:
        f"{SHAPES}.csv",
    log:
        f"{LOGS}/shape_outlines.log",
    shell:
        "python {input.script} --schema {input.schema} --dld {input.dld} --output {output} 2> {log}"


rule shapes_picture:
    input:
        outlines=rules.shape_outlines.output,
        script=f"{SCRIPTS}/drawing/shapes_picture.py",
        modules=modules_of(f"{SCRIPTS}/drawing/shapes_picture.py"),
    output:
        multiext(SHAPES, pdf=".pdf", png=".png"),
    log:
        f"{LOGS}/shapes_picture.log",
    shell:
        "python {input.script} --outlines {input.outlines} --output {output.pdf} 2> {log}"


rule shapes_page:
    input:
        schema=CASE_SCHEMA_FILE,
        script=f"{SCRIPTS}/analysis/shapes_page.py",
        modules=modules_of(f"{SCRIPTS}/analysis/shapes_page.py"),
    output:
        f"{SHAPES}.md",
    log:
        f"{LOGS}/shapes_page.log",
    shell:
        "python {input.script} --schema {input.schema} --output {output} 2> {log}"


rule shapes:
    input:
        rules.shapes_picture.output,
        rules.shapes_page.output,
