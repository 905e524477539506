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

**Speed.** The aim is 20 ns on one thread and 11 on two with everything on, and 3 s for the paper's run. It is not reached on this machine,
where arithmetic alone would take 10 ns: everything on takes 35 ns on one thread and 17 on two in the first millimetres of the press,
41 and 22 over all of it, and the paper's run 3.6 s without bending, 4.1 s with it, of which set-up and output are 0.7 s; the report, not
counted here, takes 0.3 s more. It takes 6,650 steps, 0.97 of the true limit with contact, where the paper took 12,000. Half of a step is the
membrane, of which vectors do half and gathering, scattering and strips of yarn the rest; over the whole press more than two fifths are
contact. Bending, held for up to eight steps, is 3 ns of 35; computed at every step it is 16. Single precision in the
membrane's geometry was tried and brought 3 % of it, loads of nodes in rows made it slower: what limits it is not arithmetic.
From 5,000 to 100,000 elements an element costs within 19 % of the middle of them on one thread, 25 % on two; from 400,000 on the sheet is read
from memory, and its waves of bending are so fast that it is computed every second or third step: 25 % more than the middle of all sizes on
one thread, 32 % on two.
Memory is 0.5 kB an element of a fine mesh, beside some 60 MB for the program and the tools (0.57 with these).

**Error.** The aim is 1 degree RMS in 2 s: the double dome takes 0.6 s, the hemisphere 0.5 s (below). At the real speed of the press four times
the mass halves the time and moves angles by less than the mesh does (RMS); ten times the mass, `towform run --fast`, is the better way to save
time than a coarser mesh. Both change forces. Defaults are the case's own mass and speed.
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
