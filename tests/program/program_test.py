"""Runs the built program as a user does: program_test.py TOWFORM SOURCE_DIR."""

import csv
import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

PROGRAM, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
COMMANDS = {"run", "check", "mesh", "info", "compare"}
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
        return self.towform("run", case or self.case, "-o", self.out, "--threads", 1, *arguments)

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


class Help(Program):
    def test_help_lists_every_command(self):
        done = self.towform("--help")
        self.assert_ends(done, DONE)
        self.assertEqual(done.stderr, "")
        listed = {line.split()[0] for line in done.stdout.splitlines() if re.match(r"  [a-z]", line)}
        self.assertLessEqual(COMMANDS, listed, done.stdout)
        for command in listed:
            with self.subTest(command):
                of_command = self.towform(command, "--help")
                self.assert_ends(of_command, DONE)
                self.assertGreater(len(of_command.stdout.splitlines()), 3)
                self.assertEqual(of_command.stderr, "")

    def test_version(self):
        done = self.towform("--version")
        self.assert_ends(done, DONE)
        self.assertRegex(done.stdout, r"\Atowform \d+\.\d+\.\d+ \(.+\)\n\Z")

    def test_mesh_help_names_parameters_with_unit_default_and_origin(self):
        for shape in ("double-dome", "hemisphere"):
            done = self.towform("mesh", shape, "--help")
            self.assert_ends(done, DONE)
            self.assertRegex(done.stdout, r"--dome-radius LENGTH")
            self.assertRegex(re.sub(r"\s+", " ", done.stdout), r"assumed \[[\d.]+ mm; [\d.]+ mm to [\d.]+ mm\]")


class Usage(Program):
    def test_wrong_usage_ends_with_two(self):
        wrong = {
            "nothing": (),
            "an unknown command": ("press",),
            "an unknown option": ("run", self.case, "--fast"),
            "no case": ("run",),
            "two cases": ("check", self.case, self.case),
            "no threads": ("run", self.case, "--threads", 0),
            "threads in words": ("run", self.case, "--threads", "two"),
            "no value": ("run", self.case, "-o"),
            "info of nothing": ("info",),
            "a mesh without a shape": ("mesh",),
            "an unknown shape": ("mesh", "cone", "--part", "punch", "-o", "a.stl"),
            "an unknown part": ("mesh", "hemisphere", "--part", "lid", "-o", "a.stl"),
            "an unknown parameter": ("mesh", "hemisphere", "--part", "punch", "--height", "1mm", "-o", "a.stl"),
            "a bad unit": ("mesh", "hemisphere", "--part", "punch", "--dome-radius", "75 deg", "-o", "a.stl"),
            "out of range": ("mesh", "hemisphere", "--part", "punch", "--dome-radius", "1 mm", "-o", "a.stl"),
            "a contradiction": ("mesh", "hemisphere", "--part", "die", "--opening-radius", "70 mm", "-o", "a.stl"),
        }
        before = sorted(self.directory.iterdir())
        for what, arguments in wrong.items():
            with self.subTest(what):
                done = self.towform(*arguments)
                self.assert_ends(done, USAGE)
                self.assertEqual(done.stdout, "")
                self.assertNotEqual(done.stderr.strip(), "")
        self.assertEqual(sorted(self.directory.iterdir()), before)

    def test_a_bad_parameter_is_named_with_its_range(self):
        done = self.towform("mesh", "hemisphere", "--part", "punch", "--dome-radius", "1 mm", "-o", "a.stl")
        self.assertRegex(done.stderr, r"dome-radius = 1 mm.*5 mm.*2000 mm")


