"""Times runs of the program: what a run of so many steps says of itself in summary.json."""

import json
import os
import statistics
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from verification.runs import PROGRAM, ROOT

STEPPING = ("advance", "membrane", "assembly", "bending", "contact", "stable_step")


@dataclass(frozen=True)
class Sample:
    """One run: [ns per element-step], whole and by phase, [s] from start to end, its summary, and the most memory it had [bytes]."""

    ns: float
    phases: dict
    wall: float
    summary: dict
    memory: int


def run_once(case, settings=(), threads=1, steps=None, directory=None):
    """Runs a case, whole or for its first steps. Raises RuntimeError with what the program says when it fails."""
    with tempfile.TemporaryDirectory(prefix="towform_bench_") as scratch:
        out = Path(directory or scratch) / "run"
        command = [PROGRAM, "run", ROOT / "cases" / f"{case}.toml", "-o", out, "--force", "--quiet", "--threads", str(threads)]
        command += [word for s in ("output.report=false", *settings) for word in ("--set", s)]
        if steps:
            command += ["--max-steps", str(steps)]
        said = Path(scratch) / "said.txt"
        with open(said, "w") as file:
            child = subprocess.Popen(command, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in (0, 75):
            raise RuntimeError(f"{' '.join(map(str, command))}: exit code {child.returncode}: {said.read_text()}")
        summary = json.loads((out / "summary.json").read_text())
    element_steps = summary["elements"] * summary["steps"]
    phases = {name: 1e9 * seconds / element_steps for name, seconds in summary["phases_s"].items()}
    return Sample(summary["ns_per_element_step"], phases, summary["wall_time_s"], summary, 1024 * usage.ru_maxrss)


def interleaved(jobs, repeats):
    """Samples of several jobs (name -> arguments of run_once), taken in turn, so that a busy spell meets all of them."""
    samples = {name: [] for name in jobs}
    for _ in range(repeats):
        for name, arguments in jobs.items():
            samples[name].append(run_once(**arguments))
            print(f"  {name}: {samples[name][-1].ns:.1f} ns per element-step", flush=True)
    return samples


def least(samples):
    return min(samples, key=lambda s: s.ns)


def median(samples):
    return statistics.median(s.ns for s in samples)


def machine():
    """Processor and cores, for the tables."""
    name = "unknown processor"
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            name = line.split(":", 1)[1].strip()
            break
    return f"{name}, {os.cpu_count()} cores"
