"""What a job of a cluster asks for: minutes and memory by the solver's own estimate of a case, and which
short runs share a job.

The estimate is one of seconds on a core with AVX-512 and of the fields' memory. Of 2262 runs of the study,
95 % took at most 3.3 times the seconds, all at most 7.8 times (docs/cluster.md).
"""

import json
import math
from functools import cache
from pathlib import Path

from study.planning.dld import answers

#: Seconds of a run of which the solver knows no cost, or that is planned before the solver is built.
UNKNOWN_SECONDS = 60
#: A job asks for this times the seconds estimated, doubled with every attempt: a run that is stopped goes on
#: from its checkpoint, so asking for too little costs a start and no work.
TIME_FACTOR = 8
#: Python and Snakemake of a job in minutes and MiB, beside the solver.
OVERHEAD_MINUTES, OVERHEAD_MIB = 2, 600
#: Runs of at most so many seconds share a job with others of their group; how many, says the profile.
GROUPS = {"runs_of_seconds": 15, "runs_of_a_minute": 60}


@cache
def _estimate(dld, text):
    """(seconds, MiB) of a case given as JSON text."""
    if not Path(dld).exists():
        return UNKNOWN_SECONDS, 0
    answer = answers([json.loads(text)], dld)[0]
    if answer["problems"]:
        raise ValueError(f"{dld} resolve: {answer['problems']}")
    return answer["expected_cost"]["seconds_on_one_core"], answer["memory_bytes"] / 2**20


def estimate(dld, case):
    """(seconds, MiB) that a resolved case takes on one core, without any margin."""
    return _estimate(str(dld), json.dumps(case))


def minutes(dld, case, attempt=1):
    """Minutes that the job of a case asks for."""
    seconds, _ = estimate(dld, case)
    return 2 ** (attempt - 1) * (OVERHEAD_MINUTES + math.ceil(TIME_FACTOR * seconds / 60))


def mebibytes(dld, case, attempt=1):
    """Memory that the job of a case asks for, MiB: twice as much once it failed, and no more than that."""
    _, fields = estimate(dld, case)
    return min(attempt, 2) * (OVERHEAD_MIB + math.ceil(2 * fields))


def group(dld, case):
    """Group of runs of similar cost that share jobs; None for a run that is worth a job of its own."""
    seconds, _ = estimate(dld, case)
    return next((name for name, limit in GROUPS.items() if seconds <= limit), None)
