"""How one run of a study ends, with a program that ends as it is told; and what Slurm is understood to say."""

import json
import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from harness import Program, SOURCE

# Stands for towform: notes how it was called, then does what the file `do` says.
FAKE = """#!/bin/sh
echo "$1" >>calls
eval "$(cat do)"
"""


class OneRun(Program):
    def setUp(self):
        super().setUp()
        self.program = self.write("fake", FAKE)
        self.program.chmod(0o755)
        self.folder = self.directory / "0001"
        self.folder.mkdir()
        (self.folder / "case.toml").write_text("")

    def start(self, do, attempt=1):
        self.write("do", do)
        words = ["/usr/bin/python3", "-B", "-m", "study.one_run", self.program, self.folder, "--attempt", attempt, "--attempts", 4]
        return subprocess.Popen(list(map(str, words)), cwd=self.directory, stderr=subprocess.PIPE, text=True,
                                start_new_session=True)

    def code(self, do, attempt=1):
        child = self.start(do, attempt)
        child.communicate()
        return child.returncode

    def wait_for(self, name, child):
        while not (self.directory / name).exists():
            self.assertIsNone(child.poll(), f"it ended before there was a file `{name}`")
            time.sleep(0.02)

    @property
    def status(self):
        path = self.folder / "status.json"
        return json.loads(path.read_text()) if path.exists() else None

    @property
    def calls(self):
        return (self.directory / "calls").read_text().split()

    def test_an_end_is_recorded_and_not_repeated(self):
        self.assertEqual(self.code("exit 0"), 0)
        self.assertEqual((self.status["exit_code"], self.status["reason"]), (0, ""))
        self.assertEqual(self.code("exit 5"), 0)
        self.assertEqual(self.status["exit_code"], 0)
        self.assertEqual(self.calls, ["run"])
        self.assertTrue((self.folder / "ended").exists())

    def test_a_failure_has_its_code_and_reason_and_lets_others_go_on(self):
        self.assertEqual(self.code("echo 'towform: stopped by a gate' >&2; exit 5"), 0)
        self.assertEqual((self.status["exit_code"], self.status["reason"]), (5, "stopped by a gate"))

    def test_an_interrupted_run_has_no_end_and_goes_on_from_its_checkpoint(self):
        self.assertEqual(self.code("touch 0001/checkpoint.h5; exit 75", attempt=4), 75)
        self.assertIsNone(self.status)
        self.assertFalse((self.folder / "ended").exists())
        self.assertEqual(self.code("rm 0001/checkpoint.h5; exit 0"), 0)
        self.assertEqual(self.calls, ["run", "resume"])

    def test_a_bad_checkpoint_starts_anew(self):
        (self.folder / "checkpoint.h5").touch()
        self.assertEqual(self.code('[ "$1" = resume ] && exit 7; rm 0001/checkpoint.h5; exit 0'), 0)
        self.assertEqual(self.calls, ["resume", "run"])
        self.assertEqual(self.status["exit_code"], 0)

    def test_a_killed_run_is_tried_again_until_its_last_attempt(self):
        self.assertEqual(self.code("kill -KILL $$", attempt=3), 75)
        self.assertIsNone(self.status)
        self.assertEqual(self.code("kill -KILL $$", attempt=4), 0)
        self.assertEqual(self.status["exit_code"], -signal.SIGKILL)
        self.assertIn("SIGKILL", self.status["reason"])

    def test_results_that_nobody_lived_to_record_are_not_computed_again(self):
        (self.folder / "summary.json").write_text('{"status": "done"}')
        self.assertEqual(self.code("exit 5"), 0)
        self.assertEqual(self.status["exit_code"], 0)
        self.assertFalse((self.directory / "calls").exists())

    def test_a_signal_reaches_the_program_once_and_its_end_is_waited_for(self):
        child = self.start("trap 'echo int >>signals' INT; trap 'echo term >>signals; touch 0001/checkpoint.h5; sleep 0.3; exit 75' TERM; touch up; "
                           "for i in $(seq 400); do sleep 0.05; done", attempt=4)
        self.wait_for("up", child)
        os.killpg(child.pid, signal.SIGINT)  # as a terminal does, to the whole group
        child.communicate(timeout=60)
        self.assertEqual(child.returncode, 75)
        self.assertEqual((self.directory / "signals").read_text().split(), ["term"])
        self.assertIsNone(self.status)

    def test_two_do_not_run_one_run(self):
        first = self.start("touch up; sleep 0.7; exit 0")
        self.wait_for("up", first)
        self.assertEqual(self.code("sleep 0.7; exit 5"), 0)
        first.communicate()
        self.assertEqual(self.calls, ["run"])


class SlurmStatus(Program):
    """scontrol and sacct are scripts that say what the files `scontrol` and `sacct` hold."""

    def said(self, scontrol, sacct="exit 1"):
        tools = self.directory / "bin"
        tools.mkdir(exist_ok=True)
        for name, text in (("scontrol", scontrol), ("sacct", sacct)):
            (tools / name).write_text(f"#!/bin/sh\n{text}\n")
            (tools / name).chmod(0o755)
        script = SOURCE / "tools" / "study" / "profiles" / "slurm" / "slurm_status.py"
        done = subprocess.run([script, "17"], capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"})
        return done.stdout.strip()

    def test_states(self):
        for state, answer in {"PENDING": "running", "RUNNING": "running", "COMPLETING": "running", "COMPLETED": "success",
                              "FAILED": "failed", "TIMEOUT": "failed", "CANCELLED": "failed", "OUT_OF_MEMORY": "failed",
                              "NODE_FAIL": "failed", "PREEMPTED": "failed"}.items():
            with self.subTest(state):
                self.assertEqual(self.said(f"echo 'JobId=17 JobName=x JobState={state} Reason=None'"), answer)

    def test_a_job_that_is_forgotten_is_looked_for_in_the_accounting(self):
        forgotten = "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1"
        self.assertEqual(self.said(forgotten, "echo FAILED"), "failed")
        self.assertEqual(self.said(forgotten, "echo 'CANCELLED by 0'"), "failed")
        self.assertEqual(self.said(forgotten), "success")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
