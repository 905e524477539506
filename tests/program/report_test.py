"""The report of a run: what is in the page, and that its data are those of results.h5."""

import base64
import json
import re
import sys
import unittest
import zlib

import h5py
import numpy as np
from harness import DONE, FILES, USAGE, Program


def blocks(page):
    return dict(re.findall(r'<script type="text/plain" id="block-([^"]+)">([^<]*)</script>', page))


def scene(page):
    return json.loads(re.search(r'<script type="application/json" id="scene">(.*)</script>', page).group(1))


def unpacked(text, row, frame):
    """The 16-bit numbers of a block, as src/report/quantised.hpp says they are packed."""
    data = np.frombuffer(zlib.decompress(base64.b64decode(text)), dtype=np.uint8).astype(np.int64)
    folded = data[: len(data) // 2] | data[len(data) // 2:] << 8
    difference = (folded >> 1) ^ -(folded & 1)
    first = np.cumsum(difference[:frame].reshape(-1, row), axis=0).reshape(1, -1)
    return np.cumsum(np.vstack([first, difference[frame:].reshape(-1, frame)]), axis=0) % 65536


class Page(Program):
    def formed(self, *arguments):
        self.assert_ends(self.run_case(*arguments), DONE)
        return self.out / "report.html"

    def report(self, *arguments):
        done = self.towform("report", self.out, *arguments)
        self.assert_ends(done, DONE)
        return done, (self.out / "report.html").read_text()

    def test_a_run_leaves_a_page_that_needs_nothing_else(self):
        page = self.formed().read_text()
        addresses = re.findall(r'<(?:script|link|img|iframe|a)[^>]*(?:src|href)="([^"]*)"', page)
        self.assertEqual([a for a in addresses if not a.startswith(("#", "data:"))], [])
        for words in ("A small press", "72 elements", "Can it be believed?", "The run went to its end.", "locking angle",
                      "stroke of punch [mm]", "Energy error over external work", "Draw-in", "How much of the blank",
                      "Shear along the section", "[[tool]]", "punch.stl", "towform "):
            self.assertIn(words, page)
        self.assertNotIn("nan", re.sub(r"<script.*", "", page, flags=re.S).lower().split("<h2>curves")[1].split("<h2>papers")[0])

    def test_none_is_written_when_none_is_wanted(self):
        self.assertFalse(self.formed("--set", "output.report=false").exists())

    def test_holds_the_fields_of_the_results_to_half_a_step(self):
        page = self.formed().read_text()
        if "block-position" not in page:
            self.skipTest("built without the 3-D view")
        described, packed = scene(page), blocks(page)
        self.assertEqual(described["frames"], [0, 1, 2, 3])
        self.assertEqual([f["name"] for f in described["fields"]],
                         ["shear_angle", "shear_rate", "curve_index", "thickness", "fibre_strain", "shear_force", "curvature",
                          "clearance", "contact_pressure", "temperature"])
        with h5py.File(self.out / "results.h5") as file:
            for entry in [*described["fields"], {"name": "position", **described["position"]}]:
                offset, step, rows = np.array(entry["offset"]), np.array(entry["step"]), entry["rows"]
                for i, frame in enumerate(sorted(file["frames"])):
                    values = np.asarray(file["frames"][frame][entry["name"]], dtype=float).reshape(rows, -1)
                    if entry.get("constant"):
                        shown = np.broadcast_to(offset, values.shape)
                    else:
                        q = unpacked(packed[entry["block"]], len(offset), rows * len(offset))
                        shown = offset + step * q[i].reshape(rows, -1)
                    self.assertLessEqual(np.max(np.abs(shown - values) - 0.5001 * step), 1e-12, entry["name"])
        tool = described["tools"][0]
        self.assertEqual((tool["name"], tool["direction"]), ("punch", [0.0, 0.0, 1.0]))
        np.testing.assert_allclose(tool["displacement"], [0, -5e-3 / 3, -1e-2 / 3, -5e-3], atol=1e-9)

    def test_leaves_frames_out_until_it_fits(self):
        self.formed("--set", "output.frames=60", "--set", "blank.elements=2000")
        done, page = self.report("--max-size", "0.1")
        if "block-position" not in page:
            self.skipTest("built without the 3-D view")
        kept = len(scene(page)["frames"])
        self.assertLess(kept, 61)
        self.assertIn(f"the 3-D view has {kept} of 61 frames", done.stdout)
        self.assertIn(f"the 3-D view has {kept} of 61 frames", page)
        self.assertEqual(scene(page)["frames"][-1], 60)
        self.assertLess(sum(map(len, blocks(page).values())), 1e5)

    def test_says_what_is_missing(self):
        self.formed()
        (self.out / "summary.json").unlink()
        (self.out / "history.csv").write_text("time_s,step\n1\n")
        (self.directory / "punch.stl").write_bytes((self.directory / "table.stl").read_bytes())
        done, page = self.report()
        for words in ("summary.json: is not there; it is written when a run ends", "history.csv: cannot be read",
                      "The run goes on, or was killed"):
            self.assertIn(words, page)
        if "block-position" in page:
            self.assertIn("tool 'punch' is not shown: ", done.stdout)
            self.assertIn("punch.stl has changed since the run", done.stdout)

    def test_draws_the_points_that_the_case_names(self):
        self.write("measured.csv", "layup,arc_mm,shear_deg\nA,5,1\nA,20,3\nB,5,40\n")
        page = self.formed("--set", "report.reference=measured.csv", "--set", "report.where=layup=A").read_text()
        self.assertRegex(page, r"The sheet and measured.csv: RMS [\d.]+ ° over 2 points")
        self.assertEqual(len(re.findall(r'<circle class="mark series-1" cx="\d+\.\d" cy="\d+\.\d" r="3.2"/>', page)), 2)
        page = self.formed("--set", "report.reference=measured.csv").read_text()
        self.assertRegex(page, r"measured.csv is not drawn: .*layup")  # two sets are not mixed
        self.assertIn("Shear along the section", page)

    def test_is_escaped(self):
        page = self.formed("--set", "title=<b>1 & \"2\"</b><script>alert(1)</script>").read_text()
        self.assertNotIn("<b>1 &", page)
        self.assertNotIn("<script>alert", page)
        self.assertIn("&lt;script&gt;alert(1)", page)

    def test_a_run_that_a_gate_stopped_says_so(self):
        done = self.run_case("--set", "gates.penetration=1e-9")
        self.assertEqual(done.returncode, 6)
        page = (self.out / "report.html").read_text()
        self.assertIn("The run did not go to its end", page)
        self.assertIn('class="badge bad"', page)

    def test_refuses_what_is_no_run(self):
        done = self.towform("report", "none")
        self.assert_refused(done, FILES, r"none: there is no such directory")
        (self.directory / "empty").mkdir()
        self.assert_refused(self.towform("report", "empty"), FILES, r"empty/results\.h5: no such file")
        self.assert_ends(self.towform("report"), USAGE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
