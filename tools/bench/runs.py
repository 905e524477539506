"""Times of the double dome: sizes and threads, what each part of it costs, and a busy machine."""

import subprocess
import sys
from contextlib import contextmanager

from bench.timing import STEPPING, interleaved, least, median

BENDING = "material.bending_stiffness=1 mN m"  # assumed, typical
# Steps near the middle of the press would need the way there: these are its first millimetres, holder and die at work. The two
# coarsest meshes go as far as each other; later more of a coarse mesh's nodes come to another facet at every step.
SIZES = ((5000, 400), (21706, 1000), (100000, 250), (400000, 70), (1000000, 25))  # elements, steps


def sized(elements, steps, threads, settings=(BENDING,)):
    return dict(case="double_dome", settings=(f"blank.elements={elements}", *settings), threads=threads, steps=steps)


def sizes(repeats):
    """Rows: elements, threads, steps, ns per element-step (least, median), its phases, bytes per element."""
    rows = []
    for elements, steps in SIZES:
        jobs = {f"{elements} elements, {threads} threads": sized(elements, steps, threads) for threads in (1, 2)}
        for threads, (name, samples) in zip((1, 2), interleaved(jobs, repeats).items()):
            best = least(samples)
            rows.append({"elements": best.summary["elements"], "threads": threads, "steps": best.summary["steps"],
                         "ns_min": best.ns, "ns_median": median(samples), "bytes": best.memory / best.summary["elements"],
                         **{f"{phase}_ns": best.phases[phase] for phase in STEPPING}})
    return rows


FEATURES = {
    "everything": (BENDING,),
    "no bending": (),
    "bending at every step: subcycling = false": (BENDING, "time.subcycling=false"),
    "no rate: law = elastic": (BENDING, "material.law=elastic"),
    "paper's law: law = incremental": (BENDING, "material.law=incremental"),
    "no strips of yarn: yarn_strain = triangle": (BENDING, "material.yarn_strain=triangle"),
    "one tool out of reach": (BENDING, 'tool.punch.position=["0 mm", "0 mm", "100 mm"]', "gates.kinetic_to_internal=1e9"),
    "quarter symmetry": (BENDING, "blank.symmetry=quarter"),
    "little output": (BENDING, "output.frames=1", "output.history=1"),
}


def features(repeats):
    """Rows: what is on, ns per element-step (least, median), ratio to everything on, and phases."""
    jobs = {name: dict(case="double_dome", settings=settings, threads=1, steps=1000) for name, settings in FEATURES.items()}
    samples = interleaved(jobs, repeats)
    everything = least(samples["everything"]).ns
    return [{"what": name, "ns_min": least(s).ns, "ns_median": median(s), "over_everything": least(s).ns / everything,
             **{f"{phase}_ns": least(s).phases[phase] for phase in (*STEPPING, "output")}} for name, s in samples.items()]


@contextmanager
def one_core_busy():
    """Another program that takes all it gets of one core."""
    other = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        yield
    finally:
        other.kill()
        other.wait()


def busy(repeats):
    """Rows: threads, with and without another program on one core: ns per element-step."""
    jobs = {f"{threads} threads": dict(case="double_dome", threads=threads, steps=1000) for threads in (1, 2)}
    idle = interleaved(jobs, repeats)
    with one_core_busy():
        loaded = interleaved(jobs, repeats)
    return [{"threads": threads, "other_programs": others, "ns_min": least(s[f"{threads} threads"]).ns,
             "ns_median": median(s[f"{threads} threads"])} for others, s in ((0, idle), (1, loaded)) for threads in (1, 2)]


def whole(repeats):
    """Rows: a whole run from start to end, seconds, with its output."""
    jobs = {f"{case}{what}, {threads} threads": dict(case=case, settings=settings, threads=threads)
            for case in ("double_dome", "hemisphere") for what, settings in (("", ()), (" with bending", (BENDING,)))
            for threads in (1, 2)}
    rows = []
    for name, s in interleaved(jobs, repeats).items():
        best = least(s)
        rows.append({"run": name, "elements": best.summary["elements"], "steps": best.summary["steps"], "ns_min": best.ns,
                     "ns_median": median(s), "wall_s_min": min(x.wall for x in s),
                     **{f"{phase}_ns": best.phases[phase] for phase in (*STEPPING, "output")}})
    return rows
