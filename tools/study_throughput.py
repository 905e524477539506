"""study_throughput.py TOWFORM DIR [REPEATS]: runs an hour with one thread a run, as many runs at a time as there are cores,
over those with all cores for one run after the other. Both are timed in turn, so that what else the machine does meets
both; prints the minimum, the median and the maximum of the ratio for two sizes of the sheet."""

import concurrent.futures
import os
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

PROGRAM, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
REPEATS = int(sys.argv[3]) if len(sys.argv) > 3 else 5
CASE = Path(__file__).resolve().parent.parent / "cases" / "hemisphere.toml"
CORES = len(os.sched_getaffinity(0))
SIZES = {1600: 1000, 14400: 100}  # elements of the whole sheet, of which a quarter is modelled: steps
STOPPED = 75  # by --max-steps


def run(number, elements, steps, threads):
    words = [PROGRAM, "run", CASE, "--set", 'blank.symmetry="quarter"', "--set", f"blank.elements={elements}", "--max-steps", steps,
             "--threads", threads, "-o", FOLDER / str(number), "--force", "--quiet"]
    code = subprocess.run(list(map(str, words)), stderr=subprocess.DEVNULL).returncode
    if code != STOPPED:
        sys.exit(f"towform ended with {code}")


def seconds(elements, steps, threads):
    """Of two runs for every core."""
    start = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(CORES // threads) as pool:
        list(pool.map(lambda number: run(number, elements, steps, threads), range(2 * CORES)))
    return time.monotonic() - start


def main():
    for elements, steps in SIZES.items():
        ratios = []
        for _ in range(REPEATS):
            one = seconds(elements, steps, 1)
            ratios.append(seconds(elements, steps, CORES) / one)
        shown = " / ".join(f"{ratio:.2f}" for ratio in (min(ratios), statistics.median(ratios), max(ratios)))
        print(f"{elements:6d} elements (a quarter modelled): one thread a run gives {shown} times the runs of {CORES} threads a run "
              f"(min / median / max of {REPEATS})", flush=True)
    shutil.rmtree(FOLDER)


main()
