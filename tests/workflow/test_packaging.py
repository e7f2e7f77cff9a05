"""What travels with the package: locks, lists of software, metadata of the results, recipes."""

import json
import re
import subprocess

import pytest
import yaml
from conftest import ROOT
from short_passage import DLD, PASSAGE, needs_solver
from study.analysis import cluster_cost
from study.analysis.crate import crate
from study.analysis.software import libraries, locked_packages, software_list
from study.planning import requests
from study.planning.plan import load_plan
from study.planning.points import merged

LOCKS = ("requirements", "requirements-build", "requirements-cluster", "requirements-test")


def text(path):
    return (ROOT / path).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", LOCKS)
def test_a_lock_holds_what_was_asked_for_with_hashes(name):
    locked = {found[0]: found[1] for found in locked_packages(text(f"workflow/{name}.txt"))}
    asked = re.findall(r"^([A-Za-z0-9_.-]+)==(\S+)", text(f"workflow/{name}.in"), flags=re.MULTILINE)
    assert asked
    for package, version in asked:
        assert locked.get(package.lower()) == version, f"{package}: bash workflow/lock"


@pytest.mark.parametrize("name", LOCKS)
def test_a_lock_names_no_host_and_nothing_without_a_hash(name):
    lock = text(f"workflow/{name}.txt")
    assert "://" not in lock and "--index" not in lock
    lines = re.sub(r"\\\n\s*", " ", lock).splitlines()
    packages = [line for line in lines if line.strip() and not line.startswith("#")]
    assert len(packages) == len(list(locked_packages(lock)))


def test_the_cluster_takes_the_versions_of_the_study():
    study, cluster = (
        {found[0]: set() for found in locked_packages(text(f"workflow/{name}.txt"))}
        for name in ("requirements", "requirements-cluster")
    )
    for found, name in ((study, "requirements"), (cluster, "requirements-cluster")):
        for package, version, _, _ in locked_packages(text(f"workflow/{name}.txt")):
            found[package].add(version)
    for package in study.keys() & cluster.keys():
        assert cluster[package] <= study[package], package


def test_every_linked_library_has_a_licence():
    rows = {row["package"] for row in libraries()}
    wanted = re.search(r"^packages=\((.*?)\)", text("workflow/bootstrap"), flags=re.MULTILINE | re.DOTALL)
    linked = {word for word in wanted.group(1).split() if re.fullmatch(r"(lib.*|.*json.*)-dev", word)}
    assert linked and linked <= rows
    assert all(row["licence"] for row in libraries())


def test_the_list_of_software_is_what_the_lock_holds():
    document = software_list("1.0.0")
    assert document["bomFormat"] == "CycloneDX"
    references = [part["bom-ref"] for part in document["components"]]
    assert len(references) == len(set(references))
    assert document["dependencies"][0]["dependsOn"] == references
    snakemake = next(part for part in document["components"] if part["name"] == "snakemake")
    assert snakemake["version"] in text("workflow/requirements.in")
    assert snakemake["licenses"] == [{"expression": "MIT"}]
    assert json.dumps(document) == json.dumps(software_list("1.0.0"))


def test_the_crate_names_every_result_once_with_its_checksum(tmp_path):
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables/fits.csv").write_text("a\n1\n", encoding="utf-8")
    for left_out in ("runs", "logs", "smoke"):
        (tmp_path / left_out).mkdir()
        (tmp_path / left_out / "file.csv").write_text("x", encoding="utf-8")
    (tmp_path / "claims.csv").write_text("verdict\n", encoding="utf-8")
    document = crate(tmp_path, others=["smoke"])
    files = {entity["@id"]: entity for entity in document["@graph"] if entity["@type"] == "File"}
    assert sorted(files) == ["claims.csv", "tables/fits.csv"]
    done = subprocess.run(["sha256sum", tmp_path / "tables/fits.csv"], capture_output=True, text=True)
    assert files["tables/fits.csv"]["sha256"] == done.stdout.split()[0]
    known = {entity["@id"] for entity in document["@graph"]}
    assert len(known) == len(document["@graph"])
    root = next(entity for entity in document["@graph"] if entity["@id"] == "./")
    for part in root["hasPart"] + [root["mentions"], root["author"], root["citation"]]:
        assert part["@id"] in known


def test_the_container_installs_what_bootstrap_installs_and_is_no_root():
    recipe = text("Dockerfile")
    assert re.search(r"^FROM debian:\d+\.\d+-slim$", recipe, flags=re.MULTILINE)
    assert "apt-get" not in recipe and "pip" not in recipe.replace("pipeline", "")
    assert recipe.count("bash workflow/bootstrap") == 2
    users = re.findall(r"^USER (\S+)", recipe, flags=re.MULTILINE)
    assert users and users[-1] != "root"


def test_versions_agree():
    version = re.search(r"project\(dld VERSION (\S+)", text("CMakeLists.txt")).group(1)
    assert json.loads(text("codemeta.json"))["version"] == version
    assert f"\nversion: {version}\n" in text("CITATION.cff")
    assert f"## {version}" in text("CHANGELOG.md")


@pytest.mark.parametrize("page", ["CONTRIBUTING.md", "docs/cluster.md", "docs/reproducibility.md"])
def test_commands_and_files_of_a_page_exist(page):
    words = re.findall(r"(?<![\w/.-])((?:workflow|params|tests|solver|\.ci)/[\w./-]+[\w])", text(page))
    assert words
    for word in words:
        assert (ROOT / word).exists(), word


def test_continuous_integration_calls_the_one_script():
    assert "run: bash .ci/run" in text(".github/workflows/ci.yml")


def test_the_page_of_the_cluster_packs_runs_as_the_profile_does():
    profile = yaml.safe_load(text("workflow/profiles/slurm/config.yaml"))
    assert profile["group-components"] == cluster_cost.SHARED
    assert set(cluster_cost.SHARED) == set(requests.GROUPS)


def test_jobs_are_scheduled_on_the_core_that_is_free_first():
    assert cluster_cost.makespan([3, 3, 2, 2, 2], 2) == 7
    assert cluster_cost.makespan([5, 1, 1], 1024) == 5
    packed = cluster_cost.jobs([10.0] * 17 + [50.0] * 5 + [100.0])
    start = cluster_cost.JOB_SECONDS
    assert sorted(packed) == sorted(start + value for value in (160.0, 10.0, 200.0, 50.0, 100.0))


def test_a_job_asks_for_more_after_every_failure():
    case = load_plan(ROOT / "params/studies/krueger2014.json", "smoke")["runs"][0]["case"]
    nothing = ROOT / "no/solver"
    first = requests.minutes(nothing, case), requests.mebibytes(nothing, case)
    assert first[0] > requests.OVERHEAD_MINUTES and first[1] >= requests.OVERHEAD_MIB
    assert (requests.minutes(nothing, case, 3), requests.mebibytes(nothing, case, 3)) == (
        4 * first[0],
        2 * first[1],
    )


@needs_solver
def test_what_a_job_asks_for_is_the_solvers_estimate():
    seconds, memory = requests.estimate(DLD, PASSAGE)
    assert 0 < seconds < 60 and memory > 0
    assert requests.group(DLD, PASSAGE) == "runs_of_seconds"
    with pytest.raises(ValueError, match="lattice_spacing_um"):
        requests.estimate(DLD, merged(PASSAGE, {"fluid": {"lattice_spacing_um": 0}}))
