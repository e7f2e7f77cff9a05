"""Attacks on the solver as data: each row of rows/*.json is an input with its right answer; this program
tries them, prints what did not hold and fills the table of docs/faults.md.

    python tests/attacks/attack.py                      all rows
    python tests/attacks/attack.py --quick              those of fractions of a second
    python tests/attacks/attack.py --document           and write docs/faults.md

A row:

    what      the attack in words, unique
    case      a case (JSON), put over the base "on" of bases.json; or
    text      text of the case file, or its parts and how often each: [["[", 200000], ["]", 200000]]; or
    bytes, file, names     its bytes (hexadecimal); a file of the repository; so many unknown names
    words     arguments of the solver; CASE is the case file, the folder is a fresh one; default: check CASE
    files, links, folders, pipes, env, limits what is there before
    exit      allowed exit codes
    says      parts of what has to be printed
    labels    allowed "status" of the summary; whatever else is nonsense that passes for a result
    no_number_above    greatest number of the summary; a larger one is a sentinel
    keeps     files that have to be as they were
    absent    files that must not be there afterwards
    slow      true: takes more than a second
    test      instead of all that: a test of pytest or of unit_tests that does it, and "times" how often

Never allowed: another exit code, what stands in NEVER, more than LIMIT seconds of a core.
"""

import argparse
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import psutil
from mutations import mutated_rows

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LIMIT, SIGNAL_LIMIT = 10.0, 1.5  # s of a core; more is a hang; the second after a signal to end
NEVER = ("unexpected failure", "Segmentation fault", "runtime error:", "AddressSanitizer", "what():")


@dataclass
class Outcome:
    """What became of a row: what was wrong, in words; nothing if it held."""

    row: dict
    faults: list

    @property
    def held(self):
        return not self.faults


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def put_over(base, change):
    """A document with the members of another put over it, objects member by member."""
    if not (isinstance(base, dict) and isinstance(change, dict)):
        return change
    return base | {key: put_over(base.get(key), value) for key, value in change.items()}


def case_text(row, bases):
    """Text of the case file of a row, as bytes."""
    if "text" in row:
        parts = row["text"] if isinstance(row["text"], list) else [[row["text"], 1]]
        return "".join(part * count for part, count in parts).encode("utf-8", "surrogateescape")
    if "names" in row:
        return json.dumps({"scene": "passage"} | {f"x{number}": 1 for number in range(row["names"])}).encode()
    if "bytes" in row:
        return bytes.fromhex(row["bytes"])
    if "file" in row:
        return (ROOT / row["file"]).read_bytes()
    return json.dumps(put_over(bases[row.get("on", "passage")], row.get("case", {}))).encode()


def prepare(row, folder, bases):
    """Lays out the files of a row in its folder."""
    (folder / "case.json").write_bytes(case_text(row, bases))
    for name in row.get("folders", []):
        (folder / name).mkdir()
    for name, text in row.get("files", {}).items():
        (folder / name).write_text(text, encoding="utf-8")
    for name, target in row.get("links", {}).items():
        (folder / name).symlink_to(target)
    for name in row.get("pipes", []):
        os.mkfifo(folder / name)


def limits(row):
    """What the process of a row is allowed; for preexec_fn."""

    def apply():
        given = row.get("limits", {})
        if "file_bytes" in given:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (given["file_bytes"],) * 2)
        if "memory_MiB" in given:
            resource.setrlimit(resource.RLIMIT_AS, (given["memory_MiB"] * 2**20,) * 2)

    return apply


def cpu_seconds(process):
    """Processor time of a process so far, s: a hang is told by it, as other work delays the clock."""
    try:
        return sum(psutil.Process(process.pid).cpu_times()[:2])
    except psutil.Error:
        return 0.0


def ended_within(process, seconds):
    """Whether a process ends before it takes so many more seconds of a core, or 30 times as long asleep."""
    used, started = cpu_seconds(process), time.monotonic()
    while process.poll() is None:
        if cpu_seconds(process) - used > seconds or time.monotonic() - started > 30 * seconds:
            return False
        time.sleep(0.02)
    return True


def ended(process, row):
    """Waits for the end, after the signal of the row if it has one; False if it hangs and was killed."""
    if "signal" in row and not ended_within(process, row["after"]):
        process.send_signal(getattr(signal, row["signal"]))
        in_time = ended_within(process, SIGNAL_LIMIT)
    else:
        in_time = ended_within(process, row.get("seconds", LIMIT))
    if not in_time:
        process.kill()
    process.wait()
    return in_time


