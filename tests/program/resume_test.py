"""Interrupts runs and goes on with them as a user or a queue does: resume_test.py TOWFORM SOURCE_DIR."""

import fcntl
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

import h5py

from harness import CASE, DONE, FILES, Program, PROGRAM, USAGE

CHECKPOINT, INTERRUPTED = 7, 75


class Interrupted(Program):
    def stop(self, *arguments, steps=200):
        done = self.run_case("--max-steps", steps, *arguments)
        self.assert_ends(done, INTERRUPTED)
        return done

    def resume(self, *arguments):
        return self.towform("resume", self.out, "--threads", 1, *arguments)

    def start(self, *arguments):
        """A run that takes long enough to be interrupted, once it is stepping."""
        run = subprocess.Popen([PROGRAM, "run", self.case, "-o", self.out, "--threads", "1", "--quiet", "--set",
                                "blank.elements=5000", "--set", "output.frames=100", *arguments], cwd=self.directory,
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (run.kill(), run.wait(), run.stderr.close()))
        while not (self.out / "results.xdmf").exists() and run.poll() is None:
            time.sleep(0.01)
        return run


class Signals(Interrupted):
    def test_the_step_is_ended_and_a_checkpoint_written(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
            with self.subTest(number.name):
                shutil.rmtree(self.out, ignore_errors=True)
                run = self.start()
                run.send_signal(number)
                self.assertEqual(run.wait(60), INTERRUPTED)
                self.assertRegex(run.stderr.read(), rf"\Atowform: stopped by {number.name} at t = [\d.e-]+ ms, step \d+; "
                                                    r"'towform resume \S+' goes on\n\Z")
                self.assertTrue((self.out / "checkpoint.h5").is_file())
                with h5py.File(self.out / "results.h5", "r") as file:
                    self.assertIn(f"stopped by {number.name}", file.attrs["status"])
                self.assert_ends(self.resume("--max-steps", 5, "--quiet"), INTERRUPTED)

    def test_a_second_interrupt_does_not_wait(self):
        run = self.start()
        run.send_signal(signal.SIGSTOP)  # so that both are there before the step ends
        run.send_signal(signal.SIGTERM)
        run.send_signal(signal.SIGINT)
        run.send_signal(signal.SIGCONT)
        self.assertIn(run.wait(60), (-signal.SIGINT, INTERRUPTED))

    def test_a_wall_time_is_a_limit(self):
        run = self.start("--max-wall", "0.3 s")
        self.assertEqual(run.wait(60), INTERRUPTED)
        self.assertIn("stopped by --max-wall", run.stderr.read())

    def test_a_wall_time_must_be_one(self):
        for wrong in ("5 mm", "0", "-3 s", "soon"):
            with self.subTest(wrong):
                done = self.run_case("--max-wall", wrong)
                self.assert_ends(done, USAGE)
                self.assertIn("--max-wall", done.stderr)
                self.assertFalse(self.out.exists())


class Resume(Interrupted):
    def test_checkpoints_come_with_the_clock(self):
        run = self.start("--set", "output.checkpoint=0.1 s")
        while not (self.out / "checkpoint.previous.h5").exists() and run.poll() is None:
            time.sleep(0.01)
        self.assertIsNone(run.poll(), "two checkpoints before its end")
        run.kill()
        run.wait()
        done = self.resume("--max-steps", 1)
        self.assert_ends(done, INTERRUPTED)
        self.assertRegex(done.stdout, r"goes on at t = [\d.e-]+ ms, step \d+")

    def test_what_is_done_is_done(self):
        self.assert_ends(self.run_case(), DONE)
        before = (self.out / "results.h5").read_bytes()
        done = self.resume()
        self.assert_ends(done, DONE)
        self.assertIn("the run is done", done.stdout)
        self.assertEqual((self.out / "results.h5").read_bytes(), before)

    def test_what_lacks_its_report_gets_it(self):
        self.assert_ends(self.run_case(), DONE)
        report = self.out / "report.html"
        report.rename(self.out / "report.html.new")  # killed before it got its name
        self.assert_ends(self.resume(), DONE)
        self.assertTrue(report.exists())
        self.assertFalse((self.out / "report.html.new").exists())

    def test_an_earlier_report_does_not_stay_beside_new_results(self):
        self.assert_ends(self.run_case(), DONE)
        self.assert_ends(self.run_case("--max-steps", 1), INTERRUPTED)
        self.assertFalse((self.out / "report.html").exists())

    def test_the_log_is_one(self):
        self.stop()
        self.assert_ends(self.resume(), DONE)
        log = (self.out / "run.log").read_text()
        self.assertRegex(log, r"(?s)stopped by --max-steps.*goes on at.*done in")

    def test_from_anywhere(self):
        self.stop()
        done = subprocess.run([PROGRAM, "resume", self.out], capture_output=True, text=True, cwd="/")
        self.assert_ends(done, DONE)

    def refuse(self, code, *words):
        done = self.resume()
        self.assert_ends(done, code)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_nothing_to_go_on_from(self):
        self.refuse(FILES, "there is no such directory")
        self.out.mkdir()
        self.refuse(CHECKPOINT, "there is no checkpoint to go on from")

    def test_not_with_another_case_or_mesh(self):
        self.stop()
        for name in ("press.toml", "punch.stl"):
            with self.subTest(name):
                path = self.directory / name
                before = path.read_bytes()
                path.write_bytes(before + b" ")
                self.refuse(CHECKPOINT, f"{name} has changed since the run was started", "--force")
                path.unlink()
                self.refuse(CHECKPOINT, f"{name} is not there any more")
                path.write_bytes(before)
        resolved = self.out / "case.resolved.toml"
        before = resolved.read_text()
        resolved.write_text(before.replace("friction = 0.3", "friction = 0.2"))
        self.refuse(CHECKPOINT, "case.resolved.toml is not the case that the checkpoint belongs to")
        resolved.write_text(before)
        self.assert_ends(self.resume(), DONE)

    def test_from_the_one_before_when_the_newest_is_damaged(self):
        self.stop("--set", "title=Twice")
        self.assert_ends(self.resume("--max-steps", 100), INTERRUPTED)
        newest, before = self.out / "checkpoint.h5", self.out / "checkpoint.previous.h5"
        whole = newest.read_bytes()
        newest.write_bytes(whole[:3000] + b"\0\0\0\0" + whole[3004:])
        done = self.resume("--max-steps", 1)
        self.assert_ends(done, INTERRUPTED)
        self.assertIn("checkpoint.h5: is damaged: its CRC is wrong", done.stdout)
        self.assertIn("checkpoint.previous.h5: going on from this one", done.stdout)
        self.assertRegex(done.stdout, r"goes on at t = [0-9.]+ ms, step 200\n")
        for path in (newest, before):
            path.write_bytes(path.read_bytes()[:-1])
        self.refuse(CHECKPOINT, "checkpoint.h5: is damaged", "checkpoint.previous.h5: is damaged")

    def test_not_when_results_are_not_those_of_the_checkpoint(self):
        self.stop(steps=400)
        history = (self.out / "history.csv").read_text()
        (self.out / "history.csv").write_text(history[:40])
        self.refuse(FILES, "history.csv: has ")


class Directory(Interrupted):
    def test_earlier_results_stay_unless_forced(self):
        self.assert_ends(self.towform("run", self.case, "-o", self.out), DONE)
        before = {path.name: path.read_bytes() for path in self.out.iterdir()}
        done = self.towform("run", self.case, "-o", self.out)
        self.assert_ends(done, FILES)
        self.assertRegex(done.stderr, r"\Atowform: \S+: holds the results of an earlier run: --force .* -o ")
        self.assertEqual({path.name: path.read_bytes() for path in self.out.iterdir()}, before)
        self.assert_ends(self.towform("run", self.case, "-o", self.out, "--force"), DONE)
        self.stop()
        done = self.towform("run", self.case, "-o", self.out)
        self.assert_ends(done, FILES)
        self.assertIn("'towform resume", done.stderr)

    def test_one_run_at_a_time(self):
        run = self.start()
        for command in (("run", self.case, "-o", self.out, "--force"), ("resume", self.out)):
            done = self.towform(*command)
            self.assert_ends(done, FILES)
            self.assertIn(f"is in use by another run (process {run.pid})", done.stderr)
        self.assertIsNone(run.poll())

    def test_a_reader_disturbs_nothing_and_a_writer_is_named(self):
        self.stop()
        with h5py.File(self.out / "results.h5", "r"):
            self.assert_ends(self.resume("--max-steps", 200), INTERRUPTED)
        before = (self.out / "results.h5").read_bytes()
        with open(self.out / "results.h5", "r+b") as file:
            fcntl.flock(file, fcntl.LOCK_EX)  # as HDF5 does where it writes
            for done in (self.resume(), self.run_case()):
                self.assert_ends(done, FILES)
                self.assertIn("results.h5: is open for writing in another program; close it there", done.stderr)
        self.assertEqual((self.out / "results.h5").read_bytes(), before)

    def test_no_room_for_a_frame(self):
        self.stop(steps=100)
        size = (self.out / "results.h5").stat().st_size
        frames = {}
        with h5py.File(self.out / "results.h5", "r") as file:
            frames = {name: frame["position"][()].tobytes() for name, frame in file["frames"].items()}
        done = subprocess.run([PROGRAM, "resume", self.out, "--quiet"], capture_output=True, text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size + 1000, -1)))
        self.assert_ends(done, FILES)
        self.assertRegex(done.stderr, r"results\.h5: no room for \d+ more bytes: File too large")
        with h5py.File(self.out / "results.h5", "r") as file:
            for name, position in frames.items():
                self.assertEqual(file["frames"][name]["position"][()].tobytes(), position)
        self.assert_ends(self.resume(), DONE)

    def towform_as_nobody(self, *arguments):
        """Nothing is denied to root."""
        as_nobody = []
        if os.geteuid() == 0:
            if not shutil.which("setpriv"):
                self.skipTest("root without setpriv")
            as_nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        for path in (self.directory, *self.directory.iterdir()):
            path.chmod(path.stat().st_mode | (0o555 if path.is_dir() else 0o444))
        done = subprocess.run([*as_nobody, PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                              cwd=self.directory)
        if "failed to execute" in done.stderr:
            self.skipTest("the program cannot be seen by another user")
        return done

    def test_denied_directories_and_files(self):
        self.stop()
        before = {path.name: path.read_bytes() for path in self.out.iterdir()}
        locked = self.directory / "locked"
        locked.mkdir(mode=0o555)
        for arguments, words in ((("run", self.case, "-o", locked), "locked: cannot be written: Permission denied"),
                                 (("run", self.case, "-o", locked / "new"), "Permission denied"),
                                 (("resume", self.out), "results: cannot be written: Permission denied"),
                                 (("run", self.case, "-o", self.out, "--force"), "Permission denied")):
            with self.subTest(arguments[0]):
                done = self.towform_as_nobody(*arguments)
                self.assert_ends(done, FILES)
                self.assertIn(words, done.stderr)
        self.assertEqual({path.name: path.read_bytes() for path in self.out.iterdir()}, before)
        self.case.chmod(0)
        self.addCleanup(self.case.chmod, 0o644)


class Implicit(Interrupted):
    def test_goes_on_to_the_same_history(self):
        text = CASE[:CASE.index("[[tool]]")].replace("elements = 72", 'elements = 16\nelement = "quadrilateral"')
        text = 'solver = "implicit"\n' + text + """[[boundary]]
name = "frame"
kind = "picture_frame"
motion = { displacement = "10 mm" }
[time]
end = "10 s"
[output]
frames = 3
history = 10
"""
        self.case.write_text(text)
        self.assert_ends(self.run_case(), DONE)
        whole = (self.out / "history.csv").read_bytes()
        self.stop(steps=40)
        self.assert_ends(self.resume(), DONE)
        self.assertEqual((self.out / "history.csv").read_bytes(), whole)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
