"""What travels with the results, on request: `snakemake --cores 2 software_list crate`. And what the study costs on a
cluster, for docs/cluster.md: `snakemake --cores 1 cluster_cost`.

software.cdx.json is the list of the software with versions, hashes and licences (CycloneDX). ro-crate-metadata.json
says what each file of the results is, with its checksum (RO-Crate 1.1); it describes what is there when it is made.
"""



rule software_list:
    input:
        lock="workflow/requirements.txt",
        libraries="workflow/libraries.csv",
        cmake="CMakeLists.txt",
        script=f"{SCRIPTS}/analysis/software_list.py",
        code="workflow/study/analysis/software.py",
    output:
        f"{RESULTS}/software.cdx.json",
    log:
        f"{LOGS}/software_list.log",
    shell:
        "python {input.script} --output {output} 2> {log}"


rule crate:
    input:
        tables=FLOW_TABLES + MEMBRANE_TABLES + STRETCHING_TABLES + BOUNDARY_TABLES + PASSAGE_TABLES,
        figures=FIGURE_FILES + EXTENT_FIGURES,
        claims=CLAIM_FILES,
        software=rules.software_list.output,
        script=f"{SCRIPTS}/analysis/ro_crate.py",
        code="workflow/study/analysis/crate.py",
    output:
        f"{RESULTS}/ro-crate-metadata.json",
    log:
        f"{LOGS}/crate.log",
    params:
        results=RESULTS,
        tiers=sorted(STUDY_TEXT["tiers"]),
    shell:
        "python {input.script} --results {params.results} --tiers {params.tiers} 2> {log}"


rule cluster_cost:
    input:
        passages=f"{TABLES}/passages.csv",
        stages=f"{TABLES}/stage_times.csv",
        script=f"{SCRIPTS}/analysis/cluster_cost.py",
        code=["workflow/study/analysis/cluster_cost.py", "workflow/study/planning/requests.py"],
    params:
        page="docs/cluster.md",
    shell:
        "python {input.script} --passages {input.passages} --stages {input.stages} --page {params.page}"
