"""What a run of towform left behind, for Python: one file, h5py and numpy, copy it where you need it.

    results = Results("out/double_dome")
    results.frame(-1).shear_angle       # (m,) deg; every dataset of results.h5 is an attribute of its frame
    results.history["force_punch_N"]    # every column of history.csv
    results.summary["energy_error"]     # summary.json
    results.section((0, 0), (0.3, 0.2)) # what an upright plane cuts of the formed sheet
    results.outline()                   # its rim
    results.write_vtu("sheet.vtu"); results.write_abaqus("sheet.inp"); ...   # for other programs

docs/results.md explains it with two worked examples.
"""

import base64
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


class Section:
    """Where an upright plane cuts the sheet: k pieces, each in one element, from the first plan point on."""

    def __init__(self, elements, ends, along):
        self.elements = elements  # (k,)
        self.ends = ends  # (k,2,3) m
        self.along = along  # (k,2) m, in plan from the start
        steps = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        self.arc = np.cumsum(steps) - 0.5 * steps  # (k,) m, over the sheet to the middle of each piece
        self.points = ends.mean(axis=1)  # (k,3) m

    def __len__(self):
        return len(self.elements)


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

    def section(self, start, end, frame=-1):
        """The Section between two plan points [m], of the sheet as it is in a frame. Pieces are in the order of the plan, so
        a sheet that overhangs is not followed round. Raises ValueError when both points are one."""
        start, end = np.asarray(start, dtype=float)[:2], np.asarray(end, dtype=float)[:2]
        length = np.linalg.norm(end - start)
        if not length > 0.0:
            raise ValueError("a section needs two points that differ in plan")
        way = (end - start) / length
        x = self.frame(frame).position
        side = (x[:, 1] - start[1]) * way[0] - (x[:, 0] - start[0]) * way[1]
        left = (side >= 0.0)[self.triangles]
        elements = np.flatnonzero(left.any(axis=1) & ~left.all(axis=1))
        ends = np.empty((len(elements), 2, 3))
        filled = np.zeros(len(elements), dtype=int)
        for a, b in ((0, 1), (1, 2), (2, 0)):
            crosses = np.flatnonzero(left[elements, a] != left[elements, b])
            p, q = self.triangles[elements[crosses], a], self.triangles[elements[crosses], b]
            share = side[p] / (side[p] - side[q])
            ends[crosses, filled[crosses]] = x[p] + share[:, None] * (x[q] - x[p])
            filled[crosses] += 1
        along = (ends[:, :, :2] - start) @ way
        turned = along[:, 0] > along[:, 1]
        ends[turned], along[turned] = ends[turned, ::-1], along[turned, ::-1]
        inside = np.flatnonzero((along.mean(axis=1) >= 0.0) & (along.mean(axis=1) <= length))
        order = inside[np.argsort(along[inside].mean(axis=1), kind="stable")]
        return Section(elements[order], ends[order], along[order])

    def outline(self, frame=-1):
        """The rim and the holes of the sheet in a frame: a list of closed lines (k,3) m, each without its first point again,
        counter-clockwise round the sheet as it lay flat."""
        sides = self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        known = {(a, b) for a, b in sides.tolist()}
        after = {a: b for a, b in known if (b, a) not in known}
        x, lines = self.frame(frame).position, []
        while after:
            node, following = after.popitem()
            line = [node]
            while following != line[0]:
                line.append(following)
                following = after.pop(following)
            lines.append(x[line])
        return lines

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

    # --- for other programs; element and node numbers there are those here plus one

    def write_vtu(self, path, frame=-1):
        """The sheet of a frame with all its fields, for ParaView and whatever else reads VTK's XML files."""
        shown = self.frame(frame)

        def array(name, values):
            kind = {"f4": "Float32", "f8": "Float64", "i4": "Int32", "i8": "Int64", "u1": "UInt8"}[values.dtype.str[1:]]
            raw = np.ascontiguousarray(values).tobytes()
            data = base64.b64encode(np.uint64(len(raw)).tobytes() + raw).decode()
            columns = values.shape[1] if values.ndim == 2 else 1
            return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{columns}" format="binary">{data}'
                    "</DataArray>")

        with h5py.File(self.path, "r") as file:
            group = file["frames"][shown._name]
            fields = {name: group[name][...] for name in group if name != "position"}
        nodes, elements = len(self.reference), len(self.triangles)
        of = {size: "".join(array(n, v) for n, v in fields.items() if len(v) == size) for size in (nodes, elements)}
        corners = self.triangles.astype(np.int32)
        Path(path).write_text(
            '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64"><UnstructuredGrid><Piece NumberOfPoints="{nodes}" NumberOfCells="{elements}">\n'
            f"<PointData>{of[nodes]}</PointData>\n<CellData>{of[elements]}</CellData>\n"
            f"<Points>{array('Points', shown.position)}</Points>\n<Cells>{array('connectivity', corners.ravel())}"
            f"{array('offsets', 3 * np.arange(1, elements + 1, dtype=np.int32))}"
            f"{array('types', np.full(elements, 5, dtype=np.uint8))}</Cells></Piece></UnstructuredGrid></VTKFile>\n")

    def yarns(self, frame=-1):
        """(m,3) and (m,3): unit directions of warp and weft in a frame. They are not square once the sheet is sheared."""
        return self.frame(frame).fibre_1.astype(float), self.frame(frame).fibre_2.astype(float)

    def write_abaqus(self, path, frame=-1):
        """Nodes, S3 shells and a *DISTRIBUTION of each element's orientation for Abaqus: axis 1 along the warp, the weft in
        the plane of axes 1 and 2. Give it to the sections as ORIENTATION=yarns; thickness is in the distribution
        `thickness`, for *SHELL SECTION, SHELL THICKNESS=thickness."""
        warp, weft = self.yarns(frame)
        with open(path, "w", encoding="ascii") as file:
            self._write_nodes(file, self.frame(frame).position)
            file.write("*ELEMENT, TYPE=S3, ELSET=sheet\n")
            file.writelines(f"{i + 1}, {a + 1}, {b + 1}, {c + 1}\n" for i, (a, b, c) in enumerate(self.triangles))
            file.write("*DISTRIBUTION TABLE, NAME=yarn_table\nCOORD3D, COORD3D\n")
            file.write("*DISTRIBUTION, NAME=yarn_axes, LOCATION=ELEMENT, TABLE=yarn_table\n")
            self._write_axes(file, warp, weft)
            file.write("*ORIENTATION, NAME=yarns, SYSTEM=RECTANGULAR, DEFINITION=COORDINATES\nyarn_axes\n3, 0.\n")
            file.write("*DISTRIBUTION TABLE, NAME=thickness_table\nLENGTH\n")
            thickness = self.frame(frame).thickness
            file.write("*DISTRIBUTION, NAME=thickness, LOCATION=ELEMENT, TABLE=thickness_table\n")
            file.write(f", {thickness.mean():.6g}\n")
            file.writelines(f"{i + 1}, {t:.6g}\n" for i, t in enumerate(thickness))

    def write_calculix(self, path, frame=-1):
        """Nodes, C3D6 wedges and a *DISTRIBUTION of each element's orientation for CalculiX, which takes distributions for
        solid sections only. Nodes n and n + (number of nodes) are the lower and upper face, apart by the mean thickness
        of the elements round them. For *SOLID SECTION, ELSET=sheet, ORIENTATION=yarns."""
        warp, weft = self.yarns(frame)
        x, count = self.frame(frame).position, len(self.reference)
        a, b, c = (x[self.triangles[:, k]] for k in range(3))
        normal, thickness, weight = np.zeros_like(x), np.zeros(count), np.zeros(count)
        for k in range(3):
            np.add.at(normal, self.triangles[:, k], np.cross(b - a, c - a))
            np.add.at(thickness, self.triangles[:, k], self.frame(frame).thickness)
            np.add.at(weight, self.triangles[:, k], 1.0)
        half = 0.5 * (thickness / weight)[:, None] * normal / np.linalg.norm(normal, axis=1, keepdims=True)
        with open(path, "w", encoding="ascii") as file:
            self._write_nodes(file, np.vstack([x - half, x + half]))
            file.write("*ELEMENT, TYPE=C3D6, ELSET=sheet\n")
            for i, corners in enumerate(self.triangles + 1):
                file.write(", ".join(map(str, [i + 1, *corners, *(corners + count)])) + "\n")
            file.write("*DISTRIBUTION, NAME=yarn_axes\n")
            self._write_axes(file, warp, weft)
            file.write("*ORIENTATION, NAME=yarns, SYSTEM=RECTANGULAR\nyarn_axes\n")

    def write_ls_dyna(self, path, frame=-1, part=1):
        """Nodes and *ELEMENT_SHELL_BETA for LS-DYNA: thickness at the corners, and BETA [deg], the angle of the warp from
        the side between the first two corners, about the element's normal; for materials with AOPT = 0."""
        warp, _ = self.yarns(frame)
        x = self.frame(frame).position
        a, b, c = (x[self.triangles[:, k]] for k in range(3))
        side, normal = b - a, np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        beta = np.degrees(np.arctan2((np.cross(side, warp) * normal).sum(axis=1), (side * warp).sum(axis=1)))
        with open(path, "w", encoding="ascii") as file:
            file.write("*KEYWORD\n*NODE\n")
            file.writelines(f"{i + 1:8d}{p[0]:16.8e}{p[1]:16.8e}{p[2]:16.8e}\n" for i, p in enumerate(x))
            file.write("*ELEMENT_SHELL_BETA\n")
            for i, ((p, q, r), t, angle) in enumerate(zip(self.triangles + 1, self.frame(frame).thickness, beta)):
                file.write(f"{i + 1:8d}{part:8d}{p:8d}{q:8d}{r:8d}{r:8d}\n" + f"{t:16.8e}" * 4 + f"{angle:16.8f}\n")
            file.write("*END\n")

    @staticmethod
    def _write_nodes(file, places):
        file.write("*NODE, NSET=nodes\n")
        file.writelines(f"{i + 1}, {p[0]:.9g}, {p[1]:.9g}, {p[2]:.9g}\n" for i, p in enumerate(places))

    @staticmethod
    def _write_axes(file, warp, weft):
        file.write(", 1., 0., 0., 0., 1., 0.\n")  # of elements that are not listed
        for i, (a, b) in enumerate(zip(warp, weft)):
            file.write(f"{i + 1}, " + ", ".join(f"{v:.7g}" for v in (*a, *b)) + "\n")
