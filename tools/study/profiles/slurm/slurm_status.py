#!/usr/bin/env -S /usr/bin/python3 -B
"""slurm_status.py JOB: prints running, success or failed, as Snakemake asks; needs no accounting database.

squeue and scontrol know a job while it is there and for some minutes after (MinJobAge); sacct, where there is accounting,
knows it for good. A job that nobody knows any more has ended, and its run has written how: that the output is there is
for Snakemake to see.
"""

import re
import subprocess
import sys
import time

RUNNING = {"PENDING", "CONFIGURING", "RUNNING", "COMPLETING", "SUSPENDED", "REQUEUED", "RESIZING", "STAGE_OUT", "SIGNALING"}
TRIES, WAIT = 5, 2.0  # a controller that is restarted or busy answers again [s]


def asked(*words):
    """(went well, what it said) of a command of Slurm."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as e:
        return False, str(e)
    return done.returncode == 0, done.stdout if done.returncode == 0 else done.stderr


def state_of(job):
    """The state's name, "" when the job is not known any more; None when Slurm does not answer."""
    well, said = asked("scontrol", "--oneliner", "show", "job", job)
    if well:
        match = re.search(r"\bJobState=([A-Z_]+)", said)
        return match[1] if match else None
    unknown = "Invalid job id" in said
    well, said = asked("sacct", "--jobs", job, "--format", "State", "--noheader", "--parsable2", "--allocations")
    if well and said.strip():
        return said.split()[0].rstrip("+")
    return "" if unknown else None


def main(job):
    for _ in range(TRIES):
        state = state_of(job)
        if state is not None:
            return "running" if state in RUNNING else "success" if state in ("COMPLETED", "") else "failed"
        time.sleep(WAIT)
    return "running"  # nobody answers: ask again later


if __name__ == "__main__":
    print(main(sys.argv[1]))
