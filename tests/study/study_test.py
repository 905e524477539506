"""Studies as their users meet them, on Snakemake: study_test.py TOWFORM SOURCE_DIR."""

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
import tomllib
import unittest
from pathlib import Path

import h5py
import numpy as np

from harness import CASE_FILE, DONE, FILES, PROGRAM, Program, SOURCE, USAGE
from study import names
from study.manifest import Manifest
from study.optimise import propose
from study.problems import Refused
from study.study_file import read_study

INTERRUPTED = 75
STUDY = """title = "Friction and gates"
case = "press.toml"
[set]
output.frames = 2
[sampling]
method = "list"
[[parameter]]
key = "tool.punch.friction"
name = "friction"
values = [0.1, 0.2, 0.4]
[[parameter]]
key = "gates.yarn_strain"
values = [0.05, 1e-9, 0.05]
[[response]]
name = "shear"
summary = "shear_angle_max_deg"
goal = "minimise"
[[response]]
name = "force"
history = "force_punch_N"
reduce = "largest"
goal = "minimise"
[[response]]
name = "nowhere"
field = "shear_angle"
point = ["1 m", "1 m"]
[[response]]
name = "draw_in"
outline = "draw_in"
reduce = "max"
"""
SEARCH = """case = "press.toml"
[optimise]
runs = 5
initial = 3
batch = 2
[[parameter]]
key = "tool.punch.friction"
min = 0.0
max = 0.5
[[response]]
name = "shear"
summary = "shear_angle_max_deg"
goal = "minimise"
"""


DERIVED = """[[derived]]
key = "time.end"
formula = "{}"
"""


