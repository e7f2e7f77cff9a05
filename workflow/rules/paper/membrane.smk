"""The bending laws: what a fold, a sphere and a squeezed cell feel of each."""

MEMBRANE_TABLES = [f"{TABLES}/bending_laws.csv"]


rule bending_laws:
    input:
        MEMBRANE_TABLES,


rule build_bending_laws:
    input:
        dld=DLD,  # one build at a time in build/
        sources=solver_sources(),
        program="tests/bench/bending_laws.cpp",
        cases="tests/support/bending_cases.hpp",
        cmake="CMakeLists.txt",
    output:
        "build/bending_laws",
    log:
        f"{LOGS}/build_bending_laws.log",
    threads: 2
    shell:
        """
        exec > {log} 2>&1
        workflow/scripts/configure
        cmake --build build --target bending_laws -j {threads}
        touch {output}
        """


rule bending_laws_table:
    input:
        program=rules.build_bending_laws.output,
        script=f"{SCRIPTS}/analysis/bending_laws_table.py",
        modules=modules_of(f"{SCRIPTS}/analysis/bending_laws_table.py"),
    output:
        f"{TABLES}/bending_laws.csv",
    log:
        f"{LOGS}/bending_laws_table.log",
    shell:
        "{input.program} | python {input.script} --measured /dev/stdin --output {output} 2> {log}"