class BadCase(Program):
    def test_every_mistake_is_reported_at_its_place(self):
        bad = CASE.replace('thickness = "1 mm"', 'thicknes = "1 mm"').replace('"5 ms"', '"5 mm"')
        bad = bad.replace("elements = 72", "elements = 1")
        case = self.write("bad.toml", bad)
        expected = [
            r"bad\.toml:2:1: .*blank\.thickness",
            r"bad\.toml:4:12: .*elements",
            r"bad\.toml:5:1: .*thicknes.*did you mean .thickness",
            r"bad\.toml:17:7: .*5 mm",
        ]
        for command in ("check", "run"):
            with self.subTest(command):
                done = self.towform(command, case)
                self.assert_ends(done, CASE_FILE)
                self.assertEqual(done.stdout, "")
                for pattern in expected:
                    self.assertRegex(done.stderr, pattern)
                for line in done.stderr.strip().splitlines():
                    self.assertRegex(line, r"\A\S*bad\.toml:\d+:\d+: \S")
                self.assertFalse((self.directory / "out").exists())

    def test_not_toml(self):
        case = self.write("bad.toml", CASE + "what = = 3\n")
        self.assert_refused(self.run_case(case=case), CASE_FILE, r"bad\.toml:21:\d+: ")

    def test_no_such_case(self):
        self.assert_refused(self.run_case(case=self.directory / "none.toml"), FILES, r"none\.toml")

    def test_a_bad_override_is_named(self):
        done = self.run_case("--set", "blank.thickness=1 s")
        self.assert_refused(done, CASE_FILE, r"--set blank\.thickness=1 s: ")
        done = self.run_case("--set", "blank.tickness=1 mm")
        self.assert_refused(done, CASE_FILE, r"--set blank\.tickness=1 mm: .*did you mean")

    def test_a_misplaced_tool_is_a_mistake_of_the_case(self):
        done = self.run_case("--set", "tool.punch.mesh_unit=1000 m")
        self.assert_refused(done, CASE_FILE, rf"press\.toml:{PUNCH_LINE}:\d+: .*mesh_unit")
        done = self.run_case("--set", "tool.table.position=[0, 0, '0.1 mm']")
        self.assert_refused(done, CASE_FILE, rf"press\.toml:{TABLE_LINE}:\d+: .*0\.1 mm inside tool 'table'")


class BadFiles(Program):
    def test_a_missing_mesh(self):
        (self.directory / "table.stl").unlink()
        self.assert_refused(self.run_case(), FILES, rf"press\.toml:{TABLE_LINE}:\d+: .*table\.stl")

    def test_a_broken_mesh(self):
        whole = (self.directory / "table.stl").read_bytes()
        turned = [TABLE[0][::-1], *TABLE[1:]]
        broken = {"empty": b"", "cut short": whole[:300], "no facets": b"solid a\nendsolid a\n",
                  "something else": b"GIF89a" + bytes(200), "not finite": whole[:96] + struct.pack("<f", np.nan) + whole[100:]}
        for what, content in broken.items():
            with self.subTest(what):
                (self.directory / "table.stl").write_bytes(content)
                self.assert_refused(self.run_case(), FILES, rf"press\.toml:{TABLE_LINE}:\d+: .*table\.stl")
        with self.subTest("a facet turned over"):
            write_stl(self.directory / "table.stl", turned)
            self.assert_refused(self.run_case(), FILES, rf"press\.toml:{TABLE_LINE}:\d+: .*table\.stl.*facet")

    def test_a_broken_mesh_of_the_blank_is_named_with_its_line(self):
        whole = (SOURCE / "meshes/disc.msh").read_text()
        case = self.write("disc.toml", CASE.replace('size = ["60 mm", "60 mm"]\nelements = 72', 'mesh = "blank.msh"'))
        broken = {"2.2": (whole.replace("4.1 0 8", "2.2 0 8"), r":2:1: .*2\.2.*4\.1"),
                  "binary": (whole.replace("4.1 0 8", "4.1 1 8"), r":2:1: .*binary"),
                  "cut short": (whole[:3000], r":\d+:1: .*truncated"),
                  "lying": (whole.replace("1 2461 1 2461", "1 999999999999 1 2461"), r":10:1: claims 999999999999 nodes")}
        for what, (content, pattern) in broken.items():
            with self.subTest(what):
                self.write("blank.msh", content)
                self.assert_refused(self.run_case(case=case), FILES, r"blank\.msh" + pattern)

    def test_a_wrong_unit_of_the_blank_is_suspected(self):
        done = self.towform("check", SOURCE / "cases/disc.toml", "--set", "blank.mesh_unit=m")
        self.assert_ends(done, CASE_FILE)
        self.assertIn("against a blank of 300 m: an STL file carries no unit, are its mesh_unit = 1 and "
                      "blank.mesh_unit = 1 right?", done.stderr)

    def test_a_directory_that_cannot_be_made(self):
        self.write("results", "a file is in its place")
        done = self.run_case()
        self.assert_ends(done, FILES)
        self.assertRegex(done.stderr, r"results")

    def test_info_of_what_is_not_results(self):
        for name in ("none.h5", "press.toml"):
            done = self.towform("info", name)
            self.assert_ends(done, FILES)
            self.assertIn(name, done.stderr)
            self.assertEqual(done.stdout, "")

    def test_a_mesh_that_cannot_be_written(self):
        done = self.towform("mesh", "hemisphere", "--part", "holder", "-o", "none/holder.stl")
        self.assert_ends(done, FILES)
        self.assertIn("none/holder.stl", done.stderr)