class Studies(Program):
    def study(self, path, *arguments):
        return self.towform("study", path, "-o", self.out, *arguments)

    def starts(self):
        """How often towform was started, of every run."""
        found = {}
        for path in sorted(self.out.glob("runs/*/attempts.jsonl")):
            found[path.parent.name] = [json.loads(line)["starts"] for line in path.read_text().splitlines() if "starts" in line]
        return found

    def rows(self):
        with open(self.out / "table.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_a_study_runs_ends_in_a_table_and_a_page_and_runs_nothing_twice(self):
        path = self.write("friction.toml", STUDY)
        done = self.study(path)
        self.assert_ends(done, DONE)
        self.assertIn("2 of 3 runs done, 1 failed, 0 left", done.stdout)
        self.assertRegex(done.stdout, r"run 0002 failed with exit code 5: stopped at t = .* gates.yarn_strain")
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows], ["done", "failed", "done"])
        self.assertEqual([row["friction"] for row in rows], ["0.1", "0.2", "0.4"])
        self.assertEqual(rows[1]["exit_code"], "5")
        self.assertEqual(rows[1]["shear [deg]"], "")
        summary = json.loads((self.out / "runs/0003/summary.json").read_text())
        self.assertAlmostEqual(float(rows[2]["shear [deg]"]), summary["shear_angle_max_deg"], places=6)
        with open(self.out / "runs/0003/history.csv", newline="") as file:
            forces = [float(row["force_punch_N"]) for row in csv.DictReader(file)]
        self.assertAlmostEqual(float(rows[2]["force [N]"]), max(forces, key=abs), places=6)
        self.assertAlmostEqual(float(rows[2]["draw_in [mm]"]), max(summary["draw_in_mm"].values()), delta=0.05)
        self.assertEqual(rows[2]["nowhere [deg]"], "")
        self.assertEqual(rows[2]["reason"], "nowhere: no sheet at the point")
        with h5py.File(self.out / "table.h5") as file:
            self.assertEqual(file["table/shear"].attrs["units"], "deg")
            self.assertTrue(np.isnan(file["table/shear"][1]))
            self.assertEqual(f"{file['table/shear'][2]:.10g}", rows[2]["shear [deg]"])
        page = (self.out / "report.html").read_text()
        for words in ("Friction and gates", "Pareto set", "Failed runs", "runs/0003/", "no sheet at the point", "<svg"):
            self.assertIn(words, page)
        self.names_are_those_of_a_run()

        # A run alone, from its own case.
        alone = self.towform("run", self.out / "runs/0001/case.toml", "-o", self.directory / "alone", "--threads", 1, "--quiet")
        self.assert_ends(alone, DONE)
        self.assertEqual((self.directory / "alone/history.csv").read_text(), (self.out / "runs/0001/history.csv").read_text())

        # Again: nothing. Another value: that one. A value less: not without being asked.
        again = self.study(path)
        self.assert_ends(again, DONE)
        self.assertEqual(self.starts(), {f"000{i}": ["run"] for i in (1, 2, 3)})
        path.write_text(STUDY.replace("0.4]", "0.4, 0.5]").replace("0.05]", "0.05, 0.05]"))
        (self.out / "runs/0001/report.html").touch()
        self.assert_ends(self.study(path), DONE)
        self.assertIn('href="runs/0001/report.html"', (self.out / "report.html").read_text())
        self.assertEqual(self.starts(), {f"000{i}": ["run"] for i in (1, 2, 3, 4)})
        self.assertEqual(len(self.rows()), 4)
        path.write_text(STUDY.replace("0.1, ", "").replace("[0.05, ", "["))
        less = self.study(path)
        self.assert_ends(less, FILES)
        self.assertRegex(less.stderr, r"holds 2 runs that the study no longer has .*--force")
        self.assert_ends(self.study(path, "--force", "--quiet"), DONE)
        self.assertEqual(self.starts(), {"0002": ["run"], "0003": ["run"]})
        self.assertEqual([row["run"] for row in self.rows()], ["0002", "0003"])
        # What has failed runs again when asked.
        self.assert_ends(self.study(path, "--retry-failed", "--quiet"), DONE)
        self.assertEqual(len(self.starts()["0002"]), 2)
        self.assertEqual(len(self.starts()["0003"]), 1)

    def names_are_those_of_a_run(self):
        """The lists that responses are checked against."""
        folder = self.out / "runs/0001"

        def flat(table, prefix=""):
            for key, value in table.items():
                yield from flat(value, f"{prefix}{key}.") if isinstance(value, dict) else (prefix + key,)

        given = {key for key in flat(json.loads((folder / "summary.json").read_text())) if not key.startswith("phases_s.")}
        self.assertEqual(given - {"status", "message"}, set(names.SUMMARY))
        columns = (folder / "history.csv").read_text().splitlines()[0].split(",")
        self.assertEqual(sorted(columns), sorted(names.history_columns(tomllib.loads((folder / "case.toml").read_text()))))
        with h5py.File(folder / "results.h5") as file:
            frame = file["frames/0000"]
            self.assertEqual(set(frame), set(names.FIELDS))
            for name, dataset in frame.items():
                self.assertEqual(dataset.shape[1] if dataset.ndim > 1 else 0, len(names.FIELDS[name]), name)
                self.assertEqual(dataset.attrs["units"], names.FIELD_UNITS.get(name, "1"), name)

    def test_a_study_that_is_stopped_goes_on_from_checkpoints(self):
        path = self.write("slow.toml", STUDY.replace("output.frames = 2", "time.safety = 0.001").replace("1e-9", "0.06"))
        child = subprocess.Popen([PROGRAM, "study", path, "-o", self.out, "--jobs", "1"], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True, cwd=self.directory)
        while not list(self.out.glob("runs/*/history.csv")):
            self.assertIsNone(child.poll())
            time.sleep(0.05)
        second = self.study(path)  # meanwhile
        self.assert_ends(second, FILES)
        self.assertIn("is in use by another", second.stderr)
        child.send_signal(signal.SIGINT)
        said = child.communicate()
        self.assertEqual(child.returncode, INTERRUPTED, said)
        self.assertIn("the same command goes on", said[1])
        self.assertEqual(len(list(self.out.glob("runs/*/checkpoint.h5"))), 1, said)
        self.assertTrue((self.out / "report.html").exists())
        self.assert_ends(self.study(path), DONE)
        self.assertEqual(sorted(sum(self.starts().values(), [])), ["resume", "run", "run", "run"])
        self.assertEqual([row["status"] for row in self.rows()], ["done"] * 3)

    def test_a_search_goes_on_to_the_same_runs(self):
        path = self.write("search.toml", SEARCH.replace("runs = 5", "runs = 3"))
        self.assert_ends(self.study(path), DONE)
        manifest, study = Manifest.read(self.out), read_study(PROGRAM, self.write("full.toml", SEARCH))
        proposed = propose(study, manifest.runs, manifest, 1, 2)
        self.assertEqual(proposed, propose(study, manifest.runs, manifest, 1, 2))
        path.write_text(SEARCH)  # as if it had been stopped
        self.assert_ends(self.study(path), DONE)
        runs = Manifest.read(self.out).runs
        self.assertEqual([run.values for run in runs[3:]], proposed)
        self.assertEqual(set(self.starts()), {run.name for run in runs})
        self.assertTrue(all(starts == ["run"] for starts in self.starts().values()))
        self.assertIn("The search", (self.out / "report.html").read_text())


