"""One call of the pipeline at a time in a tree: two would delete each other's results.

Snakemake's own locks do not do it: a call drops those of all others when it ends, and they outlive a call
that was killed. This one is of the operating system and ends with the process that holds it.
"""

import fcntl
import json
import os
import re
import shlex
import time
from pathlib import Path

#: Options of Snakemake with which nothing is run or written.
ONLY_LOOKING = {"--dry-run", "--dryrun", "--unlock", "--lint", "--summary", "--detailed-summary", "--list"}
ONLY_LOOKING |= {"--list-rules", "--dag", "--rulegraph", "--filegraph", "--d3dag", "--list-target-rules"}


class Busy(Exception):
    """Another call works in this tree: who, and since when."""


def only_looks(words):
    """Does a command line of Snakemake run nothing?"""
    return any(word in ONLY_LOOKING or re.fullmatch(r"-[a-zA-Z]*n[a-zA-Z]*", word) for word in words)


def taken(path, words):
    """The open file whose lock this process now holds; a Busy that names the holder if it is held."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    file = path.open("a+", encoding="utf-8")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.seek(0)
        holder = file.read()
        file.close()
        raise Busy(busy(holder)) from None
    file.truncate(0)
    holder = {
        "process": os.getpid(),
        "since": time.strftime("%Y-%m-%d %H:%M:%S"),
        "command": shlex.join(words),
    }
    file.write(json.dumps(holder))
    file.flush()
    return file


def busy(holder):
    """What the second call is told."""
    try:
        told = json.loads(holder)
        who = f"process {told['process']} since {told['since']} ({told['command']})"
    except (ValueError, KeyError):
        who = "another process"
    return f"another call works in this tree: {who}. Wait until it ends, or end it, and start again."