class GoodRun(Program):
    def test_leaves_every_result(self):
        done = self.run_case()
        self.assert_ends(done, DONE)
        self.assertEqual(done.stderr, "")
        self.assertIn(str(self.out), done.stdout)  # says what it wrote
        self.assertEqual({p.name for p in self.out.iterdir()},
                         {"results.h5", "results.xdmf", "history.csv", "summary.json", "case.resolved.toml", "run.log"})
        self.check_history()
        self.check_summary()
        self.check_results()
        xdmf = (self.out / "results.xdmf").read_text()
        self.assertEqual(xdmf.count("<Time "), 4)

    def check_history(self):
        with open(self.out / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertLessEqual(set(HISTORY) | {f"energy_{kind}_J" for kind in ENERGIES}, set(rows[0]))
        self.assertTrue(any("draw_in" in name for name in rows[0]))
        self.assertTrue(any("shear" in name and "deg" in name for name in rows[0]))
        time = np.array([float(row["time_s"]) for row in rows])
        self.assertEqual((time[0], time[-1]), (0.0, 5e-3))
        self.assertTrue(np.all(np.diff(time) > 0.0))
        # Ten intervals, and the two of three frames that fall between their ends.
        self.assertEqual(len(rows), 1 + 10 + 2)
        self.assertAlmostEqual(float(rows[-1]["position_punch_m"]), -5e-3, delta=1e-12)
        self.assertEqual(float(rows[-1]["position_table_m"]), 0.0)
        for row in rows:
            for name, value in row.items():
                self.assertTrue(np.isfinite(float(value)), name)

    def check_summary(self):
        summary = json.loads((self.out / "summary.json").read_text())
        self.assertLessEqual(set(SUMMARY), set(summary))
        self.assertEqual((summary["status"], summary["elements"], summary["nodes"], summary["threads"]),
                         ("done", 72, 49, 1))
        self.assertEqual(summary["simulated_time_s"], 5e-3)
        self.assertEqual(set(summary["draw_in_mm"]), {"x_mid", "y_mid", "corner"})
        self.assertGreater(summary["steps"], 100)
        self.assertGreater(summary["punch_force_max_N"], 0.0)
        self.assertGreater(summary["ns_per_element_step"], 0.0)
        self.assertLess(summary["energy_error"], 0.02)

    def check_results(self):
        with h5py.File(self.out / "results.h5", "r") as file:
            self.assertEqual(file["mesh/triangles"].shape, (72, 3))
            self.assertEqual(file["mesh/triangles"].dtype, np.int32)
            self.assertEqual(file["mesh/reference"].shape, (49, 3))
            self.assertEqual(file.attrs["status"], "done")
            self.assertEqual(file.attrs["case"], CASE)
            for name in ("version", "git_hash", "flags", "inputs"):
                self.assertTrue(file.attrs[name], name)
            self.assertIn("punch.stl", file.attrs["inputs"])
            self.assertEqual(sorted(file["frames"]), ["0000", "0001", "0002", "0003"])
            for i, frame in enumerate(sorted(file["frames"])):
                self.assertAlmostEqual(file["frames"][frame].attrs["time"], i * 5e-3 / 3, delta=1e-15)
                self.assertEqual(set(file["frames"][frame]), set(FIELDS))
                for name, (columns, of, units) in FIELDS.items():
                    data = file["frames"][frame][name]
                    count = 49 if of == "node" else 72
                    self.assertEqual(data.shape, (count, columns) if columns else (count,), name)
                    self.assertEqual(data.attrs["units"], units, name)
                    self.assertTrue(np.all(np.isfinite(data[:])), name)
            last = file["frames/0003"]
            self.assertLess(last["position"][:, 2].min(), -4e-3)  # pressed down
            for name in ("fibre_1", "fibre_2"):
                self.assertTrue(np.allclose(np.linalg.norm(last[name][:], axis=1), 1.0, atol=1e-12))

    def test_the_resolved_case_gives_the_same_run(self):
        self.assert_ends(self.run_case("--set", "tool.punch.friction=0.1"), DONE)
        first = (self.out / "history.csv").read_bytes()
        self.write("again.toml", (self.out / "case.resolved.toml").read_text())
        self.assert_ends(self.run_case(case=self.directory / "again.toml"), DONE)
        self.assertEqual((self.out / "history.csv").read_bytes(), first)
        self.assert_ends(self.run_case(), DONE)  # and without the override it is another
        self.assertNotEqual((self.out / "history.csv").read_bytes(), first)

    def test_forms_a_blank_meshed_elsewhere(self):
        stroke = ("--set", "tool.punch.motion.displacement=-10 mm", "--set", "time.end=10 ms", "--set", "output.frames=1")
        self.assert_ends(self.run_case(*stroke, case=SOURCE / "cases/disc.toml"), DONE)
        summary = json.loads((self.out / "summary.json").read_text())
        self.assertEqual((summary["elements"], summary["nodes"]), (4800, 2461))
        draw_in = summary["draw_in_mm"]
        self.assertGreater(draw_in["corner"], 0.0)
        with h5py.File(self.out / "results.h5", "r") as file:
            self.assertIn("disc.msh", file.attrs["inputs"])
            last = file["frames/0001"]
            self.assertAlmostEqual(last["position"][:, 2].min(), -0.01, delta=0.0003)

    def test_goes_into_out_by_default_and_is_quiet_when_asked(self):
        done = self.towform("run", self.case, "--threads", 1, "--quiet")
        self.assert_ends(done, DONE)
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertTrue((self.directory / "out/press/summary.json").is_file())

    def test_a_gate_stops_it_with_its_code_and_readable_results(self):
        for code, limit, what in ((STABILITY, "gates.yarn_strain=1e-7", r"element \d+ "),
                                  (CONTACT, "gates.penetration=1e-9", r"node \d+ .* inside tool '\w+'")):
            with self.subTest(limit):
                done = self.run_case("--set", limit)
                self.assert_ends(done, code)
                self.assertRegex(done.stderr, rf"\Atowform: stopped at t = [\d.]+ ms, step \d+: .*{what}")
                summary = json.loads((self.out / "summary.json").read_text())
                self.assertEqual(summary["status"], "stopped")
                self.assertEqual(done.stderr, f"towform: {summary['message']}\n")
                with h5py.File(self.out / "results.h5", "r") as file:
                    self.assertEqual(file.attrs["status"], summary["message"])
                    self.assertGreaterEqual(len(file["frames"]), 1)


class Check(Program):
    def test_says_what_a_run_would_do_and_writes_nothing(self):
        before = sorted(self.directory.iterdir())
        done = self.towform("check", self.case)
        self.assert_ends(done, DONE)
        self.assertEqual(done.stderr, "")
        for words in ("A small press: 72 elements", "steps", "tool 'punch': 12 facets", "moves -5 mm", "tool 'table'",
                      "stands"):
            self.assertIn(words, done.stdout)
        self.assertEqual(sorted(self.directory.iterdir()), before)

    def test_takes_overrides(self):
        done = self.towform("check", self.case, "--set", "blank.elements=288", "--set", "title=Finer")
        self.assert_ends(done, DONE)
        self.assertIn("Finer: 288 elements", done.stdout)

    def test_the_cases_that_come_with_it_are_good(self):
        for case in sorted((SOURCE / "cases").glob("*.toml")):
            with self.subTest(case.name):
                self.assert_ends(self.towform("check", case), DONE)


class Info(Program):
    def test_says_what_results_hold(self):
        self.assert_ends(self.run_case(), DONE)
        done = self.towform("info", self.out / "results.h5")
        self.assert_ends(done, DONE)
        self.assertEqual(done.stderr, "")
        for words in ("A small press", "done", "72", "49", "shear_angle", "[deg]", "position z"):
            self.assertIn(words, done.stdout)


class Compare(Program):
    """Against the results' own numbers, read with another library."""

    def setUp(self):
        super().setUp()
        self.assert_ends(self.run_case(), DONE)
        self.results = self.out / "results.h5"
        with h5py.File(self.results, "r") as file:
            triangles, last = file["mesh/triangles"][:], file["frames/0003"]
            self.centres = 1e3 * last["position"][:][triangles].mean(axis=1)  # mm
            self.shear = last["shear_angle"][:]

    def points(self, name, header, rows):
        return self.write(name, "# made up\n" + ",".join(header) + "\n"
                          + "".join(",".join(f"{v:.12g}" for v in row) + "\n" for row in rows))

    def test_a_field_is_judged_and_written(self):
        rows = [(*self.centres[e][:3], self.shear[e] + 0.25) for e in range(0, 72, 5)]
        field = self.points("field.csv", ("x_mm", "y_mm", "z_mm", "shear_deg"), rows)
        done = self.towform("compare", self.results, field, "--tolerance", 0.2501, "-o", "differences.csv")
        self.assert_ends(done, DONE)
        self.assertIn("within tolerance", done.stdout)
        self.assertIn("mean -0.250, RMS 0.250, max 0.250 deg", done.stdout)
        with open(self.directory / "differences.csv", newline="") as file:
            written = list(csv.DictReader(file))
        self.assertEqual(len(written), len(rows))
        for row in written:
            self.assertAlmostEqual(abs(float(row["difference_deg"])), 0.25, delta=1e-5)  # single precision
        done = self.towform("compare", self.results, field, "--tolerance", 0.2499, "--rms", 0.2499)
        self.assert_ends(done, COMPARISON)
        self.assertEqual(done.stderr, "")
        self.assertRegex(done.stdout, r"out of tolerance: largest difference 0\.25 deg \(line \d+\), limit 0\.2499 deg")
        self.assertRegex(done.stdout, r"out of tolerance: RMS 0\.25 deg, limit 0\.2499 deg")

    def test_points_outside_are_named(self):
        outside = self.points("outside.csv", ("x_m", "y_m", "shear_rad"), [(0.0, 0.0, 0.0), (0.1, 0.0, 0.0)])
        done = self.towform("compare", self.results, outside)
        self.assert_ends(done, DONE)
        self.assertRegex(done.stdout, r"\n +4 +100\.000 +0\.000 +0\.000 +outside the sheet\n")
        done = self.towform("compare", self.results, outside, "--tolerance", "90 deg")
        self.assert_ends(done, COMPARISON)
        self.assertIn("1 point(s) outside the sheet: line(s) 4", done.stdout)

    def test_an_outline_a_frame_and_rows_are_chosen(self):
        outline = self.write("outline.csv", "set,x_mm,y_mm\na,30,0\na,0,30\nb,40,0\nb,50,0\n")
        self.assert_refused_to_compare((outline,), FILES, r"outline\.csv:1:1: column `set` tells 2 sets apart, a and b")
        done = self.towform("compare", self.results, outline, "--where", "set=a", "--frame", 0, "--tolerance", "1e-9 mm")
        self.assert_ends(done, DONE)
        self.assertIn("frame 0 of 0 to 3, 0 ms", done.stdout)
        done = self.towform("compare", self.results, outline, "--where", "set=b", "--frame", 0, "--rms", 15.8)
        self.assert_ends(done, COMPARISON)  # 10 and 20 mm away
        self.assertIn("mean -15.000, RMS 15.811, max 20.000 mm (line 5)", done.stdout)

    def test_sections(self):
        section = self.write("section.csv", "arc_mm,shear_deg\n10,0\n50,0\n")
        done = self.towform("compare", self.results, section, "--from=-30,0", "--to", "30 mm,0 mm")
        self.assert_ends(done, DONE)
        self.assertIn("2 of 2 points on the sheet", done.stdout)
        sphere = self.write("sphere.csv", "polar_deg,shear_deg\n1,0\n20,0\n")
        done = self.towform("compare", self.results, sphere, "--centre", "0,0,20", "--to", "0,30")
        self.assert_ends(done, DONE)
        self.assertIn("2 of 2 points on the sheet", done.stdout)

    def assert_refused_to_compare(self, arguments, code, pattern):
        done = self.towform("compare", self.results, *arguments)
        self.assert_ends(done, code)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, pattern)

    def test_what_it_cannot_use(self):
        good = self.write("good.csv", "x_mm,y_mm,shear_deg\n0,0,0\n")
        bad = self.write("bad.csv", "x_mm,y_mm,shear_deg\n0,zero,0\n0,0\n")
        self.assert_refused_to_compare((bad,), FILES, r"bad\.csv:3:1: 2 values for 3 columns")
        self.assert_refused_to_compare(("none.csv",), FILES, r"none\.csv")
        self.assert_refused_to_compare((good, "--frame", 9), FILES, r"there is no frame 9; there are frames 0 to 3")
        self.assert_refused_to_compare((good, "--from", "0,0"), USAGE, r"--from x,y and --to x,y")
        self.assert_refused_to_compare((good, "--from", "0", "--to", "1,2"), USAGE, r"--from: 0 is not x,y")
        self.assert_refused_to_compare((good, "--tolerance", "2 mm"), USAGE, r"--tolerance")
        self.assert_refused_to_compare((good, "--tolerance", "-2"), USAGE, r"--tolerance")
        self.assert_refused_to_compare((good, "--mirror"), USAGE, r"--mirror: the sheet ends neither at x = 0")
        self.assert_refused_to_compare((good, "--where", "shear_deg"), USAGE, r"--where: 'shear_deg' is no condition")
        self.assert_refused_to_compare((good, "--column", "sheer=shear_deg"), USAGE, r"--column")
        done = self.towform("compare", good, good)
        self.assert_ends(done, FILES)
        self.assertRegex(done.stderr, r"good\.csv: cannot be opened")
        self.assert_ends(self.towform("compare", self.results), USAGE)


