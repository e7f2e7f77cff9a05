"""The boundary between displaced and zigzag: brackets that narrow by three-section.

The depth is known, so the levels are unrolled: level 0 collects what the plan already has (both ends of the
range and the runs of the sweeps with the same settings); each further level runs the two inner thirds, whose
values stand in the state before, and joins them. A bracket that is done asks for nothing: its further levels
run nothing. The runs of a level go to the same folders as all others and are shared with them.
"""

from study.planning.schedule import bracket_priority, case_priority

BRACKETS = f"{RESULTS}/brackets"
SIDES = ["low", "high"]
BRACKET_FILES = [
    f"{BRACKETS}/{name}/level-{bracket['levels']}.json" for name, bracket in study_brackets(PLAN).items()
]
CONFIRMATION_FILES = [
    f"{BRACKETS}/{name}/confirm-{label}-{side}.json"
    for name, bracket in study_brackets(PLAN).items()
    for label in bracket["confirm"]
    for side in SIDES
]
BOUNDARY_TABLES = expand(
    "{folder}/{name}.csv",
    folder=TABLES,
    name=["phase_boundary", "boundary_points", "boundary_confirmation", "critical_row_shift"],
)
BRACKET_CODE = ["workflow/study/planning/brackets.py"]  # the rest of the package does not change a bracket


def bracket_identity(wildcards):
    """Identity of a bracket's definition: a changed definition begins it anew, at every level (a level whose file
    came out with the same bytes would not be passed on)."""
    return planned_bracket(wildcards)["identity"]


def level_priority(wildcards):
    """Priority of a job of a bracket: the work of its level and of those that wait for it."""
    return bracket_priority(planned_bracket(wildcards), int(wildcards.get("level", 0)), PLAN, SECONDS)


def confirmation_priority(wildcards):
    """Priority of a run that confirms an end of a bracket: nothing waits for it."""
    return case_priority(confirming_case(wildcards), PLAN, SECONDS)


def known_runs(wildcards):
    """Summaries of the runs of the plan that lie on a bracket's axis."""
    return [f"{RUNS}/{run}/summary.json" for _, run in planned_bracket(wildcards)["known"]]


def state_before(wildcards):
    """The state of the bracket that a level starts from."""
    return f"{BRACKETS}/{wildcards.bracket}/level-{int(wildcards.level) - 1}.json"


def final_state(wildcards):
    """The last state of a bracket."""
    return f"{BRACKETS}/{wildcards.bracket}/level-{planned_bracket(wildcards)['levels']}.json"


rule bracket_start:
    input:
        plan=ancient(PLAN_FILE),
        runs=known_runs,
        script=f"{SCRIPTS}/planning/bracket_start.py",
        code=BRACKET_CODE,
    output:
        f"{BRACKETS}/{{bracket}}/level-0.json",
    log:
        f"{LOGS}/brackets/{{bracket}}/level-0.log",
    priority: level_priority
    params:
        runs=RUNS,
        identity=bracket_identity,
    shell:
        """
        python {input.script} --plan {input.plan} --name {wildcards.bracket} --runs {params.runs} \
            --output {output} 2> {log}
        """


rule bracket_point:
    input:
        plan=ancient(PLAN_FILE),
        bracket=state_before,
        dld=ancient(DLD),
        runner=ancient(f"{SCRIPTS}/run_case"),
        script=ancient(f"{SCRIPTS}/planning/bracket_point.py"),
    output:
        f"{BRACKETS}/{{bracket}}/level-{{level}}-{{side}}.json",
    wildcard_constraints:
        level="[1-9]",
        side="low|high",
    log:
        f"{LOGS}/brackets/{{bracket}}/level-{{level}}-{{side}}.log",
    priority: level_priority
    params:
        runs=RUNS,
        identity=bracket_identity,
    threads: 1
    resources:
        runtime=job_minutes,
        mem_mb=job_memory,
    shell:
        """
        python {input.script} --plan {input.plan} --bracket {input.bracket} --side {wildcards.side} \
            --runs {params.runs} --dld {input.dld} --runner {input.runner} --output {output} 2> {log}
        """


rule bracket_narrow:
    input:
        plan=ancient(PLAN_FILE),
        bracket=state_before,
        points=[f"{BRACKETS}/{{bracket}}/level-{{level}}-{side}.json" for side in SIDES],
        script=f"{SCRIPTS}/planning/bracket_narrow.py",
        code=BRACKET_CODE,
    output:
        f"{BRACKETS}/{{bracket}}/level-{{level}}.json",
    wildcard_constraints:
        level="[1-9]",
    log:
        f"{LOGS}/brackets/{{bracket}}/level-{{level}}.log",
    priority: level_priority
    params:
        identity=bracket_identity,
    shell:
        """
        python {input.script} --plan {input.plan} --bracket {input.bracket} --points {input.points} \
            --output {output} 2> {log}
        """


rule bracket_confirm:
    input:
        plan=ancient(PLAN_FILE),
        bracket=final_state,
        dld=ancient(DLD),
        runner=ancient(f"{SCRIPTS}/run_case"),
        script=ancient(f"{SCRIPTS}/planning/bracket_point.py"),
    output:
        f"{BRACKETS}/{{bracket}}/confirm-{{label}}-{{side}}.json",
    wildcard_constraints:
        label="[a-z0-9.-]+",
        side="low|high",
    log:
        f"{LOGS}/brackets/{{bracket}}/confirm-{{label}}-{{side}}.log",
    priority: confirmation_priority
    params:
        runs=RUNS,
        identity=bracket_identity,
    threads: 1
    resources:
        runtime=job_minutes,
        mem_mb=job_memory,
    shell:
        """
        python {input.script} --plan {input.plan} --bracket {input.bracket} --side {wildcards.side} \
            --confirm {wildcards.label} --runs {params.runs} --dld {input.dld} --runner {input.runner} \
            --output {output} 2> {log}
        """


rule boundary_tables:
    input:
        plan=PLAN_FILE,
        brackets=BRACKET_FILES + CONFIRMATION_FILES,
        script=f"{SCRIPTS}/analysis/boundary_tables.py",
        modules=modules_of(f"{SCRIPTS}/analysis/boundary_tables.py"),
    output:
        boundary=f"{TABLES}/phase_boundary.csv",
        points=f"{TABLES}/boundary_points.csv",
        confirmation=f"{TABLES}/boundary_confirmation.csv",
        row_shifts=f"{TABLES}/critical_row_shift.csv",
    log:
        f"{LOGS}/boundary_tables.log",
    params:
        brackets=BRACKETS,
    shell:
        """
        python {input.script} --plan {input.plan} --brackets {params.brackets} --boundary {output.boundary} \
            --points {output.points} --confirmation {output.confirmation} --row-shifts {output.row_shifts} \
            2> {log}
        """
