"""The library as another program's: TEST.py TOWFORM SOURCE CMAKE BUILD, installs what is built, configures, builds and runs
examples/own_law against it."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from harness import CASE_FILE, PROGRAM, SOURCE

CMAKE, BUILD = sys.argv[3:5]
# The table of the example, and its resin: spring [N/m] and relaxation time [s].
ANGLES, WEAVE, SPRING, RELAXATION = np.arange(0, 80, 10), [0, 8, 14, 24, 44, 90, 200, 450], 1e4, 4e-4


def done(*words):
    ended = subprocess.run([*map(str, words)], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


class OwnLaw(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        root = cls.root = Path(cls.temporary.name)
        done(CMAKE, "--install", BUILD, "--prefix", root / "tree")
        done(CMAKE, "-S", SOURCE / "examples/own_law", "-B", root / "build", f"-DCMAKE_PREFIX_PATH={root / 'tree'}")
        done(CMAKE, "--build", root / "build")
        case = root / "tree/share/towform/cases/hemisphere.toml"
        stiff = "material.relaxation_ratio=0.1"  # of the law that is built in: hardly anything is left in its spring
        cls.said = done(root / "build/own_law", case, root / "out", "blank.symmetry=quarter", "blank.elements=1600", stiff)

    def test_the_example_is_short(self):
        self.assertLess(len((SOURCE / "examples/own_law/main.cpp").read_text().splitlines()), 60)

    def test_the_sheet_follows_the_law(self):
        """Of any element N is the weave's, and what the resin can carry at most at the rates there were."""
        with h5py.File(self.root / "out/own/results.h5") as file:
            frames = [file["frames"][name] for name in sorted(file["frames"])]
            angle, force = frames[-1]["shear_angle"][...], frames[-1]["shear_force"][...]
            rate = max(frame["shear_rate"][...].max() for frame in frames)
        resin = force - np.sign(angle) * np.interp(np.abs(angle), ANGLES, WEAVE)
        self.assertGreater(np.abs(angle).max(), 20)
        self.assertLess(np.abs(resin).max(), SPRING * RELAXATION * rate)
        self.assertGreater(np.abs(resin).max(), 10)  # and it carries something
        # Built in, nothing is left at rest; the weave of the table keeps what it has taken up.
        stored = dict(re.findall(r"(\w+) .*?shear_elastic ([\d.]+) J", self.said))
        self.assertGreater(float(stored["own"]), 100 * float(stored["built_in"]))

    def test_its_results_say_whose_law_it_was(self):
        results = self.root / "out/own"
        self.assertIn('own_law = "table and resin, 10 kN/m relaxing in 0.4 ms"', (results / "case.resolved.toml").read_text())
        done(PROGRAM, "report", results)
        again = subprocess.run([PROGRAM, "run", results / "case.resolved.toml", "-o", self.root / "again"], capture_output=True, text=True)
        self.assertEqual(again.returncode, CASE_FILE)
        self.assertRegex(again.stderr, r'law "own" \(table and resin, .*\) belongs to a program')


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
