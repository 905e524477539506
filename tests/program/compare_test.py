"""Runs `towform compare` as a user does: compare_test.py TOWFORM SOURCE_DIR."""

import csv
import sys
import unittest

import h5py

from harness import COMPARISON, DONE, FILES, Program, USAGE


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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
