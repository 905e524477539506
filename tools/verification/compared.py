"""Differences from reference points, by `towform compare`."""

import csv
import math
import subprocess

from verification.runs import PROGRAM, ROOT


def compared(workshop, run, reference, options):
    """Differences [deg, of outlines mm] at the points of a file under cases/reference."""
    table = workshop.directory / f"{run.name}.csv"
    subprocess.run([PROGRAM, "compare", workshop.form(run) / "results.h5", ROOT / "cases/reference" / reference, *options,
                    "-o", table], check=True, stdout=subprocess.DEVNULL)
    with open(table, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    column = next(name for name in rows[0] if name.startswith("difference_"))
    return [float(row[column]) if row[column] else math.inf for row in rows]


def rms(differences):
    return math.sqrt(sum(d * d for d in differences) / len(differences))
