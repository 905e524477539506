"""Times of single kernels (tests/bench/kernels.cpp, Google Benchmark) and what the machine can do."""

import json
import subprocess

from verification.runs import ROOT

PROGRAM = ROOT / "build/release/tests/bench/towform_bench"


def kernels(repeats):
    """Rows: kernel, least and median of the repeats, and the unit."""
    done = subprocess.run([PROGRAM, f"--benchmark_repetitions={repeats}", "--benchmark_min_time=0.2", "--benchmark_format=json"],
                          capture_output=True, text=True, check=True)
    found = {}
    for run in json.loads(done.stdout)["benchmarks"]:
        if run["run_type"] == "iteration":
            found.setdefault(run["run_name"], []).append(run)
    rows = []
    for name, runs in found.items():
        if "bytes_per_second" in runs[0]:
            unit, values = "GB/s", sorted((run["bytes_per_second"] / 1e9 for run in runs), reverse=True)
        elif "flops" in runs[0]:
            unit, values = "Gflop/s", sorted((run["flops"] / 1e9 for run in runs), reverse=True)
        elif "ns_per_item" in runs[0]:
            unit, values = "ns per node" if name == "contact" else "ns per element", sorted(run["ns_per_item"] for run in runs)
        else:
            unit, values = "ns", sorted(run["real_time"] for run in runs)
        rows.append({"kernel": name.replace("/20000", ""), "best": values[0], "median": values[len(values) // 2], "unit": unit})
    return rows
