"""slurm_test.py TOWFORM SOURCE_DIR, within a Slurm (scripts/slurm-test): 24 short runs, one of them killed while it runs and
one that fails by design; all others are done, none is started twice, and the killed one goes on."""

import json
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "program"))
from harness import Program  # noqa: E402
from harness import PROGRAM  # noqa: E402

RUNS, SLOW, FAILING = 24, 7, 12
FRICTION = [round(0.1 + 0.01 * i, 2) for i in range(RUNS)]
GATES = [1e-9 if i + 1 == FAILING else 0.05 for i in range(RUNS)]
SAFETY = [0.002 if i + 1 == SLOW else 0.9 for i in range(RUNS)]  # many more steps
STUDY = f"""case = "press.toml"
[set]
output.checkpoint = "0.5 s"
[sampling]
method = "list"
[[parameter]]
key = "tool.punch.friction"
values = {FRICTION}
[[parameter]]
key = "gates.yarn_strain"
values = {GATES}
[[parameter]]
key = "time.safety"
values = {SAFETY}
[[response]]
name = "shear"
summary = "shear_angle_max_deg"
"""


def jobs():
    """{name: (job, state)} of Slurm's queue."""
    said = subprocess.run(["squeue", "--noheader", "--format=%j %i %T"], capture_output=True, text=True).stdout
    return {line.split()[0]: tuple(line.split()[1:]) for line in said.splitlines()}


class Slurm(Program):
    def test_24_runs_of_which_one_is_killed_and_one_fails(self):
        study = self.write("many.toml", STUDY)
        out = self.directory / "out"
        child = subprocess.Popen([PROGRAM, "study", study, "--profile", "slurm", "-o", out], cwd=self.directory,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        slow, seen = out / "runs" / f"{SLOW:04d}", set()
        killed = False
        deadline = time.monotonic() + 1500
        while child.poll() is None and time.monotonic() < deadline:
            queue = jobs()
            seen |= {job for job, state in queue.values() if state == "RUNNING"}
            if not killed and (slow / "checkpoint.h5").exists():
                job = next((job for name, (job, _) in queue.items() if name.endswith(f"run={SLOW:04d}")), None)
                self.assertIsNotNone(job, "the slow run is not a job of Slurm")
                subprocess.run(["scancel", "--full", "--signal=KILL", job], check=True)
                killed = True
            time.sleep(0.2)
        said = child.communicate()[0]
        print(said)
        self.assertEqual(child.returncode, 0, said + (out / "snakemake.log").read_text()[-4000:])
        self.assertTrue(killed, "the slow run ended before it could be killed")
        self.assertGreater(len(seen), 1, "runs have not run as jobs of Slurm")
        for number in range(1, RUNS + 1):
            folder = out / "runs" / f"{number:04d}"
            status = json.loads((folder / "status.json").read_text())
            starts = [json.loads(line)["starts"] for line in (folder / "attempts.jsonl").read_text().splitlines() if "starts" in line]
            self.assertEqual(status["exit_code"], 5 if number == FAILING else 0, status)
            self.assertEqual(starts, ["run", "resume"] if number == SLOW else ["run"], f"run {number}")
        self.assertIn("23 of 24 runs done, 1 failed, 0 left", said)
        self.assertIn(f"run {FAILING:04d} failed with exit code 5", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
