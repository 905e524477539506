"""Reads the results that towform_write_dome wrote with tools/towform_results.py: towform_results_test.py SOURCE_DIR RESULTS_DIR."""

import base64
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

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

    def test_a_section_follows_the_sheet(self):
        x, size = self.results.frame(-1).position, self.results.reference.max(axis=0) - self.results.reference.min(axis=0)
        low, high = x[:, :2].min(axis=0), x[:, :2].max(axis=0)
        y = 0.5 * (low[1] + high[1]) + 0.013 * size[1]
        section = self.results.section((low[0] - 1.0, y), (high[0] + 1.0, y))
        self.assertGreater(len(section), 5)
        np.testing.assert_allclose(section.points[:, 1], y, atol=1e-12)
        np.testing.assert_allclose(section.ends[1:, 0], section.ends[:-1, 1], atol=1e-12)  # one line without gaps
        self.assertTrue(np.all(np.diff(section.arc) > 0.0))
        for element, ends in zip(section.elements, section.ends):  # each piece lies in its element's plane
            a, b, c = x[self.results.triangles[element]]
            normal = np.cross(b - a, c - a)
            np.testing.assert_allclose((ends - a) @ normal, 0.0, atol=1e-9 * np.linalg.norm(normal))
        half = self.results.section((low[0] - 1.0, y), (0.5 * (low[0] + high[0]), y))
        np.testing.assert_array_equal(half.elements, section.elements[: len(half)])
        with self.assertRaisesRegex(ValueError, "two points"):
            self.results.section((0, 0), (0, 0))

    def test_the_outline_is_one_closed_line_round_the_blank(self):
        lines = self.results.outline(0)
        self.assertEqual(len(lines), 1)
        x, y = lines[0][:, 0], lines[0][:, 1]
        area = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
        self.assertAlmostEqual(area, self.results.areas.sum(), delta=1e-9 * area)  # positive: counter-clockwise

    def test_other_programs_get_the_yarns_of_every_element(self):
        warp, weft = self.results.yarns()
        count = len(self.results.triangles)
        with tempfile.TemporaryDirectory() as folder:
            for name, write in (("abaqus", self.results.write_abaqus), ("calculix", self.results.write_calculix)):
                path = Path(folder) / f"{name}.inp"
                write(path)
                lines = path.read_text().splitlines()
                start = next(i for i, line in enumerate(lines) if line.startswith("*DISTRIBUTION, NAME=yarn_axes"))
                rows = np.array([[float(v) for v in line.split(",")] for line in lines[start + 2: start + 2 + count]])
                np.testing.assert_array_equal(rows[:, 0], np.arange(1, count + 1))
                np.testing.assert_allclose(rows[:, 1:], np.hstack([warp, weft]), atol=1e-6)
            self.results.write_ls_dyna(Path(folder) / "sheet.k")
            text = (Path(folder) / "sheet.k").read_text()
            cards = text.split("*ELEMENT_SHELL_BETA\n")[1].split("*END")[0].splitlines()
            self.assertEqual(len(cards), 2 * count)
            x = self.results.frame(-1).position
            for element in range(0, count, 7):  # turning the first side by BETA about the normal gives the warp
                a, b, c = x[self.results.triangles[element]]
                normal = np.cross(b - a, c - a) / np.linalg.norm(np.cross(b - a, c - a))
                side = (b - a) / np.linalg.norm(b - a)
                beta = np.radians(float(cards[2 * element + 1][64:80]))
                inside = warp[element] - (warp[element] @ normal) * normal  # the made-up yarns leave the elements' planes
                np.testing.assert_allclose(np.cos(beta) * side + np.sin(beta) * np.cross(normal, side),
                                           inside / np.linalg.norm(inside), atol=1e-5)

    def test_a_vtu_file_holds_the_frame(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "sheet.vtu"
            self.results.write_vtu(path)
            arrays = {}
            for array in ElementTree.parse(path).iter("DataArray"):
                raw = base64.b64decode(array.text)
                kind = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "UInt8": "u1"}[array.get("type")]
                self.assertEqual(int.from_bytes(raw[:8], "little"), len(raw) - 8)
                arrays[array.get("Name")] = np.frombuffer(raw[8:], kind)
        np.testing.assert_array_equal(arrays["Points"].reshape(-1, 3), self.results.frame(-1).position)
        np.testing.assert_array_equal(arrays["connectivity"].reshape(-1, 3), self.results.triangles)
        np.testing.assert_array_equal(arrays["shear_angle"], self.results.frame(-1).shear_angle)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