class Mesh(Program):
    def test_writes_what_a_case_can_use(self):
        done = self.towform("mesh", "hemisphere", "--part", "punch", "--dome-radius", "20 mm", "--opening-radius",
                            "25 mm", "--depth", "10 mm", "--chord-error", "0.2 mm", "-o", "punch.stl")
        self.assert_ends(done, DONE)
        content = (self.directory / "punch.stl").read_bytes()
        facets = struct.unpack_from("<I", content, 80)[0]
        self.assertEqual(len(content), 84 + 50 * facets)
        self.assertIn(f"{facets} facets", done.stdout)
        points = np.frombuffer(content[84:], dtype=np.dtype([("p", "<f4", (4, 3)), ("a", "<u2")]))["p"][:, 1:]
        self.assertAlmostEqual(points[..., 2].min(), 0.0005, delta=1e-7)  # on a sheet 1 mm thick
        self.assertAlmostEqual(np.hypot(points[..., 0], points[..., 1]).max(), 0.02, delta=0.0002)
        self.assert_ends(self.towform("check", self.case, "--set", "tool.punch.position=['20 mm', 0, 0]"), DONE)

    def test_writes_the_meshes_that_come_with_it(self):
        for name in ("hemisphere_holder.stl", "double_dome_punch.stl"):
            shape, part = name[:-4].rsplit("_", 1)
            with self.subTest(name):
                done = self.towform("mesh", shape.replace("_", "-"), "--part", part, "-o", "made.stl")
                self.assert_ends(done, DONE)
                self.assertEqual((self.directory / "made.stl").read_bytes(), (SOURCE / "meshes" / name).read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
