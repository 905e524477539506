"""Forms the trials, a few at a time, each on one thread and within a time."""

import hashlib
import json
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from stress.meshes import write_blank, write_sliver_tool
from stress.trials import SCENES, TOOLS
from verification.runs import PROGRAM, ROOT, shell_word

QUARTER = {"hemisphere": ((150.0, 150.0), (14, 14)), "double_dome": ((325.0, 225.0), (22, 15))}  # mm, squares


@dataclass
class Formed:
    directory: Path
    code: int | None  # of the program; None when it did not end in time
    said: str  # on standard error and output


def settings(trial):
    own = "".join(trial.settings)
    part = () if "blank.symmetry" in own else ("blank.symmetry=quarter",)
    edge = () if trial.blank or "blank.elements" in own else (f"blank.elements={SCENES[trial.scene]}",)
    return (*part, *edge, *trial.settings)


def command(trial):
    """As a user types it; `blank.msh` and `tools/` are what the suite writes into the trial's directory."""
    case = f"cases/{trial.scene}.toml"
    words = " ".join(f"--set {shell_word(s)}" for s in settings(trial))
    return f"towform run {case} --threads 1 {words}"


def prepare(trial, directory):
    """The case file of a trial, with the meshes that it needs beside it."""
    case = ROOT / "cases" / f"{trial.scene}.toml"
    if not trial.blank and not trial.tools:
        return case
    lines = case.read_text()
    if trial.blank:
        write_blank(directory / "blank.msh", *trial.blank, *QUARTER[trial.scene])
        lines = "\n".join(line for line in lines.replace("[blank]", "[blank]\nmesh = \"blank.msh\"\nmesh_unit = \"mm\"").splitlines()
                          if not line.startswith(("size = ", "elements = ")))
    if trial.tools:
        (directory / "meshes").mkdir(exist_ok=True)
        for tool in TOOLS:
            name = f"meshes/{trial.scene}_{tool}.stl"
            write_sliver_tool(ROOT / name, directory / name, trial.tools)
    (directory / "case.toml").write_text(lines)
    return directory / "case.toml"


def form(trial, base, seconds):
    """A trial that `base` holds already, by the same program, is not formed again."""
    directory = base / trial.name
    directory.mkdir(parents=True, exist_ok=True)
    words = [word for s in settings(trial) for word in ("--set", s)]
    results = directory / "out"
    note = directory / "formed.json"
    stamp = [hashlib.sha256(Path(PROGRAM).read_bytes()).hexdigest(), repr(trial)]
    if note.exists() and (known := json.loads(note.read_text()))["stamp"] == stamp:
        return Formed(results, known["code"], known["said"])
    call = [PROGRAM, "run", prepare(trial, directory), "-o", results, "--force", "--threads", "1", *words]
    try:
        done = subprocess.run(call, cwd=ROOT, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired as late:
        return Formed(results, None, f"not done after {late.timeout:.0f} s")
    formed = Formed(results, done.returncode, done.stderr + done.stdout)
    note.write_text(json.dumps({"stamp": stamp, "code": formed.code, "said": formed.said}))
    return formed


def form_all(trials, base, seconds, jobs):
    """(trial, Formed) in the order of the trials."""
    with ThreadPoolExecutor(jobs) as pool:
        waiting = [pool.submit(form, t, Path(base), seconds) for t in trials]
        for trial, future in zip(trials, waiting):
            yield trial, future.result()
