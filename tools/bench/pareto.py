"""Run time against error: shear angles beside those of the finest mesh at the case's own speed."""

import itertools
import tempfile
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogFormatter  # noqa: E402
from matplotlib.tri import LinearTriInterpolator, Triangulation  # noqa: E402

from bench.runs import BENDING  # noqa: E402
from bench.timing import run_once  # noqa: E402
from towform_results import Results  # noqa: E402

# Elements of the whole sheet; quarter models are formed, as a user would who is in a hurry.
SIZES = (3200, 6400, 12800, 25600, 51200)
MASS = (1, 4, 10)
SPEED = (1, 2)
CASES = {"double_dome": 60.0, "hemisphere": 80.0}  # time.end [ms]
QUIET = ("gates.kinetic_to_internal=1e9", "gates.penetration=1 mm", "gates.energy_error=1", "output.history=20",
         "output.frames=1")


SPRINGS = (("relaxation_ratio", 0.1), ("relaxation_ratio", 0.01), ("strip_stiffness", 1000), ("strip_stiffness", 100))


def settings(case, elements, mass=1, speed=1, law="viscous", curves=None, bending=True, spring=None):
    more = ((BENDING,) if bending else ()) + (() if curves is None else (f"material.curve_selection={curves}",))
    if spring is not None:
        more += ("material.{}={}".format(*spring),)
    return ("blank.symmetry=quarter", f"blank.elements={elements}", f"time.mass_scaling={mass}",
            f"time.end={CASES[case] / speed} ms", f"material.law={law}", *more, *QUIET)


def variants():
    """name -> keywords of `settings`."""
    found = {}
    for elements, mass, speed in itertools.product(SIZES, MASS, SPEED):
        if speed > 1 and mass > 4:
            continue
        found[f"{elements} elements, mass x {mass}, speed x {speed}"] = dict(elements=elements, mass=mass, speed=speed)
    for law, curves in (("elastic", None), ("incremental", "next_higher"), ("incremental", "interpolate")):
        name = law if curves is None else f"{law}, {curves}"
        found[f"12800 elements, law {name}"] = dict(elements=12800, law=law, curves=curves)
    for key, value in SPRINGS:
        found[f"12800 elements, {key} = {value}"] = dict(elements=12800, spring=(key, value))
    return found


def shear_field(results):
    """Shear angle [deg] as a function of the place on the flat blank, linear between nodes."""
    frame, t = results.frame(-1), results.triangles
    area = np.ones(len(t))
    total, weight = np.zeros(len(results.reference)), np.zeros(len(results.reference))
    for k in range(3):
        np.add.at(total, t[:, k], np.abs(frame.shear_angle) * area)
        np.add.at(weight, t[:, k], area)
    x = results.reference
    return LinearTriInterpolator(Triangulation(x[:, 0], x[:, 1], t), total / weight)


def places(results, pitch=2.5e-3):
    """Points [m] a pitch apart over the flat quarter, an edge of the coarsest mesh away from its border."""
    low, high = results.reference[:, :2].min(axis=0) + 8e-3, results.reference[:, :2].max(axis=0) - 8e-3
    return np.array(list(itertools.product(np.arange(low[0], high[0], pitch), np.arange(low[1], high[1], pitch))))


