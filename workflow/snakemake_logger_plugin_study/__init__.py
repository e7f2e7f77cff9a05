"""Logger of Snakemake that says in a line a minute how far the study is and when it ends (`--logger study`).

Snakemake's own lines go to its log below .snakemake/log alone. Failures are told at once, with the end of the
log of the job.
"""

import sys
import time
from pathlib import Path
from threading import Event, Thread

from snakemake_interface_logger_plugins.base import LogHandlerBase
from snakemake_interface_logger_plugins.common import LogEvent
from study.planning.progress import CURRENT, PLAN, described, duration

EVERY_S = 60
SHOWN = 15  # last lines of the log of a failed job
NOTHING, DRY = "Nothing to be done", "This was a dry-run"


def clock(moment):
    """Hours and minutes of a moment, with the day if it is another one."""
    when, today = time.localtime(moment), time.localtime()
    return time.strftime("%H:%M" if when.tm_yday == today.tm_yday else "%a %H:%M", when)


def say(text):
    """One line for people."""
    print(text, file=sys.stderr, flush=True)


class LogHandler(LogHandlerBase):
    """Turns the events of Snakemake into the words of study.planning.progress."""

    writes_to_stream = True
    writes_to_file = False
    has_filter = True
    has_formatter = True
    needs_rulegraph = False

    def __post_init__(self):
        self.over, self.said = Event(), False
        Thread(target=self.tell, daemon=True).start()

    def tell(self):
        """The line of every minute while jobs run."""
        while not self.over.wait(EVERY_S):
            if CURRENT.running():
                say(CURRENT.line(time.time(), clock))

    def close(self):
        self.over.set()
        super().close()

    def emit(self, record):
        event, text = getattr(record, "event", None), str(record.msg)
        if event == LogEvent.JOB_INFO:
            self.started(record)
        elif event == LogEvent.JOB_FINISHED:
            CURRENT.finish(record.job_id, time.time())
        elif event == LogEvent.JOB_ERROR:
            self.failed(record)
        elif event in (None, LogEvent.ERROR):
            self.plain(record, text)

    def started(self, record):
        """A job begins, or in a dry run would begin."""
        wildcards = dict(record.wildcards or {})
        CURRENT.add(record.jobid, described(record.rule_name, wildcards, PLAN, record.threads or 1))
        if self.common_settings.dryrun:
            return
        if not self.said:
            self.said = True
            say(f"{sum(CURRENT.total.values())} jobs, {duration(CURRENT.left(time.time()))} in all")
        CURRENT.start(record.jobid, time.time())
        if record.rule_name == "build":
            say("building the solver: two to five minutes, once")

    def failed(self, record):
        """A job failed: which one, and the end of its log."""
        job = CURRENT.jobs.pop(record.jobid, None)
        say(f"FAILED: {job.name if job else record.rule_name} (rule {record.rule_name})")
        for log in map(Path, record.log or []):
            if log.exists():
                lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
                say("\n".join([f"  the end of {log}:", *(f"    {line}" for line in lines[-SHOWN:])]))

    def plain(self, record, text):
        """Errors, and the two messages that end a call without jobs."""
        if text.startswith(NOTHING) and self.common_settings.quiet:
            pass
        elif text.startswith(NOTHING):
            say(f"{NOTHING}: all results are there")
        elif text.startswith(DRY):
            say("\n".join(CURRENT.table()))
        elif record.levelname in ("ERROR", "CRITICAL") and not text.startswith("RuleException"):
            say(record.getMessage())
