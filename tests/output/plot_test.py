"""Runs tools/plot.py as a user does, on the results that towform_write_dome wrote: plot_test.py SOURCE_DIR RESULTS_DIR."""

import contextlib
import io
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np

SOURCE, RESULTS = Path(sys.argv[1]), Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tools"))
import plot as plot_module


def plot(*arguments):
    return subprocess.run([sys.executable, SOURCE / "tools/plot.py", *map(str, arguments)], capture_output=True, text=True)


class Plot(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.directory = Path(self.temporary.name)

    def draw(self, *arguments, width=800, height=500):
        picture = self.directory / "picture.png"
        with contextlib.redirect_stdout(io.StringIO()) as printed:  # in this process: a start takes a second
            code = plot_module.main([str(RESULTS), "-o", str(picture), "--size", f"{width}x{height}", *arguments])
        self.assertEqual((code, printed.getvalue()), (0, f"{picture}\n"))
        pixels = matplotlib.image.imread(picture)
        self.assertEqual(pixels.shape[:2], (height, width))
        return pixels[..., :3]

    def refuse(self, code, message, *arguments):
        done = plot(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_help_names_every_option(self):
        text = plot("--help").stdout
        for option in ("--field", "--frame", "--view", "--size", "--history", "--range", "--abs", "--cmap", "-o"):
            self.assertIn(option, text)

    def test_draws_every_field_in_every_view(self):
        with h5py.File(RESULTS / "results.h5") as file:
            fields = list(file["frames/0000"])
        for number, field in enumerate(fields):
            pixels = self.draw("--field", field, "--view", ("iso", "top", "side")[number % 3], "--frame", "-2", width=320, height=200)
            self.assertGreater((pixels.min(axis=2) < 0.9).mean(), 0.02, field)

    def test_top_view_has_the_sheets_shape_and_colour(self):
        pixels = self.draw("--view", "top", "--frame", "0", "--field", "temperature")
        sheet = np.ptp(pixels, axis=2) > 0.1  # coloured; the text is grey
        sheet[:, 640:] = False  # the colour bar
        rows, columns = np.where(sheet)
        # The first frame is the flat square, so it is as high as wide.
        self.assertLessEqual(abs(np.ptp(rows) - np.ptp(columns)), 1)
        self.assertGreater(np.ptp(rows), 300)
        # One temperature, one light: one colour, without seams between the triangles.
        inside = pixels[rows.min() + 3: rows.max() - 3, columns.min() + 3: columns.max() - 3]
        self.assertLess(np.ptp(inside, axis=(0, 1)).max(), 0.01)

    def test_range_and_component_change_the_picture(self):
        whole = self.draw("--field", "fibre_strain.1")
        other = self.draw("--field", "fibre_strain.2")
        clipped = self.draw("--field", "fibre_strain.1", "--range=-1,1")
        self.assertGreater(np.abs(whole - other).max(), 0.1)
        self.assertGreater(np.abs(whole - clipped).max(), 0.1)
        self.assertGreater(np.abs(self.draw("--field", "curvature.1") - self.draw("--field", "clearance")).max(), 0.1)

    def test_history(self):
        pixels = self.draw("--history")
        self.assertGreater((np.ptp(pixels, axis=2) > 0.3).sum(), 500)

    def test_writes_beside_the_results_by_default(self):
        done = plot(RESULTS / "results.h5", "--size", "400x300", "--frame", "0")
        self.assertEqual(done.stdout.strip(), str(RESULTS / "shear_angle_0000.png"))

    def test_wrong_arguments(self):
        results = RESULTS / "results.h5"
        self.refuse(2, "no field shear; there are clearance, contact_pressure, curvature,", results, "--field", "shear")
        self.refuse(2, "fibre_strain has no component z", results, "--field", "fibre_strain.z")
        self.refuse(2, "shear_angle is a scalar", results, "--field", "shear_angle.x")
        self.refuse(2, "frame 6 is out of range: there are 6, 0 to 5", results, "--frame", "6")
        self.refuse(2, "frame -7 is out of range", results, "--frame", "-7")
        self.refuse(2, "'big'", results, "--size", "big")
        self.refuse(2, "no colour map rainbows", results, "--cmap", "rainbows")

    def test_files_that_cannot_be_read_or_written(self):
        text = self.directory / "text.h5"
        text.write_text("text")
        empty = self.directory / "empty.h5"
        h5py.File(empty, "w").close()
        self.refuse(4, "none.h5: no such file", self.directory / "none.h5")
        self.refuse(4, "text.h5: not a readable HDF5 file", text)
        self.refuse(4, "empty.h5: not a towform results file", empty)
        self.refuse(4, "cannot be written: No such file or directory", RESULTS, "-o", self.directory / "none/a.png")
        self.refuse(4, "cannot be written", RESULTS, "-o", self.directory / "a.nonsense")
        self.refuse(4, "history.csv: No such file or directory", self.directory, "--history")
        (self.directory / "history.csv").write_text("time_s,step\n")
        self.refuse(4, "not a history", self.directory, "--history")
        (self.directory / "history.csv").write_text("time_s,step\n1\n")
        self.refuse(4, "not a history", self.directory, "--history")

    def test_index_is_well_formed(self):
        root = xml.etree.ElementTree.parse(RESULTS / "results.xdmf").getroot()
        steps = root.findall("./Domain/Grid[@CollectionType='Temporal']/Grid")
        self.assertEqual(len(steps), 6)
        for step in steps:
            names = [attribute.get("Name") for attribute in step.findall("Attribute")]
            self.assertEqual(len(names), len(set(names)))
            self.assertEqual(len(names), 15)


unittest.main(argv=sys.argv[:1])
