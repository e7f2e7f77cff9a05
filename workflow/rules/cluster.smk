"""What jobs of a cluster ask for; on one machine nothing of it is used. See docs/cluster.md.

    snakemake --profile workflow/profiles/slurm
"""

from study.planning import not_planned, requests

CASES = {run["id"]: run["case"] for run in PLAN["runs"]}


def planned(known, name, told, *about):
    """What the plan has under a name that was asked for; if nothing, the end with a reason."""
    try:
        return not_planned.found(known, name, told, *about)
    except not_planned.NotPlanned as who:
        raise WorkflowError(str(who)) from None


def planned_case(wildcards):
    """The case of the run that was asked for."""
    return planned(CASES, wildcards.run, not_planned.no_such_run, STUDY, TIER, RUNS)


def planned_bracket(wildcards):
    """The bracket that was asked for."""
    brackets = PLAN["brackets"]
    return planned(brackets, wildcards.bracket, not_planned.no_such_bracket, STUDY, TIER, brackets)


def confirming_case(wildcards):
    """The case that confirms the ends of a bracket with the settings of a label."""
    confirm = planned_bracket(wildcards)["confirm"]
    return planned(confirm, wildcards.label, not_planned.no_such_label, wildcards.bracket, confirm)


def job_case(wildcards):
    """The case that a job runs, or one that costs as much."""
    if hasattr(wildcards, "run"):
        return planned_case(wildcards)
    return confirming_case(wildcards) if hasattr(wildcards, "label") else planned_bracket(wildcards)["case"]


def job_minutes(wildcards, attempt):
    """Minutes of a job; 0 on one machine, where there is no limit."""
    return 0 if workflow.local_exec else requests.minutes(DLD, job_case(wildcards), attempt)


def job_memory(wildcards, attempt):
    """Memory of a job, MiB; 0 on one machine, where it is not asked for."""
    return 0 if workflow.local_exec else requests.mebibytes(DLD, job_case(wildcards), attempt)


def job_group(wildcards):
    """Group of a run, so that short ones share a job."""
    return None if workflow.local_exec else requests.group(DLD, job_case(wildcards))
