"""What a newcomer meets: init, check with a preview, the manual, completion, the schema, progress in JSON."""

import json
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import time
import unittest

import h5py
from harness import DONE, FILES, PROGRAM, SOURCE, USAGE, Program


class Init(Program):
    def test_writes_a_case_that_runs(self):
        self.assert_ends(self.towform("init", "mine"), DONE)
        case = self.directory / "mine/case.toml"
        self.assert_ends(self.towform("check", case), DONE)
        self.assert_ends(self.run_case("--set", "blank.elements=200", "--set", "time.end=20 ms",
                                       "--set", "tool.punch.motion.displacement=-20 mm", case=case), DONE)
        self.assertTrue((self.out / "report.html").is_file())
        self.assertEqual((self.directory / "mine/case.schema.json").read_text(), (SOURCE / "docs/case.schema.json").read_text())
        self.assertTrue(case.read_text().startswith("#:schema case.schema.json\n"))

    def test_overwrites_nothing(self):
        self.write("case.schema.json", "mine")
        self.assert_refused(self.towform("init"), FILES, r"case\.schema\.json: is there already")
        self.assertFalse((self.directory / "case.toml").exists())
        self.assertEqual((self.directory / "case.schema.json").read_text(), "mine")


class Preview(Program):
    def test_shows_the_start_in_a_report(self):
        done = self.towform("check", self.case, "--preview", "look")
        self.assert_ends(done, DONE)
        self.assertIn("wrote look/report.html", done.stdout)
        self.assertRegex(done.stdout, r"estimate: \d+ s of wall time, \d+ MB of memory")
        with h5py.File(self.directory / "look/results.h5") as file:
            self.assertEqual(list(file["frames"]), ["0000"])
            self.assertEqual(file.attrs["status"], "preview: nothing has been computed")
        page = (self.directory / "look/report.html").read_text()
        self.assertIn("A preview: sheet and tools as they start.", page)
        self.assertNotIn("The run goes on", page)
        self.assertNotIn("<h2>Curves</h2>", page)

    def test_replaces_results_only_when_asked(self):
        self.assert_ends(self.run_case(), DONE)
        before = (self.out / "results.h5").read_bytes()
        done = self.towform("check", self.case, "--preview", self.out)
        self.assert_ends(done, FILES)
        self.assertEqual((self.out / "results.h5").read_bytes(), before)
        self.assert_ends(self.towform("check", self.case, "--preview", self.out, "--force"), DONE)
        self.assert_ends(self.towform("check", self.case, "--force"), USAGE)  # of what?

    def test_of_a_specimen_test(self):
        self.assert_ends(self.towform("check", SOURCE / "cases/picture_frame.toml", "--preview", "look"), DONE)


