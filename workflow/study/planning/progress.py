"""How far a call of the pipeline is and how long it will take, in words for people.

Every job has an expected time on one core: of a solver run what the solver says
(study.planning.precheck), of the others a typical time. The times seen so far correct both kinds by a factor
each, so that a slower machine is known after some runs.
"""

from collections import Counter
from dataclasses import dataclass, field

from study.planning.cases import run_id

#: Seconds of a solver run that the solver has not been asked about.
UNKNOWN = 10.0
#: Seconds of a program of Python that reads tables and writes one, and of the jobs that take longer.
ORDINARY = 2.0
LONGER = {"build": 300, "build_bending_laws": 15, "boundary_fits": 20, "figure_phase_space": 15}
LONGER |= {"report": 6, "paper": 12, "animation": 5, "array_lines": 6, "figure_uncertainty": 15}
LONGER |= {"bracket_start": 0.7, "bracket_narrow": 0.7}
#: Share of the points of brackets that need a run, until some were seen: one that is done asks for none.
NEEDED = 0.7
#: A point of a bracket that took less, in seconds, ran nothing.
NOTHING = 2.0
#: Expected seconds of jobs that the first factor is worth.
BELIEF = 30.0
STAGES = {"streamlines": "flows without a cell", "stokes": "flows without a cell"}
STAGES |= {"sensitivity-flow": "flows without a cell", "stretching": "stretched cells"}
OTHER = "other"  # kind of a job that is no run of the solver


def kind_of(case):
    """Runs that are as far off the solver's expectation: of a scene and, with a cell in a fluid, a kernel."""
    return " ".join([case["scene"], *([case["coupling"]["kernel"]] if "coupling" in case else [])])


def point_in_words(case):
    """A case by the numbers that a reader knows it by."""
    words = []
    if case["scene"] != "stretching":
        geometry = case["geometry"]
        shift = geometry.get("row_shift_um", geometry.get("epsilon", 0) * geometry["pitch_um"])
        words.append(f"d = {shift:g}")
    if case["scene"] == "passage":
        words.append(f"Ca = {case['cell']['capillary_number']:g}")
    elif case["scene"] == "stretching":
        words.append(f"k = {case['cell']['skalak_denominator']:g}")
    return " ".join(words)


@dataclass
class Job:
    """A job of the pipeline: its stage and name in words, expected seconds on one core, and its bracket."""

    stage: str
    name: str
    seconds: float
    kind: str = OTHER
    chain: str = ""
    started: float | None = None
    threads: int = 1


def described(rule, wildcards, plan, threads=1):
    """The job of a rule for these wildcards."""
    runs = plan["by_id"]
    if rule == "solve" and wildcards["run"] in runs:
        run = runs[wildcards["run"]]
        stage, case = STAGES.get(run["group"], "passages"), run["case"]
        return Job(stage, point_in_words(case), plan["seconds"].get(run["id"], UNKNOWN), kind_of(case))
    if rule in ("bracket_point", "bracket_confirm"):
        bracket = plan["brackets"][wildcards["bracket"]]
        case = bracket["confirm"][wildcards["label"]] if rule == "bracket_confirm" else bracket["case"]
        axis = "critical Ca" if bracket["axis"] == "capillary_number" else "critical d"
        name = f"{axis} of {wildcards['bracket']}"
        seconds = plan["seconds"].get(run_id(case, plan["solver_model"]), UNKNOWN)
        return Job("passages of brackets", name, seconds, kind_of(case), wildcards["bracket"])
    if rule == "spot_run" and wildcards["run"] in runs:
        case = runs[wildcards["run"]]["case"]
        seconds = plan["seconds"].get(wildcards["run"], UNKNOWN)
        return Job("runs made again", point_in_words(case), seconds, kind_of(case))
    if rule == "build":
        return Job("solver", "building the solver", LONGER["build"], OTHER, "", None, threads)
    stage = "figures" if rule.startswith("fig") or rule.startswith("anim") else "tables"
    name = rule.replace("_", " ") + "".join(f" {value}" for value in wildcards.values())
    return Job(stage, name, LONGER.get(rule, ORDINARY), OTHER, "", None, threads)


def with_index(plan, seconds):
    """A plan with its runs by identity and what the solver expects of them, {identity: seconds}."""
    return plan | {"by_id": {run["id"]: run for run in plan["runs"]}, "seconds": seconds}


def duration(seconds):
    """A time in words, no finer than it is known."""
    minutes = round(seconds / 60)
    if minutes < 1:
        return "less than a minute"
    if minutes < 60:
        return f"about {minutes} min"
    hours, rest = divmod(minutes, 60)
    return f"about {hours} h {rest} min" if hours < 10 else f"about {hours} h"


