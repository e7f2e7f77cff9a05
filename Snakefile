"""Reproduction of a deformability-based DLD separation study: solver, runs, tables, figures, verdicts.

    snakemake --cores 2                       the whole study, into results/
    snakemake --cores 2 --config tier=smoke   every rule on a coarse lattice, into results/smoke/

The runs of a tier stand in params/study.json; workflow/study/plan.py resolves them.
"""

import os
import sys
from glob import glob
from pathlib import Path

from snakemake.utils import min_version

min_version("9.0")
os.environ["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
sys.path.insert(0, os.path.join(workflow.basedir, "workflow"))

from study.plan import SCHEMAS, ids, load_plan, read_json, study_brackets, validated, write_plan
from study.points import STUDY_GROUPS
from study.validation import hint

STUDY, CLAIMS = "params/study.json", "params/claims.json"
OPTIONS = ["tier", "dld", "sample", "seed", "most_node_updates"]  # of --config
for name in config:
    if name not in OPTIONS:
        raise ValueError(f"--config {name}: unknown; {hint(name, OPTIONS)}")
TIER = str(config.get("tier", "paper"))
CASE_SCHEMA = read_json(SCHEMAS / "case.schema.json")
PLAN = load_plan(STUDY, TIER)
validated(CLAIMS, "claims")  # before any run, although they are judged after all
RESULTS = "results" if TIER == "paper" else f"results/{TIER}"
PLAN_FILE = write_plan(PLAN, f"{RESULTS}/plan.json")
RUNS = "results/runs"  # shared by all tiers: a run's name is its case
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


onsuccess:
    if Path(CLAIM_FILES[0]).exists():
        shell(f"python {SCRIPTS}/print_claims.py {CLAIM_FILES[0]}")
