"""One tidy table of a study: a row a run, its parameters, how it ended, its responses. As CSV and as HDF5.

table DIR writes DIR/table.csv and DIR/table.h5.
"""

import csv
import io
import os
import sys
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from .files import read_json, replace_file
from .manifest import Manifest
from .one_run import attempts_of
from .responses import evaluate


@dataclass
class Column:
    name: str
    unit: str
    values: list  # of every run; None where there is none
    numeric: bool = True


def row_of(manifest, run):
    """(status, exit code, reason, wall time, attempts, version, {response: value}) of a run."""
    folder = manifest.folder(run)
    status = read_json(folder / "status.json")
    values, reasons = {r.name: None for r in manifest.responses}, {}
    wall, version = None, ""
    if status is None:
        state, code, reason = "left", None, "not run to its end yet"
    else:
        code, reason = status["exit_code"], status["reason"]
        state = "done" if code == 0 else "failed"
        wall = (read_json(folder / "summary.json") or {}).get("wall_time_s") if code == 0 else status["seconds"]
    if state == "done":
        values, reasons = evaluate(manifest.responses, folder)
        reason = "; ".join(f"{name}: {why}" for name, why in reasons.items())
        with h5py.File(folder / "results.h5", "r") as file:
            version = str(file.attrs.get("git_hash", ""))
    return state, code, reason, wall, attempts_of(folder), version, values


def columns_of(manifest):
    """The table's columns, in order."""
    rows = [row_of(manifest, run) for run in manifest.runs]
    columns = [Column("run", "", [run.name for run in manifest.runs], False)]
    columns += [Column(p.name, p.unit, [run.values[p.name] if p.quantitative else p.shown(run.values[p.name])
                                        for run in manifest.runs], p.quantitative) for p in manifest.parameters]
    columns += [Column(r.name, r.unit, [row[6][r.name] for row in rows]) for r in manifest.responses]
    columns += [Column("status", "", [row[0] for row in rows], False), Column("exit_code", "", [row[1] for row in rows]),
                Column("reason", "", [row[2] for row in rows], False), Column("wall_time_s", "s", [row[3] for row in rows]),
                Column("attempts", "", [row[4] for row in rows]), Column("version", "", [row[5] for row in rows], False),
                Column("directory", "", [f"runs/{run.name}" for run in manifest.runs], False)]
    return columns


def _heading(column):
    return f"{column.name} [{column.unit}]" if column.unit and not column.name.endswith(f"_{column.unit}") else column.name


def _cell(value):
    return "" if value is None else f"{value:.10g}" if isinstance(value, float) else value


def write_table(manifest):
    columns = columns_of(manifest)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([_heading(column) for column in columns])
    writer.writerows([[_cell(value) for value in row] for row in zip(*(column.values for column in columns))])
    replace_file(manifest.directory / "table.csv", text.getvalue())
    os.utime(manifest.directory / "table.csv")  # as new as what it was made from, though it says the same
    _write_hdf5(manifest, columns)
    return columns


def _write_hdf5(manifest, columns):
    """/table/NAME (runs,) with its unit; NaN where a number is missing. The manifest is the root attribute `manifest`."""
    path = manifest.directory / "table.h5"
    beside = path.with_name(f".table.h5.{os.getpid()}")
    with h5py.File(beside, "w") as file:
        file.attrs["title"] = manifest.title
        group = file.create_group("table")
        group.attrs["columns"] = [column.name for column in columns]
        for column in columns:
            if column.numeric:
                data = np.array([np.nan if value is None else value for value in column.values], dtype=float)
            else:
                data = np.array(["" if value is None else value for value in column.values], dtype=h5py.string_dtype())
            group.create_dataset(column.name, data=data).attrs["units"] = column.unit or "1"
        file.create_dataset("manifest", data=(manifest.directory / "manifest.json").read_text(), dtype=h5py.string_dtype())
    os.replace(beside, path)


if __name__ == "__main__":
    write_table(Manifest.read(Path(sys.argv[1])))
