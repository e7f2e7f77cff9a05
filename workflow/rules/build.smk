"""The solver, built with CMake into build/."""

from pathlib import Path

# Another binary can be tried with --config dld=PATH.
DLD = config.get("dld", "build/dld")


def solver_sources():
    """Everything that the binary is made from, by suffix."""
    found = Path("solver").rglob("*")
    return sorted(str(path) for path in found if path.suffix in {".cpp", ".hpp", ".in", ".cmake"})


rule build:
    input:
        sources=solver_sources(),
        cmake="CMakeLists.txt",
    output:
        "build/dld",
    log:
        f"{LOGS}/build.log",
    threads: 2
    shell:
        """
        exec > {log} 2>&1
        workflow/scripts/configure
        cmake --build build --target dld -j {threads}
        touch {output}
        """
