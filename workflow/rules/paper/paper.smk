"""The article, written with LaTeX around the numbers, tables and figures of the results.

Left out of the study where LaTeX is not installed; nothing else needs it. Tables that are made on request
(accuracy, stability, performance) are shown if they are there.
"""

import tomllib
from shutil import which

PAPER_PDF = "paper/paper.pdf" if TIER == "paper" else f"{RESULTS}/paper.pdf"
GENERATED = "paper/generated" if TIER == "paper" else f"{RESULTS}/paper"
HAS_LATEX = all(which(program) for program in ("latexmk", "pdflatex", "bibtex"))
PAPER_FILES = [PAPER_PDF] if HAS_LATEX else []

if not HAS_LATEX:
    print("paper: LaTeX is not installed, so the article is left out (see workflow/bootstrap)", file=sys.stderr)

with open("paper/numbers.toml", "rb") as file:
    PAPER_TABLES = sorted(tomllib.load(file)["tables"])


rule paper_numbers:
    input:
        declared="paper/numbers.toml",
        tables=FLOW_TABLES
        + MEMBRANE_TABLES
        + STRETCHING_TABLES
        + BOUNDARY_TABLES
        + PASSAGE_TABLES
        + SENSITIVITY_TABLES,
        verdicts=rules.claims.output.csv,
        claims=CLAIMS,
        schema="workflow/schemas/case.schema.json",
        plan=PLAN_FILE,
        script=f"{SCRIPTS}/paper/paper_numbers.py",
        modules=modules_of(f"{SCRIPTS}/paper/paper_numbers.py"),
    output:
        f"{GENERATED}/numbers.tex",
        expand("{folder}/table_{name}.tex", folder=GENERATED, name=PAPER_TABLES),
    log:
        f"{LOGS}/paper_numbers.log",
    params:
        tables=TABLES,
        results=RESULTS,
        generated=GENERATED,
        others=made_on_request,
    shell:
        """
        python {input.script} --declared {input.declared} --tables {params.tables} --verdicts {input.verdicts} \
            --claims {input.claims} --case-schema {input.schema} --plan {input.plan} \
            --results {params.results} --output {params.generated} 2> {log}
        """


rule paper:
    input:
        text="paper/main.tex",
        references="paper/references.bib",
        generated=rules.paper_numbers.output,
        figures=[name for name in FIGURE_FILES + EXTENT_FIGURES if name.endswith(".pdf")],
        script=f"{SCRIPTS}/build_paper",
    output:
        PAPER_PDF,
    log:
        f"{LOGS}/paper.log",
    params:
        generated=GENERATED,
        build=f"build/paper/{TIER}",
        others=made_on_request,
    shell:
        "{input.script} {input.text} {params.generated} {params.build} {output} > {log} 2>&1"