class Refusals(Program):
    def refused(self, text, *patterns, name="bad.toml"):
        with self.assertRaises(Refused) as refused:
            read_study(PROGRAM, str(self.write(name, text)))
        messages = refused.exception.messages
        self.assertEqual(len(messages), len(patterns), messages)
        for message, pattern in zip(messages, patterns):
            self.assertRegex(message, pattern)
        self.assertEqual(refused.exception.code, CASE_FILE)

    def edited(self, *edits):
        text = STUDY
        for old, new in edits:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        return text

    def test_everything_wrong_is_said_at_once_with_its_place(self):
        self.refused(self.edited(('title = "Fr', 'titel = "Fr'), ('"press.toml"', '"pres.toml"'), ('"list"', '"lattice"'),
                                 ("0.4]", '"0.4 N"]'), ('summary = "shear_angle_max_deg"', 'summary = "shear_max"'),
                                 ('reduce = "largest"', 'reduce = "largst"'), ('point = ["1 m", "1 m"]', 'point = ["1 kg", 1]')),
                     r":1:1: unknown key `titel` in a study; did you mean `title`\?", r":2:8: case: .*pres.toml is not there",
                     r":6:10: method: \"lattice\" is not one of them", r":10:11: parameter `friction`: all in one unit",
                     r":16:11: summary: there is no `shear_max`", r":21:10: reduce: there is no `largst`; did you mean `largest`\?",
                     r"response `nowhere`: a place or time is not a length")

    def test_each_of_these(self):
        cases = [
            ([("[sampling]\nmethod = \"list\"\n", "")], r"`sampling` is missing"),
            ([('method = "list"', 'method = "sobol"')], r"runs: is missing, which method `sobol` needs"),
            ([('method = "list"', 'method = "list"\nruns = 3')], r"runs: has no meaning"),
            ([("values = [0.05, 1e-9, 0.05]", "values = [0.05, 1e-9]")], r"as many values of every parameter: friction has 3"),
            ([("values = [0.05, 1e-9, 0.05]", "min = 2\nmax = 1\npoints = 3")], r"min must be less than max"),
            ([("values = [0.05, 1e-9, 0.05]", "min = 0\nmax = 1\nscale = \"log\"\npoints = 3")], r"needs min > 0"),
            ([("values = [0.05, 1e-9, 0.05]", "min = 1")], r"must have values = \[…\], or min and max"),
            ([('key = "gates.yarn_strain"', 'key = "tool.punch.friction"')], r"`tool.punch.friction` is set twice"),
            ([('name = "friction"', 'name = "shear"')], r"response `shear`: a parameter has that name"),
            ([('name = "friction"', 'name = "run"')], r"`run` means something else"),
            ([('name = "draw_in"', 'name = "force"')], r"there are two responses `force`"),
            ([('key = "gates.yarn_strain"', 'name = "gate"')], r"no formula uses it"),
            ([('reduce = "max"', "")], r"reduce: is missing"),
            ([('field = "shear_angle"', 'field = "fibre_strain"')], r"component: is missing: `fibre_strain` has warp, weft"),
            ([('field = "shear_angle"', 'field = "shear_angle"\ncomponent = "x"')], r"`shear_angle` has no `x`; it is one value"),
            ([('outline = "draw_in"', 'outline = "draw_in"\nsummary = "steps"')], r"must have one of summary, history, field"),
            ([('"largest"\ngoal', '"largest"\nmin = 2\nmax = 1\ngoal')], r"min must not be more than max"),
            ([("[[response]]\nname = \"shear\"", "[optimise]\nruns = 3\n[[response]]\nname = \"shear\"")],
             r"exclude each other", r"one response with a goal, not 2"),
            ([("[[response]]", DERIVED.format("fricton + open(1)") + "[[response]]")],
             r"has `open\(1\)`, which is not arithmetic"),
            ([("[[response]]", DERIVED.format("fricton") + "[[response]]")],
             r"`fricton` is not a parameter that is a number; did you mean `friction`\?"),
            ([("output.frames = 2", "output.frames = 2007-01-01")], r"set: output.frames has no value"),
        ]
        for edits, *patterns in cases:
            with self.subTest(edits[0][1]):
                self.refused(self.edited(*edits), *patterns)

    def test_what_towform_says_against_a_case_is_said_of_the_study(self):
        text = self.edited(("0.4]", "-4]"), ("gates.yarn_strain", "gates.yarn_strian"), ("output.frames = 2", "output.frames = 0"))
        path = self.write("bad.toml", text)
        done = self.towform("study", path, "-o", self.out)
        self.assert_refused(done, CASE_FILE, r"bad.toml:4:17: output.frames: ", r"bad.toml:10:21: tool.punch.friction: .*-4",
                            *[r"bad.toml:13:\d+: unknown key `yarn_strian` in \[gates\]; did you mean `yarn_strain`\?"] * 2)
        history = self.write("bad.toml", self.edited(("force_punch_N", "force_pnch_N")))
        self.assert_refused(self.towform("study", history, "-o", self.out), CASE_FILE,
                            r"bad.toml:18:1: history: response `force`: there is no column .*did you mean `force_punch_N`\?")
        formula = self.write("bad.toml", self.edited(
            ("[[response]]", DERIVED.format("1 / (friction - 0.2)") + "[[response]]")))
        self.assert_refused(self.towform("study", formula, "-o", self.out), CASE_FILE,
                            r"bad.toml:16:11: formula: time.end has no value: float division by zero \(friction = 0.2")

    def test_codes_of_what_is_wrong_around_a_study(self):
        path = self.write("friction.toml", STUDY)
        self.assert_refused(self.towform("study", "no.toml"), FILES, r"no.toml: .*no such file|no.toml")
        self.assert_refused(self.towform("study", self.write("bad.toml", "a = = 1")), CASE_FILE, r"bad.toml:1:\d+: ")
        self.assert_ends(self.towform("study"), USAGE)
        self.assert_ends(self.towform("study", path, "--jobs", "0"), USAGE)
        self.assert_refused(self.towform("study", path, "--profile", "slrum"), FILES, r"--profile slrum: is neither slurm nor a folder")
        other = self.directory / "other"
        other.mkdir()
        (other / "thesis.tex").touch()
        done = self.towform("study", path, "-o", other)
        self.assert_ends(done, FILES)
        self.assertIn("is there and not of a study", done.stderr)
        self.assertEqual(os.listdir(other), ["thesis.tex"])
        dry = self.towform("study", path, "-o", self.out, "--dry-run")
        self.assert_ends(dry, DONE)
        self.assertRegex(dry.stdout, r"3 runs of .*press.toml \(3 to run\), list, 1 thread each")
        self.assertFalse(self.out.exists())

    def test_missing_packages_are_named(self):
        words = [("import importlib.util as u, sys; find = u.find_spec; "
                  "u.find_spec = lambda name, *a: None if name in ('snakemake', 'scipy') else find(name, *a); "
                  "sys.argv[1:] = ['towform', 'x.toml']; from study.__main__ import main; sys.exit(main(sys.argv[1:]))")]
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", *words], capture_output=True, text=True)
        self.assertEqual(done.returncode, FILES, done.stderr)
        self.assertRegex(done.stderr, r"apt-get install --no-install-recommends python3-scipy snakemake\n\Z")


class Examples(unittest.TestCase):
    def test_the_studies_of_the_house_are_right(self):
        paths = sorted((SOURCE / "cases" / "studies").glob("*.toml"))
        self.assertGreaterEqual(len(paths), 3)
        for path in paths:
            with self.subTest(path.name):
                read_study(PROGRAM, str(path))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
