"""The report of a run: what is in the page, and that its data are those of results.h5."""

import base64
import fcntl
import json
import re
import subprocess
import sys
import time
import unittest
import zlib

import h5py
import numpy as np
from harness import DONE, FILES, PROGRAM, USAGE, Program


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
                      "The run was killed"):
            self.assertIn(words, page)
        if "block-position" in page:
            self.assertIn("tool 'punch' is not shown: ", done.stdout)
            self.assertIn("punch.stl has changed since the run", done.stdout)

    def test_draws_the_points_that_the_case_names(self):
        self.write("measured.csv", "layup,arc_mm,shear_deg\nA,5,1\nA,20,3\nB,5,40\n")
        page = self.formed("--set", "report.reference=measured.csv", "--set", "report.where=layup=A").read_text()
        self.assertRegex(page, r"The sheet and measured.csv: RMS [\d.]+° over 2 points")
        self.assertEqual(len(re.findall(r'<circle class="mark series-1" cx="\d+\.\d" cy="\d+\.\d" r="3.2"/>', page)), 2)
        page = self.formed("--set", "report.reference=measured.csv").read_text()
        self.assertRegex(page, r"measured.csv is not drawn: .*layup")  # two sets are not mixed
        self.assertIn("Shear along the section", page)

    def test_draws_the_rim_of_a_part_that_goes_on_beyond_its_mirrors(self):
        self.write("rim.csv", "x_mm,y_mm\n30,0\n30,10\n0,30\n")
        page = self.formed("--set", "report.reference=rim.csv", "--set", "blank.symmetry=quarter").read_text()
        self.assertRegex(page, r"The sheet and rim.csv: RMS [\d.]+ mm over 3 points")
        figure = page[page.index("The sheet and rim.csv"):].split("</svg>")[0]
        path = re.search(r'<path class="curve series-0" d="([^"]*)"', figure).group(1)
        at = [tuple(map(float, point)) for point in re.findall(r"([\d.]+) ([\d.]+)", path)]
        left, bottom = min(x for x, _ in at), max(y for _, y in at)
        for (x0, y0), (x1, y1) in (zip(at, at[1:])):  # nothing along the axes
            self.assertFalse(x0 < left + 1 and x1 < left + 1 and abs(y1 - y0) > 5, path)
            self.assertFalse(y0 > bottom - 1 and y1 > bottom - 1 and abs(x1 - x0) > 5, path)

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

    def held(self):
        """The directory as a run holds it that has come no further."""
        self.out.mkdir(exist_ok=True)
        lock = open(self.out / ".towform.lock", "w")
        self.addCleanup(lock.close)
        fcntl.flock(lock, fcntl.LOCK_EX)
        return lock

    def test_waits_for_a_frame_that_is_being_written(self):
        self.formed()
        whole = (self.out / "results.h5").read_bytes()
        half = bytearray(whole)
        half[whole.index(b"OHDR") + 40] ^= 1  # as a reader finds it in the middle of a write
        (self.out / "results.h5").write_bytes(half)
        damaged = self.towform("report", self.out)
        self.assert_ends(damaged, FILES)  # nobody writes: it is damaged, and says so at once
        self.assertNotIn("still writing", damaged.stderr)
        lock = self.held()
        for command in (["report", self.out, "--wait", 60], ["info", self.out / "results.h5"]):
            (self.out / "results.h5").write_bytes(half)
            reader = subprocess.Popen([PROGRAM, *map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            time.sleep(0.3)
            self.assertIsNone(reader.poll(), command)
            (self.out / "results.h5").write_bytes(whole)
            output = reader.communicate(timeout=30)[0]
            self.assertEqual(reader.returncode, DONE, output)
        page = (self.out / "report.html").read_text()
        self.assertIn("The run goes on: what is shown ends at 5 of 5 ms.", page)
        self.assertNotIn("largest shear", page)  # the summary is an earlier run's
        lock.close()
        self.assertIn("The run went to its end.", self.report()[1])

    def test_says_that_a_run_has_not_come_far_enough(self):
        self.held()
        done = self.towform("report", self.out, "--wait", 0.2)
        self.assert_ends(done, FILES)
        self.assertRegex(done.stderr, r"results\.h5: no such file\n.*: a run is still writing there; try again")

    def test_shows_a_run_that_goes_on(self):
        run = subprocess.Popen([PROGRAM, "run", self.case, "-o", self.out, "--threads", "1", "--quiet", "--set", "output.frames=300",
                                "--set", "output.report=false", "--set", "blank.elements=800", "--set", "time.safety=0.1"])
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        while not self.out.is_dir():
            time.sleep(0.01)
        pages = 0
        while run.poll() is None and pages < 5:
            page = self.report("--max-size", 1)[1]
            if run.poll() is None:
                self.assertIn("The run goes on: what is shown ends at", page)
                pages += 1
        self.assertGreater(pages, 0)

    def test_refuses_what_is_no_run(self):
        done = self.towform("report", "none")
        self.assert_refused(done, FILES, r"none: there is no such directory")
        (self.directory / "empty").mkdir()
        self.assert_refused(self.towform("report", "empty"), FILES, r"empty/results\.h5: no such file")
        self.assert_ends(self.towform("report"), USAGE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
