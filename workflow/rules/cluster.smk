"""What jobs of a cluster ask for; on one machine nothing of it is used. See docs/cluster.md.

    snakemake --profile workflow/profiles/slurm
"""

from study.planning import requests

CASES = {run["id"]: run["case"] for run in PLAN["runs"]}


def job_case(wildcards):
    """The case that a job runs, or one that costs as much."""
    if hasattr(wildcards, "run"):
        return CASES[wildcards.run]
    bracket = PLAN["brackets"][wildcards.bracket]
    return bracket["confirm"][wildcards.label] if hasattr(wildcards, "label") else bracket["case"]


def job_minutes(wildcards, attempt):
    """Minutes of a job; 0 on one machine, where there is no limit."""
    return 0 if workflow.local_exec else requests.minutes(DLD, job_case(wildcards), attempt)


def job_memory(wildcards, attempt):
    """Memory of a job, MiB; 0 on one machine, where it is not asked for."""
    return 0 if workflow.local_exec else requests.mebibytes(DLD, job_case(wildcards), attempt)


def job_group(wildcards):
    """Group of a run, so that short ones share a job."""
    return None if workflow.local_exec else requests.group(DLD, job_case(wildcards))
