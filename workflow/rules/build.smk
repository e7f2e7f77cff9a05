"""The solver, built with CMake into build/, and what it says of the plan before anything runs.

The plan is made without the solver, which a fresh clone does not have yet. Its cases are shown to the solver as
soon as there is one: when the Snakefile is read, if the solver is up to date, else at the end of its build.
"""

from pathlib import Path

from study.planning.precheck import is_current, seconds_of_runs

# Another binary can be tried with --config dld=PATH.
DLD = config.get("dld", "build/dld")


def solver_sources():
    """Everything that the binary is made from, by suffix."""
    found = Path("solver").rglob("*")
    return sorted(str(path) for path in found if path.suffix in {".cpp", ".hpp", ".in", ".cmake"})


DLD_SOURCES = [*solver_sources(), "CMakeLists.txt"] if DLD == "build/dld" else []
SECONDS = {}  # that runs are expected to take
if is_current(DLD, DLD_SOURCES):
    SECONDS = seconds_of_runs(STUDY, PLAN, CASE_SCHEMA, DLD, f"{RESULTS}/expected_seconds.json")


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
        python {SCRIPTS}/planning/check_plan.py --study {STUDY} --tier {TIER} --dld {output} --output {RESULTS}/expected_seconds.json
        """
