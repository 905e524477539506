"""One run of a study, as Snakemake starts it: one_run PROGRAM DIR --threads N --attempt K --attempts MOST.

Runs DIR/case.toml into DIR, or goes on from its checkpoint; however it ends for good, DIR/status.json says so (exit code
and reason) and this process ends well, so that the other runs go on. A run that was interrupted has no status, and ends
with 75: Snakemake starts it again, or the next call of the study does. One killed in its last attempt counts as failed.
"""

import argparse
import ctypes
import fcntl
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from .files import read_json, replace_json
from .problems import INTERRUPTED

CHECKPOINT = 7  # exit code: one that cannot be gone on from
PR_SET_PDEATHSIG = 1


def has_ended(directory):
    return (Path(directory) / "status.json").exists()


def can_resume(directory):
    return any((directory / name).exists() for name in ("checkpoint.h5", "checkpoint.previous.h5"))


def is_done(directory):
    """The results are whole, though nobody lived to say so."""
    summary = read_json(directory / "summary.json") or {}
    return summary.get("status") == "done" and not can_resume(directory)


class Run:
    def __init__(self, arguments):
        self.program, self.directory = arguments.program, Path(arguments.directory)
        self.threads, self.last = arguments.threads, arguments.attempt >= arguments.attempts
        self.child, self.signals = None, []

    def start(self, *words):
        """Exit code of towform, negative when a signal ended it, and the last it said."""
        words = [self.program, *words, "--threads", str(self.threads), "--quiet"]
        libc = ctypes.CDLL(None)
        note(self.directory, starts=words[1])
        self.child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                      text=True, start_new_session=True,  # signals come by way of this process
                                      preexec_fn=lambda: libc.prctl(PR_SET_PDEATHSIG, signal.SIGTERM))
        if self.signals:  # came before the child was there
            self.child.send_signal(signal.SIGTERM)
        said = self.child.communicate()[1]
        note(self.directory, ends=self.child.returncode)
        return self.child.returncode, said.strip()

    def pass_on(self, number, _):
        self.signals.append(number)
        if self.child is not None and self.child.poll() is None:
            self.child.send_signal(signal.SIGTERM)

    def go(self):
        """Exit code of this process."""
        started = time.time()
        if is_done(self.directory):
            code, said = 0, ""
        elif can_resume(self.directory):
            code, said = self.start("resume", self.directory)
            if code == CHECKPOINT:
                code, said = self.fresh()
        else:
            code, said = self.fresh()
        if code == INTERRUPTED or (code < 0 and (self.signals or not self.last)):
            how = f"killed by {signal.Signals(-code).name}" if code < 0 else "interrupted"
            print(f"{self.directory}: {said or how}", file=sys.stderr)
            return INTERRUPTED
        reason = reason_of(code, said)
        replace_json(self.directory / "status.json",
                     {"exit_code": code, "reason": reason, "ended": round(time.time(), 3),
                      "seconds": round(time.time() - started, 3)})
        return 0

    def fresh(self):
        return self.start("run", self.directory / "case.toml", "-o", self.directory, "--force")


def reason_of(code, said):
    if code == 0:
        return ""
    if code < 0:
        return f"killed by {signal.Signals(-code).name} in every attempt" + (
            "; was there enough memory?" if -code == signal.SIGKILL else "")
    lines = [line.removeprefix("towform: ") for line in said.splitlines() if line.strip()]
    return "; ".join(lines)[:2000] or f"ended with exit code {code} without a word"


def note(directory, **what):
    """A line in attempts.jsonl: what was started, and how it ended."""
    with open(directory / "attempts.jsonl", "a") as file:
        file.write(json.dumps({"time": round(time.time(), 3), "host": os.uname().nodename, **what}) + "\n")


def attempts_of(directory):
    """How often towform was started for this run."""
    try:
        lines = (Path(directory) / "attempts.jsonl").read_text().splitlines()
    except FileNotFoundError:
        return 0
    return sum('"starts"' in line for line in lines)


def main():
    parser = argparse.ArgumentParser(prog="one_run")
    parser.add_argument("program")
    parser.add_argument("directory")
    for name in ("threads", "attempt", "attempts"):
        parser.add_argument(f"--{name}", type=int, default=1)
    run = Run(parser.parse_args())
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
        signal.signal(number, run.pass_on)
    # One that was left behind by a study that was killed may still be at it: then this waits, and finds it done.
    with open(run.directory / ".study.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        code = 0 if has_ended(run.directory) else run.go()
        if code == 0:
            (run.directory / "ended").touch()
    return code


if __name__ == "__main__":
    sys.exit(main())
