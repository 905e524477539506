"""Kills a short run and looks at what is left: crash_test.py TOWFORM SOURCE_DIR FAIL_AT_WRITE.so [KILLS [RANDOM]].

Every kill is by SIGKILL: KILLS of them spread over all changes that the run makes to files ("all" for every one),
before the change or with half of it made, and RANDOM at any moment. Each time results.h5, results.xdmf and
history.csv must open, and the run must go on from its checkpoint to the bytes of one that was never stopped."""

import os
import random
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import h5py

from harness import DONE, FILES, Program, PROGRAM

PRELOAD = Path(sys.argv[3]).resolve()
KILLS = sys.argv[4] if len(sys.argv) > 4 else "6"
RANDOM = int(sys.argv[5]) if len(sys.argv) > 5 else 0
KILLED, CHECKPOINT = -9, 7
# Checkpoints as often as the clock allows: after nearly every step, so that many kills hit one.
OFTEN = ("--set", "output.checkpoint=20 ms")


def numbers(path):
    """Every number of a results file, and its status."""
    with h5py.File(path, "r") as file:
        found = {"status": file.attrs["status"]}
        file.visititems(lambda name, item: found.update({name: item[()].tobytes()})
                        if isinstance(item, h5py.Dataset) else found.update({name: dict(item.attrs)}))
        return found


class Crash(Program):
    def setUp(self):
        super().setUp()
        self.assert_ends(self.run_case(*OFTEN), DONE)
        self.whole = self.directory / "whole"
        self.out.rename(self.whole)

    def start(self, how=None, at=None, count=None, command=None):
        environment = {**os.environ, "LD_PRELOAD": str(PRELOAD)}
        environment |= {name: str(value) for name, value in
                        (("FAIL_HOW", how), ("FAIL_AT", at), ("FAIL_COUNT", count)) if value is not None}
        arguments = command or ["run", self.case, "-o", self.out, "--force", "--threads", "1", "--quiet", *OFTEN]
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=self.directory,
                              env=environment)

    def changes(self, command=None):
        """How many changes a run makes to files; not always the same, as checkpoints follow the clock."""
        count = self.directory / "count"
        self.assert_ends(self.start(count=count, command=command), DONE)
        return int(count.read_text())

    def check_readable(self):
        """What there is can be read; returns how many frames there are."""
        frames = 0
        if (self.out / "results.h5").exists():
            with h5py.File(self.out / "results.h5", "r") as file:
                self.assertIsInstance(file.attrs["status"], str)
                frames = len(file["frames"])
                for frame in file["frames"].values():
                    self.assertTrue(frame.attrs["time"] >= 0.0)
                    for data in frame.values():
                        self.assertEqual(len(data[()]), data.shape[0])
                        self.assertTrue(data.attrs["units"])
        if (self.out / "results.xdmf").exists():
            grids = xml.parse(self.out / "results.xdmf").findall(".//Grid[@GridType='Uniform']")
            self.assertLessEqual(len(grids), frames)
        if (self.out / "history.csv").exists():
            lines = (self.out / "history.csv").read_text().split("\n")
            whole = (self.whole / "history.csv").read_text().split("\n")
            self.assertEqual(lines[:-1], whole[:len(lines) - 1])
        return frames

    def finish(self):
        """Goes on, or starts anew where there is no checkpoint yet, and compares."""
        done = self.towform("resume", self.out, "--threads", 1, "--quiet") if self.out.exists() else None
        if done is None or done.returncode == CHECKPOINT:
            self.assertTrue(done is None or "there is no checkpoint to go on from" in done.stderr, done and done.stderr)
            done = self.run_case(*OFTEN)
        self.assert_ends(done, DONE)
        for name in ("history.csv", "results.xdmf", "case.resolved.toml"):
            self.assertEqual((self.out / name).read_bytes(), (self.whole / name).read_bytes(), name)
        self.assertEqual(numbers(self.out / "results.h5"), numbers(self.whole / "results.h5"))
        left = {path.name for path in self.out.iterdir()}
        self.assertLessEqual({path.name for path in self.whole.iterdir()}, left)
        self.assertFalse({"checkpoint.h5", "checkpoint.previous.h5"} & left)

    def clear(self):
        subprocess.run(["rm", "-rf", self.out], check=True)

    def moments(self, total):
        if KILLS == "all":
            return range(1, total + 1)
        count = int(KILLS)
        return [1 + (2 * i + 1) * total // (2 * count) for i in range(count)]

    def test_killed_at_a_change_of_a_file(self):
        total = self.changes()
        killed = 0
        for at in self.moments(total):
            how = "torn" if at % 2 else "kill"
            with self.subTest(at=at, of=total, how=how):
                self.clear()
                done = self.start(how, at)
                if done.returncode == KILLED:
                    killed += 1
                    self.check_readable()
                self.finish()
        self.assertGreater(killed, 0)
        print(f"killed at {killed} of {total} changes of files", file=sys.stderr)

    def test_killed_while_it_goes_on(self):
        self.assert_ends(self.run_case(*OFTEN, "--max-steps", 300), 75)
        stopped = self.directory / "stopped"
        self.out.rename(stopped)
        command = ["resume", self.out, "--threads", "1", "--quiet"]
        subprocess.run(["cp", "-r", stopped, self.out], check=True)
        total = self.changes(command)
        for at in self.moments(total):
            with self.subTest(at=at, of=total):
                self.clear()
                subprocess.run(["cp", "-r", stopped, self.out], check=True)
                self.start("kill", at, command=command)
                self.assertGreaterEqual(self.check_readable(), 1)
                self.finish()

    def test_on_a_full_disk(self):
        total = self.changes()
        for at in self.moments(total):
            with self.subTest(at=at, of=total):
                self.clear()
                done = self.start("full", at)
                if done.returncode != DONE:
                    self.assert_ends(done, FILES)
                    self.assertRegex(done.stderr, r"\Atowform: (the results are whole, but there is no report: )?\S+: "
                                                  r".*No space left on device")
                self.check_readable()
                self.finish()

    def test_killed_at_any_moment(self):
        begin = time.monotonic()
        self.start()
        seconds = time.monotonic() - begin
        for i in range(RANDOM):
            with self.subTest(i):
                self.clear()
                arguments = ["run", self.case, "-o", self.out, "--force", "--threads", "1", "--quiet", *OFTEN]
                run = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.directory)
                time.sleep(random.uniform(0.0, seconds))
                run.kill()
                run.wait()
                self.check_readable()
                self.finish()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
