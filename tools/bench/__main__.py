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

**Speed.** The aim is 20 ns on one thread and 11 on two with everything on, and 3 s for the paper's run. Arithmetic alone would take
{arithmetic} ns on this machine. Everything on takes {one} ns on one thread and {two} on two in the first millimetres of the press,
{press_one} and {press_two} over all of it, and the paper's run {wall} s without bending, {wall_bending} s with it, of which set-up and output
are {beside} s; the report, not counted here, takes a few tenths more. It takes {steps} steps, where the paper took 12,000. A program before
this one, with 3,147 steps, took 2.7 to 3.7 s in turn with this one's 2.6 to 3.4 (medians 2.8 and 2.75: the machine swings by
a third). The stable step counts a second tool only where one touches, history rows need no steps of their own, and blocks are
twice as large, so that strips reach into fewer others. Of a step without
bending {membrane} % are the membrane, of which vectors do half and gathering, scattering and strips of yarn the rest; {contact} % are contact.
Bending, held for up to eight steps, is {held} ns of {everything}; computed at every step it is {each_step}. Single precision in the membrane's
geometry was tried and brought 3 % of it, loads of nodes in rows made it slower, and huge pages brought nothing. On an AMD EPYC (51 Gflop/s
and 22 GB/s a thread, 10 ns of arithmetic) an earlier program took 35 and 17 ns, and 3.6 s for the paper's run in 6,649 steps.

**Sizes.** The aim is within 20 % of the middle from 5,000 to 1,000,000 elements: it is {spread_one} % on one thread, {spread_two} % on two. Steps
fall with the edge alone: 22.0 us of 21,672 elements, 3.2 of 999,600, without bending. What
elements of one shape are made of they share, so that the membrane costs a fine mesh hardly more than one that lies in the cache; what does
cost more there is bending, whose waves are so fast that its forces can hardly be held. Nodes of a regular mesh bend side by side, in vectors.

**Memory.** The aim is 400 bytes an element. An element more of a fine mesh takes {more}; with the program, its libraries and the
tools, {alone} MB, it is {all_bytes} at {largest} elements. These are first steps; later, whenever the stable step is measured again, some 60
more are needed for a moment (counted).

**Error.** The aim is 1 degree RMS in 2 s: the double dome takes {good_dome} s, the hemisphere {good_hemisphere} s (below). At the real speed of the
press four times the mass halves the time and moves angles by less than the mesh does (RMS); ten times the mass, `towform run --fast`, is the
better way to save time than a coarser mesh. Both change forces. Defaults are the case's own mass and speed.
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
    pareto.plot(page.read_table("pareto"), ROOT / "docs/images/pareto.png")
    page.write(TEXT)
    print(f"wrote {page.PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
