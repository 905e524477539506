#!/usr/bin/python3
"""Compares the results of a picture frame or bias extension with theory: specimen_tests.py DIR

DIR holds results.h5, history.csv and case.resolved.toml of a run. Prints a table over the stroke
(tools/verification/specimens.py has the formulas). Exit codes: 0 done, 2 usage, 4 files.
"""

import sys
from pathlib import Path

import numpy as np

from verification.specimens import (Specimen, bias_errors, bias_extension, frame_errors, percent,
                                    picture_frame)


def print_picture_frame(run):
    points = picture_frame(run)
    print("    d [mm]  theta [deg] exact    error   rate [deg/s] exact   error %    P [N]   theory   error %"
          "  scatter [deg]")
    for p in points:
        print(f"{1e3 * p.travel:10.3f} {p.angle:9.3f} {p.exact_angle:9.3f} {p.angle - p.exact_angle:8.4f}"
              f" {np.degrees(p.rate):10.3f} {np.degrees(p.exact_rate):9.3f} {percent(p.rate, p.exact_rate):8.3f}"
              f" {p.force:9.4f} {p.exact_force:9.4f} {percent(p.force, p.exact_force):8.3f} {p.scatter:10.2e}"
              f"{'' if p.steady else '  (speed changes)'}")
    angle, rate, force = frame_errors(points)
    print(f"largest errors at steady speed: angle {angle:.4f} deg, rate {rate:.3f} %, axial force {force:.3f} %;"
          f" energy account {100 * run.energy_error:.4f} %")


def print_bias_extension(run):
    points = bias_extension(run)
    print("    d [mm]  theta [deg] theory   error    full    half    F [N]   theory   F/W [N/m]   over theory"
          "   net: theta  force/net")
    for p in points:
        print(f"{1e3 * p.travel:10.3f} {p.angle:9.3f} {p.exact_angle:8.3f} {p.angle - p.exact_angle:8.3f} {p.full:7.2f}"
              f" {p.half:7.2f} {p.force:9.3f} {p.exact_force:8.3f} {p.force / p.width:10.3f}"
              f" {p.force / p.exact_force:10.3f} {p.net_angle:12.3f} {p.force / p.net_force:10.3f}")
    angle, net_angle, force, net_force = bias_errors(points)
    print(f"after a tenth of the stroke: central angle off by at most {angle:.3f} deg, from the net by {net_angle:.3f} deg;"
          f" force by {force:.2f} %, from the net by {net_force:.2f} %; energy account {100 * run.energy_error:.4f} %")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        run = Specimen(Path(sys.argv[1]))
    except (OSError, KeyError, StopIteration) as error:
        print(f"{sys.argv[1]}: not the results of a specimen test ({error!r})", file=sys.stderr)
        return 4
    print_picture_frame(run) if run.kind == "picture frame" else print_bias_extension(run)
    return 0


if __name__ == "__main__":
    sys.exit(main())
