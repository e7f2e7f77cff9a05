"""Which job first: the one with the most work behind it, so that no core waits for a long chain at the end.

The work is what the solver expects (`study.planning.precheck`), in seconds by identity of the run. While
there is no solver to ask, every job has the same priority.
"""

from study.planning.cases import run_id


def priority(seconds):
    """Seconds as Snakemake's priority: a whole number of milliseconds."""
    return int(1000 * seconds)


def case_priority(case, plan, seconds):
    """Priority of a run that nothing waits for."""
    return priority(seconds.get(run_id(case, plan["solver_model"]), 0))


def bracket_priority(bracket, level, plan, seconds):
    """Priority of the jobs of a level of a bracket: its levels run one after the other."""
    one = seconds.get(run_id(bracket["case"], plan["solver_model"]), 0)
    return priority(one * (bracket["levels"] - level + 1))


def run_priorities(plan, seconds):
    """Priority of every run of the plan, by identity.

    Snakemake's priorities do not reach the jobs that a job waits for, so a run that a bracket begins with has
    that of the whole chain behind it.
    """
    found = {run["id"]: priority(seconds.get(run["id"], 0)) for run in plan["runs"]}
    for bracket in plan["brackets"].values():
        behind = bracket_priority(bracket, 0, plan, seconds)
        for _, run in bracket["known"]:
            found[run] = max(found.get(run, 0), behind)
    return found
