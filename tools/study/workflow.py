"""Hands the runs of a study to Snakemake and waits for them."""

import ctypes
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

from .files import read_json, replace_file
from .one_run import PR_SET_PDEATHSIG
from .problems import FILES, INTERRUPTED, Refused

STOPPING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
ATTEMPTS = 4  # of a run that is killed or interrupted, before the next call of the study
TOOLS = Path(__file__).resolve().parent.parent

SNAKEFILE = """# Written by `towform study`, which starts it; by hand: snakemake --cores 2 --rerun-triggers mtime --keep-going
import json

manifest = json.load(open("manifest.json"))
RUNS = [run["name"] for run in manifest["runs"]]
STUDY = {command!r}

localrules: all, table, report

# The runs are named too: a study that was stopped has a table and a report of what it had.
rule all:
    input: expand("runs/{{run}}/ended", run=RUNS), "report.html"

# Ends well however the run ended, unless it was interrupted: then it is tried again, from its checkpoint.
rule run:
    input: "runs/{{run}}/case.toml"
    output: "runs/{{run}}/ended"
    threads: manifest["threads"]
    retries: {retries}
    resources: attempt=lambda wildcards, attempt: attempt
    params: program=manifest["program"], attempts={attempts}
    shell:
        STUDY + "one_run {{params.program:q}} runs/{{wildcards.run}} --threads {{threads}} --attempt {{resources.attempt}} "
        "--attempts {{params.attempts}}"

rule table:
    input: "manifest.json", expand("runs/{{run}}/ended", run=RUNS)
    output: "table.csv", "table.h5"
    shell: STUDY + "table ."

rule report:
    input: "table.csv"
    output: "report.html"
    shell: STUDY + "report ."
"""


def write_snakefile(directory):
    command = f"PYTHONPATH={shlex.quote(str(TOOLS))} /usr/bin/python3 -B -m study."
    replace_file(directory / "Snakefile", SNAKEFILE.format(command=command, attempts=ATTEMPTS, retries=ATTEMPTS - 1))


def profile_folder(name):
    """The folder of a profile: one of ours by its name, or a path. Raises Refused."""
    ours = Path(__file__).resolve().parent / "profiles"
    names = sorted(folder.name for folder in ours.iterdir() if folder.is_dir())
    folder = ours / name if name in names else Path(name)
    if not (folder / "config.yaml").is_file():
        raise Refused(f"towform: --profile {name}: is neither {' nor '.join(names)} nor a folder with a config.yaml", FILES)
    return folder.resolve()


def _command(manifest, profile, jobs):
    words = ["/usr/bin/python3", "-m", "snakemake", "--snakefile", "Snakefile", "--nolock", "--keep-going", "--rerun-incomplete",
             "--rerun-triggers", "mtime", "--scheduler", "greedy", "--nocolor"]
    if profile is not None:
        return [*words, "--profile", str(profile), "--jobs", str(jobs or 100)]
    cores = len(os.sched_getaffinity(0))
    return [*words, "--cores", str((jobs or max(1, cores // manifest.threads)) * manifest.threads)]


class Progress:
    """Tells of runs as they end."""

    def __init__(self, manifest, quiet):
        self.manifest, self.quiet = manifest, quiet
        self.started = time.monotonic()
        self.ended = set(run.name for run in manifest.runs if self._status(run) is not None)

    def _status(self, run):
        return read_json(self.manifest.folder(run) / "status.json")

    def look(self):
        total = len(self.manifest.runs)
        for run in self.manifest.runs:
            if run.name in self.ended:
                continue
            status = self._status(run)
            if status is None:
                continue
            self.ended.add(run.name)
            if self.quiet:
                continue
            how = "done" if status["exit_code"] == 0 else f"FAILED ({status['exit_code']}): {status['reason']}"
            values = ", ".join(f"{p.name} = {p.shown(run.values[p.name])}" for p in self.manifest.parameters)
            print(f"{len(self.ended):5d} of {total}  run {run.name}  {values}: {how}", flush=True)


def run_all(manifest, held, profile=None, jobs=0, quiet=False):
    """Runs what has not ended yet. Returns 0, or 75 when a signal stopped the study. Raises Refused when Snakemake itself
    fails. `held` is the file that locks the directory; Snakemake holds it too, for as long as it lives."""
    write_snakefile(manifest.directory)
    progress = Progress(manifest, quiet)
    log_path = manifest.directory / "snakemake.log"
    signals = []
    earlier = {number: signal.signal(number, lambda n, _: signals.append(n)) for number in STOPPING}
    libc = ctypes.CDLL(None)
    try:
        with open(log_path, "a") as log:
            log.write(f"\n--- {time.strftime('%Y-%m-%d %H:%M:%S')}\n")
            log.flush()
            environment = {**os.environ, "XDG_CACHE_HOME": str(manifest.directory / ".snakemake" / "cache")}
            child = subprocess.Popen(_command(manifest, profile, jobs), cwd=manifest.directory, env=environment,
                                     stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True,
                                     pass_fds=[held.fileno()],
                                     preexec_fn=lambda: libc.prctl(PR_SET_PDEATHSIG, signal.SIGINT))
            told = 0
            while child.poll() is None:
                if len(signals) > told:  # runs write their checkpoints
                    told = len(signals)
                    os.killpg(child.pid, signal.SIGINT if told == 1 else signal.SIGTERM)
                    if not quiet:
                        print("stopping: runs write their checkpoints", file=sys.stderr, flush=True)
                progress.look()
                time.sleep(0.2)
            progress.look()
    finally:
        for number, handler in earlier.items():
            signal.signal(number, handler)
    if signals:
        return INTERRUPTED
    at_all = any((manifest.folder(run) / "attempts.jsonl").exists() for run in manifest.runs)
    if child.returncode != 0 and (not at_all or len(progress.ended) == len(manifest.runs)):
        tail = "\n".join(log_path.read_text().splitlines()[-12:])
        raise Refused(f"towform: Snakemake ended with code {child.returncode}; {log_path} ends\n{tail}", FILES)
    return 0
