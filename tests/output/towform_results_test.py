"""Reads the results that towform_write_dome wrote with tools/towform_results.py: towform_results_test.py SOURCE_DIR RESULTS_DIR."""

import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

SOURCE, RESULTS = Path(sys.argv[1]), Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tools"))
from towform_results import Results  # noqa: E402


class ResultsTest(unittest.TestCase):
    def setUp(self):
        self.results = Results(RESULTS)

    def test_frames_are_those_of_the_file(self):
        with h5py.File(RESULTS / "results.h5") as file:
            names = sorted(file["frames"])
            self.assertEqual(len(self.results), len(names))
            last = file["frames"][names[-1]]
            np.testing.assert_array_equal(self.results.frame(-1).shear_angle, last["shear_angle"][...])
            self.assertEqual(self.results.frame(-1).time, last.attrs["time"])
        self.assertIs(self.results.at(1e9), self.results.frame(-1))

    def test_a_dataset_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(AttributeError, "no dataset shear_angel"):
            self.results.frame(0).shear_angel

    def test_neighbours_share_an_edge_and_know_each_other(self):
        across, triangles = self.results.neighbours(), self.results.triangles
        element, side = np.nonzero(across >= 0)
        self.assertGreater(len(element), 0)
        for e, k in zip(element, side):
            other = across[e, k]
            self.assertEqual(len(set(triangles[e]) & set(triangles[other])), 2)
            self.assertIn(e, across[other])

    def test_areas_add_up_to_the_blank(self):
        flat = self.results.reference[:, :2]
        size = flat.max(axis=0) - flat.min(axis=0)
        self.assertAlmostEqual(self.results.areas.sum(), size.prod(), delta=1e-9 * size.prod())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
