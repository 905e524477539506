"""A report in headless Chromium, used as a reader would: TEST.py TOWFORM SOURCE NODE PACKAGES CHROMIUM PICTURE."""

import json
import subprocess
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np
from harness import DONE, SOURCE, Program

NODE, PACKAGES, CHROMIUM, PICTURE = sys.argv[3:7]


class Browser(Program):
    def test_turns_colours_cuts_plays_and_answers(self):
        self.assert_ends(self.run_case("--set", "blank.elements=288"), DONE)
        with h5py.File(self.out / "results.h5") as file:
            frames = [file["frames"][name] for name in sorted(file["frames"])]
            first, last = frames[0]["position"][...], frames[-1]["position"][...]
            fields = {name: frames[-1][name][...] for name in
                      ("shear_angle", "shear_rate", "thickness", "shear_force", "fibre_strain", "curve_index")}
            spans = {name: np.ptp([frame[name][...] for frame in frames]) for name in fields}
        element = int(np.argmax(np.abs(fields["shear_angle"])))
        self.check(self.seen(1280, 800, "light", str(element)), element, first, last, fields, spans)
        self.seen(390, 844, "dark")

    def seen(self, width, height, scheme, *element):
        """What the browser saw; wherever it looks there is no error, no request and nothing wider than the screen."""
        picture = Path(PICTURE).with_name(f"{Path(PICTURE).stem}_{width}_{scheme}.png")
        done = subprocess.run([NODE, SOURCE / "tests/program/report_browser.mjs", PACKAGES, CHROMIUM, self.out / "report.html",
                               picture, str(width), str(height), scheme, *element], capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        seen = json.loads(done.stdout)
        self.assertEqual((seen["errors"], seen["requests"], seen["ready"], seen["overflow"]), ([], [], "yes", 0))
        self.assertGreater(picture.stat().st_size, 20000)
        return seen

    def check(self, seen, element, first, last, fields, spans):
        # The slider moves the sheet to where results.h5 has it, to a step of the 16 bits.
        step = np.ptp(np.vstack([first, last]), axis=0).max() / 65534
        np.testing.assert_allclose(np.reshape(seen["first"], (-1, 3)), first, atol=step)
        np.testing.assert_allclose(np.reshape(seen["last"], (-1, 3)), last, atol=step)
        self.assertNotEqual(seen["first_time"], seen["last_time"])
        self.assertIn("punch -5.0 mm", seen["last_time"])
        # The field chosen changes the colours.
        self.assertNotEqual(seen["colour"], seen["other_colour"])
        self.assertIn("Shear angle", seen["label"])
        # A click on the element gives its values.
        self.assertEqual(seen["picked"]["element"], element)
        self.assertEqual(seen["picked"]["curve"], 1)
        factors = {"thickness": 1e3, "fibre_strain": 1e2}
        for name, values in fields.items():
            shown = [f"{name}.1", f"{name}.2"] if values.ndim == 2 else [name]
            for part, field in enumerate(shown):
                wanted = values[element, part] if values.ndim == 2 else values[element]
                factor = factors.get(name, 1.0)
                self.assertAlmostEqual(seen["picked"]["values"][field], factor * wanted, msg=field,
                                       delta=factor * (0.51 * spans[name] / 65534 + 1e-6 * abs(wanted)))
        self.assertGreater(seen["cut"], 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
