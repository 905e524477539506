"""Writes docs/benchmarks.md and the tables beside it."""

import csv

from bench.pareto import SPRINGS, front
from bench.timing import STEPPING, machine
from verification.runs import ROOT

DIRECTORY = ROOT / "docs/benchmarks"
PAGE = ROOT / "docs/benchmarks.md"


def write_table(name, rows):
    DIRECTORY.mkdir(exist_ok=True)
    with open(DIRECTORY / f"{name}.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows({key: f"{v:.4g}" if isinstance(v, float) else v for key, v in row.items()} for row in rows)


def read_table(name):
    with open(DIRECTORY / f"{name}.csv", newline="") as file:
        return [{key: number(v) for key, v in row.items()} for row in csv.DictReader(file)]


def number(text):
    try:
        return int(text)
    except ValueError:
        try:
            return float(text)
        except ValueError:
            return text


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def phases(row, names=STEPPING):
    return [f"{row[f'{name}_ns']:.1f}" for name in names]


BYTES_MOVED, FLOPS = 650.0, 530.0  # of an element and step: counted by hand from src/element and src/contact


def peak_share(kernels):
    """What the step would take if it did nothing but read and write its data once, or nothing but calculate."""
    peak = {row["kernel"]: row["best"] for row in kernels}
    return (f"An element and step read and write some {BYTES_MOVED:.0f} bytes and make some {FLOPS:.0f} additions and "
            f"multiplications (counted by hand, bending included). The machine streams {peak['memory_triad']:.0f} GB/s from memory and "
            f"makes {peak['arithmetic']:.0f} Gflop/s on one thread (not fused), which allows {BYTES_MOVED / peak['memory_triad']:.0f} ns of a sheet that "
            f"lies in memory and {FLOPS / peak['arithmetic']:.0f} ns of arithmetic alone.")


def memory(runs):
    """What an element more takes of memory, from the two finest meshes on one thread, and what is left of the finest [bytes]."""
    coarser, finer = [(r["elements"], r["elements"] * r["bytes"]) for r in runs if r["threads"] == 1][-2:]
    each = (finer[1] - coarser[1]) / (finer[0] - coarser[0])
    return each, finer[1] - each * finer[0]


def spread(runs, threads):
    """How far the dearest and the cheapest of all sizes are from the middle between them [%]."""
    ns = [r["ns_min"] for r in runs if r["threads"] == threads]
    return 100.0 * (max(ns) - min(ns)) / (max(ns) + min(ns))


def facts(kernels, runs, features, whole, pareto):
    """What the text tells of the tables."""
    paper = {r["threads"]: r["ns_min"] for r in runs if 20000 < r["elements"] < 25000}
    press = {r["run"]: r for r in whole}
    plain, bent = press["double_dome, 2 threads"], press["double_dome with bending, 2 threads"]
    stepping = 1e-9 * plain["ns_min"] * plain["elements"] * plain["steps"]
    what = {r["what"]: r for r in features}
    peak = {r["kernel"]: r["best"] for r in kernels}
    largest = max(r["elements"] for r in runs)
    good = {case: min(r["wall_s"] for r in pareto if r["case"] == case and r["rms_deg"] <= 1.0) for case in ("double_dome", "hemisphere")}
    everything = what["everything"]["ns_min"]
    return {
        "arithmetic": f"{FLOPS / peak['arithmetic']:.0f}", "one": f"{paper[1]:.0f}", "two": f"{paper[2]:.0f}",
        "press_one": f"{press['double_dome with bending, 1 threads']['ns_min']:.0f}", "press_two": f"{bent['ns_min']:.0f}",
        "wall": f"{plain['wall_s_min']:.1f}", "wall_bending": f"{bent['wall_s_min']:.1f}",
        "beside": f"{plain['wall_s_min'] - stepping:.1f}", "steps": f"{plain['steps']:,}",
        "membrane": f"{100.0 * plain['membrane_ns'] / plain['ns_min']:.0f}", "contact": f"{100.0 * plain['contact_ns'] / plain['ns_min']:.0f}",
        "held": f"{what['everything']['bending_ns']:.0f}", "everything": f"{everything:.0f}",
        "each_step": f"{what['bending at every step: subcycling = false']['bending_ns']:.0f}",
        "spread_one": f"{spread(runs, 1):.0f}", "spread_two": f"{spread(runs, 2):.0f}", "more": f"{memory(runs)[0]:.0f}", "alone": f"{1e-6 * memory(runs)[1]:.0f}",
        "all_bytes": f"{next(r['bytes'] for r in runs if r['elements'] == largest):.0f}", "largest": f"{largest:,}",
        "good_dome": f"{good['double_dome']:.1f}", "good_hemisphere": f"{good['hemisphere']:.1f}"}


def write(text):
    """The page from the tables as they stand; `text` is the part that a person wrote, with places for facts."""
    kernels, runs, features, busy, whole, pareto, convergence = (
        read_table(n) for n in ("kernels", "runs", "features", "busy", "whole", "pareto", "convergence"))
    parts = [text.format(machine=machine(), **facts(kernels, runs, features, whole, pareto))]
    parts += ["## Whole runs\n", table(("run", "elements", "steps", "ns per element-step, least", "median", "wall s, least", *STEPPING, "output"),
              [(r["run"], r["elements"], r["steps"], f"{r['ns_min']:.1f}", f"{r['ns_median']:.1f}", f"{r['wall_s_min']:.2f}",
                *phases(r, (*STEPPING, "output"))) for r in whole])]
    parts += ["## Sizes and threads\n", "The double dome with everything on, bending too; the first steps of the press.\n",
              table(("elements", "threads", "ns per element-step, least", "median", *STEPPING, "bytes per element"),
                    [(r["elements"], r["threads"], f"{r['ns_min']:.1f}", f"{r['ns_median']:.1f}", *phases(r), f"{r['bytes']:.0f}") for r in runs]),
              f"Bytes are the most that the program had, with its libraries and the tools. From the second finest mesh to the finest each "
              f"element more takes {memory(runs)[0]:.0f}.\n"]
    parts += ["## What each part costs\n", "One thread, the first 1,000 steps of the double dome.\n",
              table(("what", "ns per element-step, least", "median", "over everything", *STEPPING, "output"),
                    [(r["what"], f"{r['ns_min']:.1f}", f"{r['ns_median']:.1f}", f"{r['over_everything']:.2f}",
                      *phases(r, (*STEPPING, "output"))) for r in features])]
    parts += ["## On a busy machine\n", "Without bending, another program taking all it gets of one core.\n",
              table(("threads", "other programs", "ns per element-step, least", "median"),
                    [(r["threads"], r["other_programs"], f"{r['ns_min']:.1f}", f"{r['ns_median']:.1f}") for r in busy])]
    parts += ["## Kernels and the machine\n",
              table(("kernel", "best", "median", "unit"),
                    [(r["kernel"], f"{r['best']:.4g}", f"{r['median']:.4g}", r["unit"]) for r in kernels]), peak_share(kernels) + "\n"]
    parts += ["## Run time against error\n", PARETO, "![Error over run time.](images/pareto.png)\n"]
    for case in sorted({r["case"] for r in pareto}):
        rows = front([r for r in pareto if r["case"] == case])
        parts += [f"The front of the {case.replace('_', ' ')}:\n",
                  table(("variant", "wall s", "RMS deg", "99th percentile deg", "kinetic over internal"),
                        [(r["variant"], f"{r['wall_s']:.2f}", f"{r['rms_deg']:.2f}", f"{r['p99_deg']:.2f}",
                          f"{r['kinetic_to_internal']:.2f}") for r in rows])]
    plain = "12800 elements, mass x 1, speed x 1"
    springs = [r for r in pareto if r["variant"] == plain or any(key in r["variant"] for key, _ in SPRINGS)]
    parts += ["### Springs\n", OF_SPRINGS,
              table(("case", "variant", "steps", "RMS deg", "99th percentile deg"),
                    [(r["case"].replace("_", " "), "the case's own" if r["variant"] == plain else r["variant"].split(", ")[1], r["steps"],
                      f"{r['rms_deg']:.3f}", f"{r['p99_deg']:.2f}") for r in springs])]
    parts += ["### What the reference is worth\n", CONVERGENCE,
              table(("case", "elements", "with bending, deg RMS", "without, deg RMS"),
                    [(r["case"].replace("_", " "), f"{r['elements']} and {2 * r['elements']}", f"{r['with_deg']:.2f}",
                      f"{r['without_deg']:.2f}") for r in convergence])]
    PAGE.write_text("\n".join(parts))


PARETO = """Quarter models on two threads, with bending (1 mN m, assumed). Error: shear angle at points 2.5 mm apart on the flat blank, beside
that of 102,400 elements of the whole sheet at the case's own speed, mass and law. All variants are in `docs/benchmarks/pareto.csv`.
"""
OF_SPRINGS = """The viscous law's spring (`relaxation_ratio`, over the yarns' stiffness) and the one that holds a triangle's yarn strain to its
strip's (`strip_stiffness`) limit the step and hardly change the shear: 12,800 elements, the same reference.
"""
CONVERGENCE = """Shear angles of two meshes, one with twice the elements of the other, at the same points. A sheet that resists bending has an
answer that finer meshes approach. One that does not folds where it is pressed along its yarns, at the size of an element: the finer the
mesh, the finer the folds, and no mesh is a reference for another.
"""
