"""Forms cases for the verification, once: a directory that holds the same run already is used as it is."""

import hashlib
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("TOWFORM_PROGRAM", ROOT / "build/release/towform"))


@dataclass(frozen=True)
class Run:
    name: str  # of its directory
    case: str  # under cases/, without .toml
    settings: tuple = ()  # "key.path=value"
    threads: int = 1

    @property
    def file(self):
        return ROOT / "cases" / f"{self.case}.toml"

    @property
    def command(self):
        """As a user types it."""
        settings = "".join(f" --set {shell_word(s)}" for s in self.settings)
        return f"towform run cases/{self.case}.toml --threads {self.threads}{settings}"


def shell_word(text):
    return f"'{text}'" if any(c in text for c in " \"[]*") else text


class Workshop:
    """Where runs are made: a directory for each."""

    def __init__(self, directory):
        self.directory = Path(directory)
        done = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
        self.version = done.stdout.strip()

    def form(self, run):
        """The directory of a run, formed now unless it is there. A run that a gate stops is judged like any other."""
        directory = self.directory / run.name
        case = hashlib.sha256(run.file.read_bytes()).hexdigest()
        stamp = f"{self.version}\n{run.command}\n{case}\n"
        note = directory / "verify.stamp"
        if note.exists() and note.read_text() == stamp and "dirty" not in self.version:
            print(f"{directory} is there", flush=True)
            return directory
        note.unlink(missing_ok=True)
        print(f"forming {directory}: {run.command}", flush=True)
        settings = [word for s in run.settings for word in ("--set", s)]
        done = subprocess.run([PROGRAM, "run", run.file, "-o", directory, "--force", "--threads", str(run.threads), "--quiet",
                               *settings], cwd=ROOT)
        if done.returncode:
            print(f"{directory}: towform ended with exit code {done.returncode}", flush=True)
        note.write_text(stamp)
        return directory
