"""Reproduction of a deformability-based DLD separation study: solver, runs, tables, figures, verdicts.

    snakemake --cores 2                       the whole study, into results/
    snakemake --cores 2 --config tier=quick   the paper's cells without brackets, into results/quick/
    snakemake --cores 2 --config tier=smoke   a test of every rule on a coarse lattice, into results/smoke/

The runs of a tier stand in params/study.json; workflow/study/plan.py resolves them.
"""

import os
import sys
from glob import glob
from pathlib import Path

from snakemake.exceptions import WorkflowError
from snakemake.utils import min_version

min_version("9.0")
os.environ["PYTHONPATH"] = os.path.join(workflow.basedir, "workflow")  # the programs use the package of this tree
os.environ["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
sys.path.insert(0, os.path.join(workflow.basedir, "workflow"))

from study import progress
from study.failures import failed_runs, forget
from study.lock import Busy, only_looks, taken
from study.plan import ids, load_plan, study_brackets, validated, write_plan
from study.points import STUDY_GROUPS
from study.validation import hint

STUDY, CLAIMS = "params/study.json", "params/claims.json"
OPTIONS = ["tier", "dld", "sample", "seed", "most_node_updates", "only", "claim"]  # of --config
for name in config:
    if name not in OPTIONS:
        raise ValueError(f"--config {name}: unknown; {hint(name, OPTIONS)}")
TIER = str(config.get("tier", "paper"))
PLAN = load_plan(STUDY, TIER)
validated(CLAIMS, "claims")  # before any run, although they are judged after all
RESULTS = "results" if TIER == "paper" else f"results/{TIER}"
RUNS = "results/runs"  # shared by all tiers: a run's name is its case
PLANNED = [run["id"] for run in PLAN["runs"]]
if workflow.is_main_process and not only_looks(sys.argv[1:]):
    try:
        LOCK = taken(".snakemake/study.lock", ["snakemake", *sys.argv[1:]])  # held while this process lives
    except Busy as who:
        raise WorkflowError(str(who)) from None
    forget(PLANNED, RUNS, f"{RESULTS}/brackets")
progress.describe(PLAN, workflow.cores)
PLAN_FILE = write_plan(PLAN, f"{RESULTS}/plan.json")
TABLES, FIGURES, LOGS = (f"{RESULTS}/{name}" for name in ("tables", "figures", "logs"))
SCRIPTS = "workflow/scripts"
PACKAGE = sorted(glob("workflow/study/*.py"))  # every analysis depends on it


wildcard_constraints:
    run="[0-9a-f]{12}",


include: "workflow/rules/build.smk"
include: "workflow/rules/runs.smk"
include: "workflow/rules/flow.smk"
include: "workflow/rules/membrane.smk"
include: "workflow/rules/stretching.smk"
include: "workflow/rules/boundary.smk"
include: "workflow/rules/uncertainty.smk"
include: "workflow/rules/passages.smk"
include: "workflow/rules/sensitivity.smk"
include: "workflow/rules/stability.smk"
include: "workflow/rules/accuracy.smk"
include: "workflow/rules/performance.smk"
include: "workflow/rules/spot_check.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/figures_extent.smk"
include: "workflow/rules/claims.smk"
include: "workflow/rules/report.smk"
include: "workflow/rules/paper.smk"
include: "workflow/rules/redraw.smk"


rule all:
    default_target: True
    input:
        FLOW_TABLES,
        MEMBRANE_TABLES,
        STRETCHING_TABLES,
        BOUNDARY_TABLES,
        PASSAGE_TABLES,
        SENSITIVITY_TABLES,
        FIGURE_FILES,
        ANIMATION_FILES,
        EXTENT_FIGURES,
        CLAIM_FILES,
        REPORT_FILES,
        PAPER_FILES,


onstart:
    # Snakemake's limit on jobs per second (9.27) leaves with each finished job a timer behind that wakes the
    # scheduler every second until the end: half a core after 130 runs. One machine needs no such limit.
    if workflow.local_exec:
        workflow.scheduler.job_rate_limiter = None
    dag = workflow.dag
    progress.planned((dag.jobid(job), job.rule.name, job.wildcards_dict, job.threads) for job in dag.needrun_jobs())


onsuccess:
    if {job.rule.name for job in workflow.dag.targetjobs} & {"all", "claims"} and Path(CLAIM_FILES[0]).exists():
        shell(f"python {SCRIPTS}/print_claims.py {CLAIM_FILES[0]}")
    if failed := failed_runs(PLANNED, RUNS):
        told = "\n".join(f"  {RUNS}/{run}: {why}" for run, why in failed.items())
        raise WorkflowError(f"{len(failed)} runs failed; all else is made, the next call tries them again:\n{told}")
