"""scripts/bench: see there."""

import argparse

from bench import page, pareto
from bench.kernels import kernels
from bench.runs import busy, features, sizes, whole
from verification.runs import ROOT

TEXT = """# Benchmarks

Written by `scripts/bench`, on {machine}; the tables are beside this page (`docs/benchmarks/*.csv`). Times are the least of several
runs taken in turn, with the median beside: machines are shared, and the least is what the program itself needs. Where the median is much larger,
others were at work. `ns_per_element_step` of `summary.json` is the wall time of the stepping loop with contact and all that the scene has,
without set-up and file output, over elements and steps.

The aim is 20 ns on one thread and 11 on two with everything on, and 3 s for the paper's run. It is not reached: of a whole run the membrane takes
20 ns, a third of it arithmetic and gathering, scattering and strips of yarn the rest; contact 15, half of it the search for nodes that slide over
edges; bending 13. The stable step is measured and no longer bounded: the paper's run takes 7,854 steps, and 5.9 s on two threads.

The table of run time against error was measured with an older program, whose steps were 1.37 times as many; all others are of the present one,
on a machine whose speed changed by a third while they were made.
"""
PARTS = {"kernels": kernels, "whole": whole, "runs": sizes, "features": features, "busy": busy}


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench", description="Measures towform's speed and writes docs/benchmarks.md.")
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join((*PARTS, 'pareto', 'page'))} (default: all)")
    parser.add_argument("--repeats", type=int, default=5, help="of every measurement (default: 5)")
    options = parser.parse_args()
    unknown = [p for p in options.parts if p not in (*PARTS, "pareto", "page")]
    if unknown:
        parser.error(f"unknown part {unknown[0]}")
    wanted = options.parts or [*PARTS, "pareto"]
    for name, measure in PARTS.items():
        if name in wanted:
            print(name, flush=True)
            page.write_table(name, measure(options.repeats))
    if "pareto" in wanted:
        rows = [row for case in pareto.CASES for row in pareto.measure(case, min(options.repeats, 2))]
        page.write_table("pareto", rows)
        page.write_table("convergence", [row for case in pareto.CASES for row in pareto.convergence(case)])
    if page.read_table("pareto"):
        pareto.plot(page.read_table("pareto"), ROOT / "docs/images/pareto.png")
    page.write(TEXT)
    print(f"wrote {page.PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