def convergence(case, threads=2):
    """Rows: [deg RMS] between the shear angles of a mesh and of one of twice its elements, with bending and without."""
    apart = {}
    with tempfile.TemporaryDirectory(prefix="towform_pareto_") as scratch:
        for bending in (True, False):
            coarse = points = None
            for elements in (*SIZES, 2 * SIZES[-1]):
                run_once(case, settings(case, elements, bending=bending), threads, directory=Path(scratch))
                results = Results(Path(scratch) / "run")
                points = places(results) if points is None else points
                fine = shear_field(results)(points[:, 0], points[:, 1])
                if coarse is not None:
                    apart[elements // 2, bending] = float(np.sqrt(np.ma.mean((fine - coarse) ** 2)))
                    print(f"  {case}, {elements // 2} and {elements} elements, {'with' if bending else 'without'} bending: "
                          f"{apart[elements // 2, bending]:.2f} deg", flush=True)
                coarse = fine
    return [{"case": case, "elements": elements, "with_deg": apart[elements, True], "without_deg": apart[elements, False]}
            for elements in SIZES]


def measure(case, repeats, threads=2):
    """Rows: variant, seconds (least of the repeats), RMS and largest shear error [deg] against the reference."""
    with tempfile.TemporaryDirectory(prefix="towform_pareto_") as scratch:
        reference_directory = Path(scratch) / "reference"
        run_once(case, settings(case, 2 * SIZES[-1]), threads, directory=reference_directory)
        reference = Results(reference_directory / "run")
        points = places(reference)
        exact = shear_field(reference)(points[:, 0], points[:, 1])
        rows = []
        for number, (name, keywords) in enumerate(variants().items()):
            directory = Path(scratch) / str(number)
            walls = []
            try:
                for _ in range(repeats):
                    sample = run_once(case, settings(case, **keywords), threads, directory=directory)
                    walls.append(sample.wall)
            except RuntimeError as stopped:
                print(f"  {case}, {name}: {stopped}", flush=True)
                continue
            ours = shear_field(Results(directory / "run"))(points[:, 0], points[:, 1])
            apart = np.ma.abs(ours - exact).compressed()
            rows.append({"case": case, "variant": name, "wall_s": min(walls), "rms_deg": float(np.sqrt(np.mean(apart**2))),
                         "p99_deg": float(np.percentile(apart, 99)), "steps": sample.summary["steps"],
                         "kinetic_to_internal": sample.summary["kinetic_to_internal_max"]})
            print(f"  {case}, {name}: {rows[-1]['wall_s']:.2f} s, {rows[-1]['rms_deg']:.2f} deg RMS", flush=True)
    return rows


def front(rows):
    """The rows that no other beats in both time and error, fastest first."""
    best, found = np.inf, []
    for row in sorted(rows, key=lambda r: (r["wall_s"], r["rms_deg"])):
        if row["rms_deg"] < best:
            best = row["rms_deg"]
            found.append(row)
    return found


class PlainNumbers(LogFormatter):
    """1.5 on a logarithmic axis, not 1.5 x 10^0."""

    def __call__(self, value, position=None):
        return f"{value:g}" if super().__call__(value, position) else ""


def plot(rows, path):
    cases = sorted({row["case"] for row in rows})
    figure, axes = plt.subplots(1, len(cases), figsize=(5.5 * len(cases), 4.2), squeeze=False)
    for axis, case in zip(axes[0], cases):
        of_case = [row for row in rows if row["case"] == case]
        groups = {"viscous, own mass and speed": lambda v: "mass x 1, speed x 1" in v,
                  "mass scaled or faster": lambda v: "mass" in v and "mass x 1, speed x 1" not in v,
                  "other laws": lambda v: "law" in v}
        for (label, belongs), marker in zip(groups.items(), "os^"):
            points = [r for r in of_case if belongs(r["variant"])]
            axis.plot([r["wall_s"] for r in points], [r["rms_deg"] for r in points], marker, label=label)
        edge = front(of_case)
        axis.plot([r["wall_s"] for r in edge], [r["rms_deg"] for r in edge], "-", color="0.4", zorder=0, label="front")
        axis.axhline(1.0, color="0.8", zorder=0)
        axis.set(xscale="log", yscale="log", xlabel="wall time, s", ylabel="shear angle from the reference, deg RMS",
                 title=case.replace("_", " "))
        for side in (axis.xaxis, axis.yaxis):
            side.set_major_formatter(PlainNumbers())
            side.set_minor_formatter(PlainNumbers(labelOnlyBase=False, minor_thresholds=(2, 0.4)))
        axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)
