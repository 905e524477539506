"""A small press and what the tests of the built program share; a test is run as TEST.py TOWFORM SOURCE_DIR."""

import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
COMMANDS = {"run", "resume", "check", "mesh", "info", "compare", "report", "study"}
DONE, USAGE, CASE_FILE, FILES, STABILITY, CONTACT, COMPARISON = 0, 2, 3, 4, 5, 6, 8

CASE = """title = "A small press"
[blank]
size = ["60 mm", "60 mm"]
elements = 72
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[tool]]
name = "punch"
mesh = "punch.stl"
motion = { displacement = "-5 mm" }
[[tool]]
name = "table"
mesh = "table.stl"
[time]
end = "5 ms"
[output]
frames = 3
history = 10
"""
PUNCH_LINE, TABLE_LINE = 11, 15  # of their mesh keys

HISTORY = ["time_s", "step", "dt_s", "force_punch_N", "force_table_N", "position_punch_m", "position_table_m",
           "energy_error"]
ENERGIES = ["kinetic", "yarn", "shear_elastic", "shear_dissipated", "bending", "bending_damping", "contact", "friction", "damping", "external"]
SUMMARY = ["status", "elements", "nodes", "steps", "simulated_time_s", "wall_time_s", "threads", "ns_per_element_step",
           "energy_error", "kinetic_to_internal_max", "shear_angle_max_deg", "shear_angle_p99_deg", "fibre_strain_max",
           "fibre_compression_max", "fibre_compression_p99",
           "draw_in_mm", "punch_force_max_N", "penetration_max_mm", "added_mass_fraction", "phases_s"]
# name: columns, per node or element, units
FIELDS = {"position": (3, "node", "m"), "velocity": (3, "node", "m/s"), "contact_pressure": (0, "node", "Pa"),
          "clearance": (0, "node", "m"), "curvature": (2, "element", "1/m"),
          "shear_angle": (0, "element", "deg"), "shear_rate": (0, "element", "rad/s"),
          "curve_index": (0, "element", "1"), "curve_position": (0, "element", "1"),
          "shear_force": (0, "element", "N/m"), "fibre_1": (3, "element", "1"), "fibre_2": (3, "element", "1"),
          "fibre_strain": (2, "element", "1"), "thickness": (0, "element", "m"), "temperature": (0, "element", "K")}


def box(low, high):
    """The facets of a closed box, outward normals."""
    p = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    corners = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2),
               (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    return [[p[i] for i in facet] for facet in corners]


def write_stl(path, facets):
    with open(path, "wb") as file:
        file.write(b"box".ljust(80) + struct.pack("<I", len(facets)))
        for facet in facets:
            file.write(struct.pack("<12fH", 0, 0, 0, *(x for corner in facet for x in corner), 0))


TABLE = box((-0.05, -0.05, -0.02), (-0.014, 0.05, -0.0005)) + box((0.014, -0.05, -0.02), (0.05, 0.05, -0.0005))


class Program(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = Path(temporary.name)
        # The sheet's faces are at +-0.5 mm; a block comes down on it between the two blocks of a table.
        write_stl(self.directory / "punch.stl", box((-0.006, -0.012, 0.0005), (0.006, 0.012, 0.02)))
        write_stl(self.directory / "table.stl", TABLE)
        self.case = self.write("press.toml", CASE)
        self.out = self.directory / "results"

    def write(self, name, text):
        path = self.directory / name
        path.write_text(text)
        return path

    def towform(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=self.directory)

    def run_case(self, *arguments, case=None):
        return self.towform("run", case or self.case, "-o", self.out, "--force", "--threads", 1, *arguments)

    def assert_ends(self, done, code):
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)

    def assert_refused(self, done, code, *patterns):
        """Ends with a code, says what is wrong on standard error, one line each, and writes nothing."""
        self.assert_ends(done, code)
        lines = done.stderr.strip().splitlines()
        self.assertEqual(len(lines), len(patterns), done.stderr)
        for line, pattern in zip(lines, patterns):
            self.assertRegex(line, pattern)
        self.assertEqual(done.stdout, "")
        self.assertFalse(self.out.exists(), "a refused run has written")
        self.assertFalse((self.directory / "out").exists(), "a refused run has written")
