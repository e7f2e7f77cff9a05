"""Reproduction of a deformability-based DLD separation study: solver, runs, tables, figures, verdicts.

    snakemake --cores 2                         the study of the paper, into results/
    snakemake --cores 2 --config study=triangle another study, params/studies/triangle.json, into results/triangle/
    snakemake --cores 2 --config tier=quick     the paper's cells without brackets, into results/quick/
    snakemake --cores 2 --config tier=smoke     a test of every rule on a coarse lattice, into results/smoke/

The runs of a tier stand in the file of its study; workflow/study/planning/plan.py makes the plan of them.
"""

import os
import sys
from pathlib import Path

from snakemake.exceptions import WorkflowError
from snakemake.utils import min_version

min_version("9.0")
os.environ["PYTHONPATH"] = os.path.join(workflow.basedir, "workflow")  # the programs use the package of this tree
os.environ["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
sys.path.insert(0, os.path.join(workflow.basedir, "workflow"))

from study.planning import dld, manifest, progress
from study.planning.documents import SCHEMAS, read_json, validated
from study.planning.failures import failed_runs, forget
from study.planning.folders import PAPER, results_folder, study_file
from study.planning.lock import Busy, only_looks, taken
from study.planning.modules import modules_of
from study.planning.plan import make_plan
from study.planning.plan_file import ids, study_brackets, write_plan
from study.planning.points import STUDY_GROUPS
from study.planning.tiers import load_study
from study.planning.validation import hint

OPTIONS = ["study", "tier", "dld", "sample", "seed", "most_node_updates", "only", "claim"]  # of --config
for name in config:
    if name not in OPTIONS:
        raise ValueError(f"--config {name}: unknown; {hint(name, OPTIONS)}")
if "dld" in config:
    dld.DLD = Path(config["dld"]).absolute()  # the plan of a study in SI units asks the same solver
STUDY = study_file(str(config.get("study", PAPER)))
STUDY_TEXT = load_study(STUDY)
TIER = str(config.get("tier", next(iter(STUDY_TEXT["tiers"]))))
CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")
PLAN = make_plan(STUDY_TEXT, TIER, CASE_SCHEMA)
RESULTS = results_folder(STUDY, TIER, STUDY_TEXT["tiers"])
RUNS = "results/runs"  # shared by all studies and tiers: a run's name is its case
PLANNED = [run["id"] for run in PLAN["runs"]]
JOURNAL = ".snakemake/made.json"  # what a call makes, until its checksums stand in the manifest of the results
if workflow.is_main_process and not only_looks(sys.argv[1:]):
    try:
        LOCK = taken(".snakemake/study.lock", ["snakemake", *sys.argv[1:]])  # held while this process lives
    except Busy as who:
        raise WorkflowError(str(who)) from None
    manifest.settle(JOURNAL)  # of a call that was killed
    forget(PLANNED, RUNS, f"{RESULTS}/brackets")
PLAN_FILE = write_plan(PLAN, f"{RESULTS}/plan.json")
TABLES, FIGURES, LOGS = (f"{RESULTS}/{name}" for name in ("tables", "figures", "logs"))
SCRIPTS = "workflow/scripts"


wildcard_constraints:
    run="[0-9a-f]{12}",


include: "workflow/rules/build.smk"

# Without --cores the jobs are those of a cluster, as many at a time as --jobs says.
progress.describe(PLAN, SECONDS, workflow.resource_settings.cores or workflow.resource_settings.nodes)

include: "workflow/rules/cluster.smk"
include: "workflow/rules/runs.smk"
include: "workflow/rules/flow.smk"
include: "workflow/rules/boundary.smk"
include: "workflow/rules/passages.smk"
include: "workflow/rules/sensitivity.smk"
include: "workflow/rules/shapes.smk"


if "claims" in STUDY_TEXT:  # the study of a paper, judged by what is printed

    CLAIMS = STUDY_TEXT["claims"]
    validated(CLAIMS, "claims")  # before any run, although they are judged after all

    include: "workflow/rules/paper/flow.smk"
    include: "workflow/rules/paper/membrane.smk"
    include: "workflow/rules/paper/stretching.smk"
    include: "workflow/rules/paper/passages.smk"
    include: "workflow/rules/paper/uncertainty.smk"
    include: "workflow/rules/paper/sensitivity.smk"
    include: "workflow/rules/paper/stability.smk"
    include: "workflow/rules/paper/accuracy.smk"
    include: "workflow/rules/paper/performance.smk"
    include: "workflow/rules/paper/spot_check.smk"
    include: "workflow/rules/paper/figures.smk"
    include: "workflow/rules/paper/figures_extent.smk"
    include: "workflow/rules/paper/claims.smk"
    include: "workflow/rules/paper/report.smk"
    include: "workflow/rules/paper/paper.smk"
    include: "workflow/rules/paper/redraw.smk"
    include: "workflow/rules/paper/packaging.smk"

    ALL_FILES = [
        *FLOW_TABLES,
        *MEMBRANE_TABLES,
        *STRETCHING_TABLES,
        *BOUNDARY_TABLES,
        *PASSAGE_TABLES,
        *SENSITIVITY_TABLES,
        *FIGURE_FILES,
        *ANIMATION_FILES,
        *EXTENT_FIGURES,
        *CLAIM_FILES,
        *REPORT_FILES,
        *PAPER_FILES,
    ]
else:

    include: "workflow/rules/study.smk"

    ALL_FILES = STUDY_FILES


rule all:
    default_target: True
    input:
        ALL_FILES,


# Are tables, figures and verdicts as they were made? Nothing is made for it.
rule verify:
    params:
        results=RESULTS,
    shell:
        f"python {SCRIPTS}/planning/manifest.py {{params.results}}"


# Jobs of a cluster; all else takes seconds.
workflow.localrules(*(r.name for r in workflow.rules if r.name not in ("solve", "bracket_point", "bracket_confirm")))


onstart:
    # Snakemake's limit on jobs per second (9.27) leaves with each finished job a timer behind that wakes the
    # scheduler every second until the end: half a core after 130 runs. One machine needs no such limit.
    if workflow.local_exec:
        workflow.scheduler.job_rate_limiter = None
    dag = workflow.dag
    try:
        if not workflow.touch:  # which makes files younger, and makes none
            manifest.begin(RESULTS, JOURNAL, [(job.input, job.output) for job in dag.needrun_jobs()])
    except manifest.Changed as who:
        raise WorkflowError(str(who)) from None
    progress.planned((dag.jobid(job), job.rule.name, job.wildcards_dict, job.threads) for job in dag.needrun_jobs())


onerror:
    manifest.settle(JOURNAL)


onsuccess:
    manifest.settle(JOURNAL)
    asked = {job.rule.name for job in workflow.dag.targetjobs}
    if "claims" in STUDY_TEXT and asked & {"all", "claims"} and Path(CLAIM_FILES[0]).exists():
        shell(f"python {SCRIPTS}/paper/print_claims.py {CLAIM_FILES[0]}")
    if failed := failed_runs(PLANNED, RUNS):
        told = "\n".join(f"  {RUNS}/{run}: {why}" for run, why in failed.items())
        raise WorkflowError(f"{len(failed)} runs failed; all else is made, the next call tries them again:\n{told}")
