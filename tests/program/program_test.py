"""Runs the built program as a user does: program_test.py TOWFORM SOURCE_DIR."""

import csv
import json
import re
import struct
import sys
import unittest

import h5py
import numpy as np

from harness import (CASE, CASE_FILE, COMMANDS, CONTACT, DONE, ENERGIES, FIELDS, FILES, HISTORY, Program, PUNCH_LINE,
                     SOURCE, STABILITY, SUMMARY, TABLE, TABLE_LINE, USAGE, write_stl)


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
            "an unknown option": ("run", self.case, "--faster-still"),
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
                         {"results.h5", "results.xdmf", "history.csv", "summary.json", "case.resolved.toml", "run.log",
                          "report.html"})
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

    def test_fast_makes_the_sheet_heavier_unless_it_is_told_how_heavy(self):
        def added(*arguments):
            done = self.towform("check", self.case, *arguments)
            self.assert_ends(done, DONE)
            return float(re.search(r"added by mass scaling ([\d.]+) %", done.stdout)[1])

        self.assertEqual(added(), 0)
        self.assertEqual(added("--fast"), 900)
        self.assertEqual(added("--fast", "--set", "time.mass_scaling=2"), 100)
        self.assertEqual(added("--fast", "--set", "time.mass_scaling=20"), 1900)

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
