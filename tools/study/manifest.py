"""manifest.json: what a study's directory holds, enough to gather its results without the study file."""

import fcntl
import hashlib
import shutil
from dataclasses import asdict, dataclass, field
from pathlib import Path

from .files import read_json, replace_file, replace_json
from .problems import FILES, Refused
from .study import Parameter, Response

FORMAT = 1


@dataclass
class Run:
    name: str  # of its folder in runs/
    values: dict  # of the parameters
    fingerprint: str  # of its case
    batch: int = 0  # of an optimisation


@dataclass
class Manifest:
    directory: Path
    title: str = ""
    study: str = ""  # path of the study file
    study_digest: str = ""
    case: str = ""  # path of the base case
    program: str = ""
    threads: int = 1
    method: str = ""  # of sampling, or "optimise"
    seed: int = 0
    parameters: list[Parameter] = field(default_factory=list)
    responses: list[Response] = field(default_factory=list)
    runs: list[Run] = field(default_factory=list)
    samples: list[int] = field(default_factory=list)  # run of every row of the sample

    def folder(self, run):
        return self.directory / "runs" / run.name

    def write(self):
        data = {"format": FORMAT, **asdict(self)}
        del data["directory"]
        replace_json(self.directory / "manifest.json", data)

    @classmethod
    def read(cls, directory):
        """None when there is none. Raises Refused when it cannot be read."""
        path = Path(directory) / "manifest.json"
        try:
            data = read_json(path)
        except (ValueError, OSError) as e:
            raise Refused(f"towform: {path}: cannot be read: {e}", FILES) from None
        if data is None:
            return None
        if data.pop("format", None) != FORMAT:
            raise Refused(f"towform: {path}: is of another version of towform; -o takes another directory", FILES)
        manifest = cls(Path(directory), **data)
        manifest.parameters = [Parameter(**p) for p in manifest.parameters]
        manifest.responses = [Response(**r) for r in manifest.responses]
        manifest.runs = [Run(**r) for r in manifest.runs]
        return manifest

    def describe(self, program, study):
        """Takes over what the study says; its runs come with `take`."""
        self.title, self.study, self.case = study.title, str(study.path.resolve()), str(study.case.resolve())
        self.study_digest = digest_of(study)
        self.program, self.threads = str(program), study.threads
        self.method = study.sampling.method if study.sampling else "optimise"
        self.seed = study.sampling.seed if study.sampling else study.optimise.seed
        self.parameters, self.responses = study.parameters, study.responses

    def take(self, rows, texts, fingerprints, batch=0):
        """Adds runs for rows whose case is new, writes their cases; returns the runs of the rows."""
        known = {run.fingerprint: run for run in self.runs}
        highest = max([int(run.name) for run in self.runs], default=0)
        taken = []
        for row, text, fingerprint in zip(rows, texts, fingerprints):
            run = known.get(fingerprint)
            if run is None:
                highest += 1
                run = known[fingerprint] = Run(f"{highest:04d}", row, fingerprint, batch)
                self.runs.append(run)
            self.folder(run).mkdir(parents=True, exist_ok=True)
            replace_file(self.folder(run) / "case.toml", text)
            taken.append(run)
        return taken

    def let_go(self, kept, force):
        """Removes runs that are not in the study any more; refuses when one has been run, unless forced."""
        gone = [run for run in self.runs if run.fingerprint not in kept]
        started = [run for run in gone if (self.folder(run) / "attempts.jsonl").exists()]
        if started and not force:
            raise Refused(f"towform: {self.directory}: holds {len(started)} run{'s' if len(started) > 1 else ''} that the study no "
                          "longer has (another case, other values or other files): --force removes them, -o takes another "
                          "directory", FILES)
        for run in gone:
            shutil.rmtree(self.folder(run), ignore_errors=True)
        self.runs = [run for run in self.runs if run.fingerprint in kept]


def digest_of(study):
    return hashlib.sha256(study.text.encode()).hexdigest()


def hold(directory):
    """The locked file of a directory that is ours or made now. Raises Refused."""
    if directory.exists() and not directory.is_dir():
        raise Refused(f"towform: {directory}: is a file", FILES)
    if directory.exists() and any(directory.iterdir()) and not (directory / ".study.lock").exists():
        raise Refused(f"towform: {directory}: is there and not of a study; -o takes another directory", FILES)
    try:
        directory.mkdir(parents=True, exist_ok=True)
        file = open(directory / ".study.lock", "a")
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise Refused(f"towform: {directory}: is in use by another `towform study`", FILES) from None
    except OSError as e:
        raise Refused(f"towform: {directory}: cannot be written: {e.strerror}", FILES) from None
    return file