@dataclass
class Progress:
    """The jobs of a call: which wait, run and are done, and the factors learned from those that are done."""

    jobs: dict = field(default_factory=dict)
    cores: int = 1
    done: Counter = field(default_factory=Counter)
    total: Counter = field(default_factory=Counter)
    seen: dict = field(default_factory=dict)  # by kind: expected and actual seconds of the jobs that are done
    points: list = field(default_factory=lambda: [0, 0])  # of brackets: that ran, that are done

    def add(self, identity, job):
        """A job that this call has to do."""
        if identity not in self.jobs:
            self.jobs[identity] = job
            self.total[job.stage] += 1

    def start(self, identity, now):
        """A job begins."""
        if identity in self.jobs:
            self.jobs[identity].started = now

    def finish(self, identity, now):
        """A job is done: its time teaches the factor of its kind."""
        job = self.jobs.pop(identity, None)
        if job is None:
            return
        self.done[job.stage] += 1
        took = 0.0 if job.started is None else (now - job.started) * job.threads
        if job.chain:
            self.points[1] += 1
            if took < NOTHING:
                return
            self.points[0] += 1
        expected, actual = self.seen.get(job.kind, (0.0, 0.0))
        self.seen[job.kind] = [expected + job.seconds, actual + took]

    def factor(self, kind):
        """Times seen over times expected, drawn to 1 while little was seen."""
        expected, actual = self.seen.get(kind, (0.0, 0.0))
        return (actual + BELIEF) / (expected + BELIEF)

    def expected(self, job, now):
        """Seconds of one core that a job still takes."""
        needed = (self.points[0] + 3 * NEEDED) / (self.points[1] + 3) if job.chain else 1.0
        whole = job.seconds * self.factor(job.kind)
        if job.started is None:
            return whole * needed
        return max(whole - (now - job.started) * job.threads, 0.1 * whole)

    def left(self, now):
        """Seconds until the end: the work over the cores, or the longest bracket, whose levels wait for one
        another."""
        chains, work = Counter(), Counter()
        for job in self.jobs.values():
            seconds = self.expected(job, now)
            work[job.kind == OTHER] += seconds
            if job.chain:
                chains[job.chain] += seconds
        longest = max(chains.values(), default=0.0)
        return max(work[False] / self.cores, longest) + work[True] / self.cores

    def running(self):
        """Jobs that run, those of the solver first."""
        return sorted((job for job in self.jobs.values() if job.started is not None), key=_solver_last)

    def line(self, now, clock):
        """The line of the minute; `clock` turns a time into the text of a clock."""
        running = self.running()
        stage = running[0].stage if running else "jobs"
        total = self.total[stage] if running else sum(self.total.values())
        done = self.done[stage] if running else sum(self.done.values())
        names = " and ".join(dict.fromkeys(job.name for job in running))
        words = [f"{stage} {done} of {total}"] + ([f"{names} running"] if names else [])
        left = self.left(now)
        return ", ".join([*words, f"{duration(left)} left", f"ends {clock(now + left)}"])

    def table(self):
        """The job table of a dry run, a line for each stage, and the estimate."""
        seconds = Counter()
        for job in self.jobs.values():
            seconds[job.stage] += self.expected(job, 0.0)
        width = max(map(len, self.total), default=0)
        lines = [
            f"{stage:{width}}  {self.total[stage]:5} jobs  {duration(seconds[stage]):>20} of one core"
            for stage in self.total
        ]
        if not lines:
            return ["no jobs"]
        cores = f"{self.cores} core{'s' * (self.cores > 1)}"
        return [*lines, f"{sum(self.total.values())} jobs, {duration(self.left(0.0))} on {cores}"]


def _solver_last(job):
    return job.kind == OTHER


#: The call of this process: what the Snakefile plans and the logger plugin tells.
CURRENT = Progress()
PLAN = {"by_id": {}, "brackets": {}, "runs": [], "seconds": {}, "solver_model": 0}


def describe(plan, seconds, cores):
    """Tells the call of this process its plan, what the solver expects of its runs, and its cores."""
    PLAN.clear()
    PLAN.update(with_index(plan, seconds))
    CURRENT.cores = max(int(cores or 1), 1)


def planned(jobs):
    """Tells the call of this process its jobs: (identity, rule, wildcards, threads)."""
    for identity, rule, wildcards, threads in jobs:
        CURRENT.add(identity, described(rule, wildcards, PLAN, threads))
