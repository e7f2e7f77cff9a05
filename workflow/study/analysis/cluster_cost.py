"""What a phase space costs on a cluster: the counted work of the committed passages, packed into jobs as the
profile packs them and scheduled on so many cores."""

import heapq

import numpy as np

from study.analysis.tables import markdown_table
from study.planning.requests import GROUPS

POINTS = 1000
CORES = (2, 64, 1024)
#: Runs of a group that share a job, as in workflow/profiles/slurm/config.yaml.
SHARED = {"runs_of_seconds": 16, "runs_of_a_minute": 4}
#: Seconds of a job beside the solver, assumed: Slurm, and Snakemake that starts twice.
JOB_SECONDS = 15.0
#: Preset, sweep of the table of passages, part of the table of stage times that tells its seconds.
SETTINGS = [
    ("standard", "grid", "grid"),
    ("corrected", "corrected", "corrected"),
    ("refined", "grid", "refined"),
    ("reference", "corrected", "reference"),
]


def run_seconds(passages, stages, sweep, part, points=POINTS):
    """Seconds of so many passages: those of a sweep by their node updates, repeated, with the mean that
    the stage took."""
    work = passages[passages.sweep == sweep].node_updates.dropna().to_numpy()
    stage = stages[stages.part == part]
    mean = stage.total_s.sum() / stage.runs.sum()
    return np.resize(work / work.mean() * mean, points)


def jobs(seconds):
    """Seconds of the jobs that runs are packed into: short runs of similar cost share one."""
    limits = sorted(GROUPS.items(), key=lambda item: item[1])
    packed, left = [], np.sort(seconds)
    for name, limit in limits:
        short, left = left[left <= limit], left[left > limit]
        packed += [
            JOB_SECONDS + short[i : i + SHARED[name]].sum() for i in range(0, len(short), SHARED[name])
        ]
    return packed + [JOB_SECONDS + value for value in left]


def makespan(durations, cores):
    """Seconds until the last job ends: the longest first, each on the core that is free first."""
    free = [0.0] * cores
    for duration in sorted(durations, reverse=True):
        heapq.heapreplace(free, free[0] + duration)
    return max(free)


def time_text(seconds):
    """A time for people."""
    return f"{seconds / 3600:.1f} h" if seconds > 5400 else f"{seconds / 60:.0f} min"


def cost_table(passages, stages):
    """Markdown table: core hours, jobs and time on so many cores for every setting."""
    rows = []
    for preset, sweep, part in SETTINGS:
        seconds = run_seconds(passages, stages, sweep, part)
        packed = jobs(seconds)
        times = [time_text(makespan(packed, cores)) for cores in CORES]
        rows.append(
            [f"`{preset}`", f"{seconds.sum() / 3600:.1f}", len(packed), f"{max(seconds):.0f}", *times]
        )
    titles = ["preset", "core hours", "jobs", "longest run / s", *(f"{cores} cores" for cores in CORES)]
    return "\n".join(markdown_table(titles, rows))
