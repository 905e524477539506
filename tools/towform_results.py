"""What a run of towform left behind, for Python: one file, h5py and numpy, copy it where you need it.

    results = Results("out/double_dome")
    results.frame(-1).shear_angle       # (m,) deg; every dataset of results.h5 is an attribute of its frame
    results.history["force_punch_N"]    # every column of history.csv
    results.summary["energy_error"]     # summary.json
"""

import json
import tomllib
from pathlib import Path

import h5py
import numpy as np


class Frame:
    """One output frame. Its datasets are read when asked for: `position` (n,3) m, `shear_angle` (m,) deg, ..."""

    def __init__(self, path, name, time):
        self._path, self._name = path, name
        self.time = time  # [s]

    def __getattr__(self, dataset):
        if dataset.startswith("_"):
            raise AttributeError(dataset)
        with h5py.File(self._path, "r") as file:
            group = file["frames"][self._name]
            if dataset not in group:
                raise AttributeError(f"{self._path}: no dataset {dataset} in a frame; there are {', '.join(group)}")
            values = group[dataset][...]
        setattr(self, dataset, values)
        return values


class Results:
    """A directory of results, or its results.h5. Raises OSError when there are none."""

    def __init__(self, path):
        path = Path(path)
        self.directory = path if path.is_dir() else path.parent
        self.path = path / "results.h5" if path.is_dir() else path
        with h5py.File(self.path, "r") as file:
            self.triangles = file["mesh/triangles"][...]  # (m,3)
            self.reference = file["mesh/reference"][...]  # (n,3) m
            self.status = str(file.attrs.get("status", ""))
            frames = [(float(frame.attrs["time"]), name) for name, frame in file["frames"].items()]
        self._frames = [Frame(self.path, name, time) for time, name in sorted(frames)]
        self.times = np.array([frame.time for frame in self._frames])  # [s]

    def __len__(self):
        return len(self._frames)

    def frame(self, index):
        """Frame by number, negative from the end."""
        return self._frames[index]

    def at(self, time):
        """The frame nearest to a time [s]."""
        return self._frames[int(np.argmin(np.abs(self.times - time)))]

    @property
    def summary(self):
        return json.loads((self.directory / "summary.json").read_text())

    @property
    def case(self):
        """The case with every default written out; lengths and so on are SI numbers or strings with a unit."""
        return tomllib.loads((self.directory / "case.resolved.toml").read_text())

    @property
    def history(self):
        """Columns of history.csv by name."""
        table = np.genfromtxt(self.directory / "history.csv", delimiter=",", names=True, deletechars="")
        return {name: np.atleast_1d(table[name]) for name in table.dtype.names}

    @property
    def centres(self):
        """(m,2) m, middles of the elements on the flat blank."""
        return self.reference[self.triangles].mean(axis=1)[:, :2]

    @property
    def areas(self):
        """(m,) m^2, of the elements on the flat blank."""
        a, b, c = (self.reference[self.triangles[:, k], :2] for k in range(3))
        return 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])

    def neighbours(self):
        """(m,3) elements across an element's edges, -1 at the blank's edge."""
        sides = np.sort(self.triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
        order = np.lexsort(sides.T)
        same = np.flatnonzero((sides[order][1:] == sides[order][:-1]).all(axis=1))
        first, second = order[same], order[same + 1]
        across = np.full(len(sides), -1)
        across[first], across[second] = second // 3, first // 3
        return across.reshape(-1, 3)