class Papers(Program):
    def test_the_manual_names_every_command_option_and_key(self):
        done = self.towform("manual")
        self.assert_ends(done, DONE)
        manual = done.stdout.replace("\\-", "-")
        for words in (".SS towform run", ".SS towform material predict", ".SS towform mesh double-dome", "--json-progress",
                      ".B material.matrix.wlf_c1", ".B report.locking_angle", "NO_COLOR", ".SH EXIT STATUS"):
            self.assertIn(words, manual)
        for line in done.stdout.splitlines():  # nothing that roff would take for a request of its own
            if line.startswith((".", "'")):
                self.assertRegex(line, r'^\.(\\"|TH|SH|SS|TP|B|I|PP|nf|fi)( |$)')

    def test_the_schema_is_the_one_that_is_kept(self):
        done = self.towform("schema")
        self.assert_ends(done, DONE)
        self.assertEqual(done.stdout, (SOURCE / "docs/case.schema.json").read_text())

    def completed(self, *words):
        """What bash offers for the last of the words."""
        script = (f'source <("{PROGRAM}" completion bash); COMP_WORDS=({" ".join(words)!s}); COMP_CWORD={len(words) - 1}; '
                  "compopt() { :; }; _towform; printf '%s\\n' \"${COMPREPLY[@]}\"")
        return subprocess.run(["bash", "-c", script], capture_output=True, text=True, cwd=self.directory).stdout.split()

    def test_completion_knows_commands_options_and_keys(self):
        self.assertEqual(self.completed("towform", "rep"), ["report"])
        self.assertEqual(self.completed("towform", "material", "p"), ["predict", "press.toml", "punch.stl"])
        self.assertIn("--max-wall", self.completed("towform", "run", "press.toml", "--max"))
        self.assertEqual(self.completed("towform", "run", "press.toml", "--set", "blank.th"), ["blank.thickness="])

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not there (Debian package zsh)")
    def test_zsh_completes_the_same(self):
        """A real zsh on a terminal, with the script where it looks for such."""
        functions = self.directory / "functions"
        functions.mkdir()
        (functions / "_towform").write_text(self.towform("completion", "zsh").stdout)
        bin_ = self.directory / "bin"
        bin_.mkdir()
        (bin_ / "towform").symlink_to(PROGRAM)
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.directory)
            os.execvpe("zsh", ["zsh", "-f", "-i"], {"PATH": f"{bin_}:/usr/bin:/bin", "TERM": "dumb", "HOME": str(self.directory),
                                                    "PS1": "> ", "LC_ALL": "C.UTF-8"})
        self.addCleanup(os.close, terminal)
        self.addCleanup(os.waitpid, pid, 0)
        self.addCleanup(os.kill, pid, signal.SIGKILL)
        seen = ""

        def answer(keys, wanted):
            nonlocal seen
            seen = ""
            os.write(terminal, keys.encode())
            end = time.monotonic() + 20
            while wanted not in seen and time.monotonic() < end:
                if select.select([terminal], [], [], 0.5)[0]:
                    seen += os.read(terminal, 65536).decode(errors="replace").replace("\a", "")
            self.assertIn(wanted, seen, repr(seen))

        # The mark is put together by the shell, so that the echo of the command is not taken for its answer.
        answer(f"fpath=({functions} $fpath); autoload -Uz compinit; compinit -u -D; LISTMAX=999; print rea''dy\n", "ready")
        for typed, wanted in (("towform rep\t", "report "), ("towform material p\t", "predict"),
                              ("towform run press.toml --max-w\t", "--max-wall"),
                              ("towform run press.toml --set blank.th\t", "blank.thickness="),
                              ("towform report --m\t", "--max-size"), ("towform run pre\t", "press.toml"),
                              ("towform completion \t", "for zsh: source"), ("towform sch\t", "schema")):
            answer(typed, wanted)
            answer("\x15print don''e\n", "done")


class Terminal(Program):
    def test_json_progress_is_a_line_an_output(self):
        done = self.run_case("--json-progress")
        self.assert_ends(done, DONE)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["event"] for line in lines], ["progress"] * 13 + ["end"])
        self.assertEqual((lines[0]["fraction"], lines[-1]["fraction"], lines[-1]["status"]), (0.0, 1.0, "done"))
        self.assertEqual(sorted(line["step"] for line in lines), [line["step"] for line in lines])
        self.assertIn("dt_element", lines[5])
        self.assertIn("A small press", (self.out / "run.log").read_text())
        self.assert_ends(self.run_case("--json-progress", "--quiet"), USAGE)

    def on_a_terminal(self, **environment):
        """What a run writes to a terminal."""
        leader, follower = pty.openpty()
        run = subprocess.Popen([PROGRAM, "run", self.case, "-o", self.out, "--force", "--threads", "1", "--set", "blank.elements=800",
                                "--set", "time.safety=0.1"],  # long enough for the bar to move
                               stdout=follower, stderr=subprocess.PIPE, env={**os.environ, "TERM": "xterm", **environment})
        os.close(follower)
        seen = b""
        while True:
            try:
                piece = os.read(leader, 65536)
            except OSError:  # the program has ended
                break
            if not piece:
                break
            seen += piece
        os.close(leader)
        run.stderr.close()
        self.assertEqual(run.wait(), DONE)
        return seen.decode()

    def test_a_terminal_gets_a_bar_and_others_plain_lines(self):
        seen = self.on_a_terminal()
        self.assertRegex(seen, r"\r\[\x1b\[36m#*\x1b\[0m\.*\]  +[\d.]+ %  \d+ s to go")
        plain = self.on_a_terminal(NO_COLOR="1")
        self.assertNotIn("\x1b[36m", plain)
        self.assertRegex(plain, r"\r\[#*\.*\]  +[\d.]+ %")
        piped = self.run_case().stdout
        self.assertNotRegex(piped, r"[\r\x1b]")
        self.assertRegex(piped, r"(?m)^  energy error +[\d.]+ % +of the external work$")
        self.assertTrue(re.search(r"wrote .*report\.html$", piped.strip()), piped)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
