"""Opens DIR/results.xdmf with ParaView's readers and compares what they give with DIR/results.h5.

Run by scripts/check-paraview under pvpython. Exit codes: 0 the same, 1 something differs, 2 usage, 4 files.
"""

import os
import sys
from pathlib import Path

import h5py
import numpy as np
import paraview.simple as pv
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy


class Check:
    """Prints a line for each comparison and remembers the failures."""

    def __init__(self):
        self.failures = 0

    def same(self, what, shown, expected, tolerance=0.0):
        shown, expected = np.asarray(shown, dtype=float), np.asarray(expected, dtype=float)
        good = shown.shape == expected.shape and bool(
            np.all(np.abs(shown - expected) <= tolerance * np.maximum(1e-300, np.abs(expected))))
        self.failures += not good
        detail = "" if good else f"   ParaView {brief(shown)}, file {brief(expected)}"
        print(f"    {'ok  ' if good else 'FAIL'} {what}{detail}")


def brief(array):
    if array.size <= 6:
        return np.array2string(array, precision=6)
    return f"{array.shape} from {array.min():.6g} to {array.max():.6g}"


def check_frame(check, data, frame, mesh):
    check.same("points", vtk_to_numpy(data.GetPoints().GetData()), frame["position"][...])
    cells = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 3)
    check.same("triangles", cells, mesh["triangles"][...])
    arrays = {name: frame[name] for name in frame if name != "position"}
    arrays["reference"] = mesh["reference"]
    for name, dataset in sorted(arrays.items()):
        expected = dataset[...]
        at_nodes = len(expected) == len(mesh["reference"])
        centre = data.GetPointData() if at_nodes else data.GetCellData()
        array = centre.GetArray(name)
        if array is None:
            check.failures += 1
            print(f"    FAIL {name}: not there")
            continue
        low, high = expected.min() + 0.0, expected.max() + 0.0  # no "-0"
        check.same(f"{name:<18}{'nodes' if at_nodes else 'cells':<7}{low:>13.6g}{high:>13.6g}",
                   vtk_to_numpy(array), expected)


def check_reader(check, reader, file):
    frames = [file["frames"][name] for name in sorted(file["frames"], key=lambda name: (len(name), name))]
    times = [frame.attrs["time"] for frame in frames]
    print(f"  {reader.SMProxy.GetXMLName()}: {len(reader.TimestepValues)} time steps")
    check.same("times", list(reader.TimestepValues), times, 1e-12)
    if len(reader.TimestepValues) != len(times):
        return
    seen = []
    for number in sorted({0, len(frames) // 2, len(frames) - 1}):
        print(f"    frame {number}, {times[number]:g} s                    min          max")
        reader.UpdatePipeline(times[number])
        data = servermanager.Fetch(reader)
        seen.append(vtk_to_numpy(data.GetPoints().GetData()).copy())
        check_frame(check, data, frames[number], file["mesh"])
    moved = np.linalg.norm(seen[-1] - seen[0], axis=1).max()
    expected = np.linalg.norm(frames[-1]["position"][...] - frames[0]["position"][...], axis=1).max()
    check.same(f"largest movement of a point, first to last frame: {1e3 * moved:.6g} mm", moved, expected)


def save_screenshot(reader, path):
    reader.UpdatePipeline(reader.TimestepValues[-1])
    view = pv.CreateRenderView(ViewSize=[1200, 800])
    view.ViewTime = reader.TimestepValues[-1]
    view.OrientationAxesVisibility = 0
    shown = pv.Show(reader, view)
    pv.ColorBy(shown, ("CELLS", "shear_angle"))
    shown.RescaleTransferFunctionToDataRange(True)
    shown.SetScalarBarVisibility(view, True)
    pv.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Elevation(-50)
    camera.Azimuth(-20)
    pv.SaveScreenshot(str(path), view)
    print(f"  wrote {path}")


def main():
    if len(sys.argv) != 2:
        print("usage: check-paraview RESULTS_DIR", file=sys.stderr)
        return 2
    directory = Path(sys.argv[1])
    for name in ("results.h5", "results.xdmf"):
        if not (directory / name).is_file():
            print(f"check-paraview: {directory / name}: no such file", file=sys.stderr)
            return 4
    xdmf = str(directory / "results.xdmf")
    check = Check()
    print(f"ParaView {pv.GetParaViewSourceVersion().split()[-1]}, {xdmf}")
    default = pv.OpenDataFile(xdmf)  # what File > Open takes
    others = [getattr(pv, name)(FileName=[xdmf]) for name in ("Xdmf3ReaderS", "Xdmf3ReaderT") if hasattr(pv, name)]
    with h5py.File(directory / "results.h5", "r") as file:
        if not len(file["frames"]):
            print(f"check-paraview: {directory}: no frame yet", file=sys.stderr)
            return 4
        for reader in [default] + others:
            check_reader(check, reader, file)
    if os.environ.get("DISPLAY"):
        save_screenshot(default, directory / "paraview.png")
    else:  # Debian's ParaView renders through X only and crashes without it
        print("  no picture: there is no display, and xvfb-run is not installed")
    print(f"{check.failures} differences" if check.failures else "ParaView shows what is in the file")
    return 1 if check.failures else 0


if __name__ == "__main__":
    sys.exit(main())