def large_numbers(summary, limit):
    """Names and values of the numbers of a summary beyond a limit: sentinels that left the program."""
    numbers = {name: value for name, value in summary.items() if isinstance(value, (int, float))}
    return [(name, value) for name, value in numbers.items() if abs(value) > limit]


def judged(row, folder, code, printed, before):
    """What is wrong with the end of a run."""
    faults = []
    allowed = row["exit"] if isinstance(row["exit"], list) else [row["exit"]]
    if code not in allowed:
        faults.append(f"exit code {code}, not {' or '.join(map(str, allowed))}")
    faults += [f"prints {text!r}" for text in NEVER if text in printed]
    faults += [f"does not say {text!r}" for text in row.get("says", []) if text not in printed]
    faults += [f"says {text!r}" for text in row.get("silent", []) if text in printed]
    summary = folder / row.get("summary", "summary.json")
    if "labels" in row and code == 0:
        status = read(summary).get("status") if summary.exists() else "none"
        if status not in row["labels"]:
            faults.append(f"labelled {status!r}")
    if "no_number_above" in row and summary.exists():
        faults += [
            f"{name} = {value:g}" for name, value in large_numbers(read(summary), row["no_number_above"])
        ]
    for name, content in before.items():
        if not (folder / name).exists() or (folder / name).read_bytes() != content:
            faults.append(f"{name} is not as it was")
    faults += [f"{name} is there" for name in row.get("absent", []) if (folder / name).exists()]
    return faults


def tried(row, solver, bases):
    """Tries one row; its outcome."""
    with tempfile.TemporaryDirectory(prefix="attack-") as name:
        folder = Path(name)
        prepare(row, folder, bases)
        before = {kept: (folder / kept).read_bytes() for kept in row.get("keeps", [])}
        words = [str(ROOT / word[5:]) if word.startswith("ROOT/") else word for word in row["words"]]
        words = ["case.json" if word == "CASE" else word for word in words]
        environment = {**os.environ, "OMP_NUM_THREADS": "1", **row.get("env", {})}
        printed = folder / "printed"
        with printed.open("a") as errors, (folder / row.get("stdout", "printed")).open("a") as output:
            process = subprocess.Popen(
                [solver, *words],
                cwd=folder,
                env={key: value for key, value in environment.items() if value is not None},
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=errors,
                preexec_fn=limits(row),
            )
            in_time = ended(process, row)
        text = printed.read_text(encoding="utf-8", errors="replace")
        return Outcome(row, judged(row, folder, process.returncode, text, before) if in_time else ["hangs"])


def tested(row):
    """Runs the test that a row names."""
    if row["test"].startswith("tests/"):
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", row["test"]]
    else:
        command = [ROOT / "build/unit_tests", f"--gtest_filter={row['test']}"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    ran = "1 skipped" not in done.stdout and "from 0 test" not in done.stdout
    return Outcome(row, [] if done.returncode == 0 and ran else [f"{row['test']} fails"])


def all_rows(quick):
    """Rows of the files and those made from the schema, with what they leave out filled in."""
    rows = []
    for path in sorted((HERE / "rows").glob("*.json")):
        document = read(path)
        rows += [{"group": document["group"], **document.get("all", {}), **row} for row in document["rows"]]
    rows += mutated_rows(read(ROOT / "workflow/schemas/case.schema.json"))
    for row in rows:
        row.setdefault("words", ["check", "CASE"])
    names = [row["what"] for row in rows]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise ValueError(f"rows of one name: {sorted(twice)}")
    return [row for row in rows if not quick or not (row.get("slow") or "test" in row)]


def outcomes(quick, solver, only=""):
    """Tries the rows whose description contains a text, one after the other."""
    bases = read(HERE / "bases.json")
    for row in all_rows(quick):
        if only in row["what"]:
            yield tested(row) if "test" in row else tried(row, solver, bases)


def main():
    from document import faults_page

    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solver", default=str(ROOT / "build/dld"))
    parser.add_argument("--quick", action="store_true", help="leave out what takes longer than a second")
    parser.add_argument("--only", default="", help="rows whose description contains this")
    parser.add_argument("--document", action="store_true", help="write docs/faults.md")
    arguments = parser.parse_args()
    found = []
    for outcome in outcomes(arguments.quick, str(Path(arguments.solver).resolve()), arguments.only):
        found.append(outcome)
        if not outcome.held:
            print(f"FAILED {outcome.row['what']}: {'; '.join(outcome.faults)}", flush=True)
    if arguments.document:
        (ROOT / "docs/faults.md").write_text(faults_page(found), encoding="utf-8")
    failed = sum(not outcome.held for outcome in found)
    print(f"{len(found) - failed} passed, {failed} failed")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
