"""Gives the program every bad input of inputs.py: bad_input_test.py TOWFORM EXPECTED [--write].

Each has to end within 5 s in 1 GiB of memory, with the exit code and the words that expected.txt has for it, one line
each: name, exit code, a part of what is said. --write prints such lines as the program has it now, to be read."""

import concurrent.futures
import os
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "program"))
PROGRAM, EXPECTED = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
sys.argv[2:3] = [str(Path(__file__).parents[2])]  # as the harness of the program's tests wants it
from harness import TABLE, box, write_stl  # noqa: E402
from inputs import CASES  # noqa: E402

SECONDS, BYTES = 5, 2**30


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(name):
    """Exit code and words."""
    files, arguments = CASES[name]
    with tempfile.TemporaryDirectory() as folder:
        write_stl(Path(folder) / "punch.stl", box((-0.006, -0.012, 0.0005), (0.006, 0.012, 0.02)))
        write_stl(Path(folder) / "table.stl", TABLE)
        for path, content in files.items():
            (Path(folder) / path).parent.mkdir(exist_ok=True)
            (Path(folder) / path).write_bytes(content)
        done = subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=folder, timeout=SECONDS, preexec_fn=limit,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        err = done.stderr.decode(errors="replace").replace(f"{Path(folder).resolve()}/", "")
        return done.returncode, done.stdout.decode(errors="replace"), err


class BadInput(unittest.TestCase):
    def test_each_is_refused_with_its_reason(self):
        expected = dict((line.split("\t")[0], line.split("\t")[1:]) for line in EXPECTED.read_text().splitlines())
        self.assertGreaterEqual(len(expected), 150)
        self.assertEqual(set(expected), set(CASES))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for name, (code, out, err) in zip(CASES, pool.map(run, CASES)):
                with self.subTest(name):
                    self.assertEqual(code, int(expected[name][0]), out + err)
                    self.assertIn(expected[name][1], err)
                    self.assertEqual(out, "")
                    self.assertNotIn("internal error", err)


if __name__ == "__main__":
    if "--write" in sys.argv:
        for each in CASES:
            try:
                code, out, err = run(each)
            except subprocess.TimeoutExpired:
                code, out, err = "TIMEOUT", "", ""
            print(each, code, (out + err).strip().split("\n")[0].split("; looked in")[0][:160], sep="\t")
    else:
        unittest.main(argv=sys.argv[:1])
