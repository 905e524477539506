"""Load: load_test.py TOWFORM DIR; see scripts/load-test."""

import concurrent.futures
import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import h5py

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
CASES = Path(__file__).resolve().parent.parent / "cases"
INTERRUPTED = 75
# Without frames the state, the model and a checkpoint of a sheet are below this.
BYTES_PER_ELEMENT = 3000


def towform(*arguments):
    """Runs the program; its exit code and the most memory it had [bytes]."""
    child = subprocess.Popen([PROGRAM, *map(str, arguments), "--quiet"], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, 1024 * usage.ru_maxrss


def need(ok, what):
    print(("good: " if ok else "BAD:  ") + what, flush=True)
    return ok


def million(elements=1_000_000, steps=1000):
    out = FOLDER / "million"
    code, memory = towform("run", CASES / "double_dome.toml", "-o", out, "--force", "--set", f"blank.elements={elements}",
                           "--max-steps", steps)
    summary = json.loads((out / "summary.json").read_text())
    with h5py.File(out / "results.h5", "r") as file:
        frames = len(file["frames"])
    shutil.rmtree(out)
    per_element = memory / summary["elements"]
    return need(code == INTERRUPTED and summary["steps"] == steps and frames >= 1 and per_element < BYTES_PER_ELEMENT,
                f"{summary['elements']} elements, {summary['steps']} steps in {summary['wall_time_s']:.0f} s with "
                f"{summary['threads']} threads, {memory / 2**30:.2f} GiB at most, {per_element:.0f} bytes an element")


def queue(runs=24, at_once=2):
    """Runs of three kinds, each kind to the same bytes."""
    strokes = (10, 11, 12)

    def one(number):
        out = FOLDER / f"queue_{number}"
        code, _ = towform("run", CASES / "hemisphere.toml", "-o", out, "--force", "--threads", 1, "--set",
                          "blank.elements=1000", "--set", f"tool.punch.motion.displacement=-{strokes[number % 3]} mm", "--set",
                          "time.end=10 ms")
        digest = hashlib.sha256((out / "history.csv").read_bytes() + (out / "results.h5").read_bytes()).hexdigest()
        shutil.rmtree(out)
        return code, digest

    with concurrent.futures.ThreadPoolExecutor(at_once) as pool:
        done = list(pool.map(one, range(runs)))
    same = all(done[i] == done[i % 3] for i in range(runs))
    return need(same and all(code == 0 for code, _ in done) and len(set(done)) == 3,
                f"{runs} runs, {at_once} at a time: {sum(code == 0 for code, _ in done)} ended with 0, "
                f"{len(set(done))} different answers of {len(strokes)} different strokes")


def frames(count=200):
    """A frame has 44 bytes a node and 68 an element (docs/reliability.md), the mesh 24 and 12."""
    out = FOLDER / "frames"
    code, _ = towform("run", CASES / "hemisphere.toml", "-o", out, "--force", "--set", "blank.elements=5000", "--set",
                      "tool.punch.motion.displacement=-5 mm", "--set", "time.end=5 ms", "--set", f"output.frames={count}")
    with h5py.File(out / "results.h5", "r") as file:
        nodes, elements, held = len(file["mesh/reference"]), len(file["mesh/triangles"]), len(file["frames"])
    predicted = (count + 1) * (44 * nodes + 68 * elements) + 24 * nodes + 12 * elements
    size = (out / "results.h5").stat().st_size
    shutil.rmtree(out)
    return need(code == 0 and held == count + 1 and abs(size / predicted - 1.0) < 0.1,
                f"{held} frames of {elements} elements: {size / 1e6:.1f} MB, predicted {predicted / 1e6:.1f} MB, "
                f"{100 * (size / predicted - 1.0):+.1f} %")


FOLDER.mkdir(parents=True, exist_ok=True)
results = [million(), queue(), frames()]
FOLDER.rmdir()
sys.exit(0 if all(results) else 1)
