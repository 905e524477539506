#!/usr/bin/python3
"""Judge runs of symmetric cases, as scripts/verify makes them: verify_double_dome.py DIR CASE...

For every CASE, DIR holds CASE_1_thread, CASE_2_threads (whole sheets) and CASE_quarter. Prints one table with a limit
and a verdict for each figure; exit code 1 when any is beyond its limit, 4 when a run is missing.
"""

import csv
import json
import sys
from pathlib import Path

import h5py
import numpy as np

FILES = 4


class Run:
    """A directory of results, its last frame."""

    def __init__(self, directory):
        self.summary = json.loads((directory / "summary.json").read_text())
        with open(directory / "history.csv", newline="") as file:
            self.history = list(csv.DictReader(file))
        with h5py.File(directory / "results.h5", "r") as file:
            frames = sorted(file["frames"], key=lambda name: (len(name), name))
            last = file["frames"][frames[-1]]
            self.position = last["position"][:]
            self.shear = np.abs(last["shear_angle"][:])
            self.strain = np.abs(last["fibre_strain"][:]).max(axis=1)
            reference, triangles = file["mesh/reference"][:], file["mesh/triangles"][:]
        corners = reference[triangles]
        self.centre = corners.mean(axis=1)[:, :2]
        sides = corners[:, 1:, :2] - corners[:, :1, :2]
        self.area = 0.5 * np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])

    def column(self, name):
        return np.array([float(row[name]) for row in self.history])


def quarter_means(run):
    """Mean |shear| of the four quarters of a whole sheet, weighted by reference area [deg]."""
    x, y = run.centre.T
    masks = [(sx * x > 0) & (sy * y > 0) for sx in (1, -1) for sy in (1, -1)]
    return np.array([np.average(run.shear[m], weights=run.area[m]) for m in masks])


def quarter_difference(run):
    """Largest difference of a quarter's mean |shear| from the mean of the four, over that mean."""
    means = quarter_means(run)
    return np.abs(means - means.mean()).max() / means.mean()


def against_quarter(whole, quarter):
    """RMS difference of |shear| between the quarter and the same quarter of the whole, element by element [deg]."""
    index = {key(c): e for e, c in enumerate(whole.centre)}
    partner = [index.get(key(c), -1) for c in quarter.centre]
    if -1 in partner:  # not the same mesh: nearest centre
        partner = [int(np.argmin(((whole.centre - c) ** 2).sum(axis=1))) for c in quarter.centre]
    difference = quarter.shear - whole.shear[partner]
    return np.sqrt(np.average(difference**2, weights=quarter.area))


def key(centre):
    return tuple(np.round(centre * 1e7).astype(int))


def kinetic(run):
    """Kinetic over internal energy: the most of the second half, and at the end."""
    time, ratio = run.column("time_s"), run.column("kinetic_to_internal")
    return ratio[time >= 0.5 * time[-1]].max(), ratio[-1]


def figures(one, two, quarter):
    """(name, value shown, limit shown, holds) of a case; holds is None for what has no limit."""

    def number(name, value, limit, shown, unit):
        return name, f"{shown.format(value)} {unit}", f"<= {limit:g} {unit}", bool(value <= limit)

    most, at_end = kinetic(one)
    equal = np.array_equal(one.position.view(np.uint64), two.position.view(np.uint64))
    return [
        ("ended", f"{one.summary['status']} / {two.summary['status']} / {quarter.summary['status']}", "done",
         all(r.summary["status"] == "done" for r in (one, two, quarter))),
        ("elements", str(one.summary["elements"]), "", None),
        ("steps", str(one.summary["steps"]), "", None),
        ("wall time, 1 / 2 threads, quarter",
         " / ".join(f"{r.summary['wall_time_s']:.1f}" for r in (one, two, quarter)) + " s", "", None),
        ("largest shear angle", f"{one.summary['shear_angle_max_deg']:.1f} deg", "", None),
        number("quarter by quarter, mean shear", 100 * quarter_difference(one), 1, "{:.3f}", "%"),
        number("whole against quarter, RMS shear", against_quarter(one, quarter), 0.5, "{:.3f}", "deg"),
        number("energy error at the end", 100 * one.summary["energy_error"], 1, "{:.3f}", "%"),
        number("kinetic to internal, second half", 100 * most, 10, "{:.1f}", "%"),
        number("kinetic to internal at the end", 100 * at_end, 10, "{:.1f}", "%"),
        number("penetration", one.summary["penetration_max_mm"], 0.1, "{:.4f}", "mm"),
        number("elements over 2 % yarn strain", 100 * np.mean(one.strain > 0.02), 1, "{:.2f}", "%"),
        ("1 against 2 threads, last positions", "equal bits" if equal else "DIFFERENT", "equal bits", equal),
    ]


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    directory, failed = Path(arguments[0]), 0
    print(f"\n{'case':<12} {'figure':<36} {'value':>24}  {'limit':<12} verdict")
    for case in arguments[1:]:
        try:
            runs = [Run(directory / f"{case}_{kind}") for kind in ("1_thread", "2_threads", "quarter")]
        except (OSError, KeyError) as error:
            print(f"verify: {case}: {error}", file=sys.stderr)
            return FILES
        for name, value, limit, holds in figures(*runs):
            verdict = {None: "", True: "pass", False: "FAIL"}[holds]
            failed += holds is False
            print(f"{case:<12} {name:<36} {value:>24}  {limit:<12} {verdict}".rstrip())
    print(f"\n{failed} figure{'s' if failed != 1 else ''} beyond the limit" if failed else "\nall within their limits")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
