"""A study from its file to its report: what runs there are, what is left to do, and doing it."""

import sys
from collections import Counter

from .cases import fingerprint, resolved_cases
from .files import read_json, replace_file
from .manifest import Manifest, digest_of, hold
from .one_run import can_resume
from .problems import DONE, FILES, Refused
from .sampling import rows_of
from .workflow import profile_folder, run_all


class Campaign:
    def __init__(self, study, arguments, directory):
        self.study, self.program, self.directory = study, arguments.program, directory
        self.force, self.retry, self.quiet, self.jobs = arguments.force, arguments.retry_failed, arguments.quiet, arguments.jobs
        self.profile = profile_folder(arguments.profile) if arguments.profile else None
        # A directory that is not there yet is made when everything was found right.
        self.held = hold(directory) if directory.exists() and not arguments.dry_run else None
        self.manifest = Manifest.read(directory) or Manifest(directory)

    def say(self, text):
        if not self.quiet:
            print(text, flush=True)

    def _checking(self, number, total):
        if not self.quiet and sys.stderr.isatty():
            print(f"\rchecking case {number} of {total}", end="\n" if number == total else "", file=sys.stderr, flush=True)

    def cases(self, rows):
        """(texts, fingerprints) of the rows' cases, checked. A study that is as it was, whose first and last case are as they
        were, is not checked again."""
        manifest = self.manifest
        if manifest.study_digest == digest_of(self.study) and len(manifest.samples) == len(rows) and rows:
            ends = [rows[0], rows[-1]]
            found = [fingerprint(text) for text in resolved_cases(self.program, self.study, ends, lambda *_: None)]
            runs = [manifest.runs[index] for index in manifest.samples]
            files = [manifest.folder(run) / "case.toml" for run in runs]
            if found == [runs[0].fingerprint, runs[-1].fingerprint] and all(file.exists() for file in files):
                return [file.read_text() for file in files], [run.fingerprint for run in runs]
        return self.checked(rows)

    def checked(self, rows):
        """(texts, fingerprints) of the rows' cases, each checked by towform. Raises Refused."""
        texts = resolved_cases(self.program, self.study, rows, self._checking)
        return texts, [fingerprint(text) for text in texts]

    def state_of(self, run):
        status = read_json(self.manifest.folder(run) / "status.json")
        if status is not None:
            return "done" if status["exit_code"] == 0 else "failed"
        return "to go on with" if can_resume(self.manifest.folder(run)) else "to run"

    def all_ended(self):
        return not any(self.state_of(run).startswith("to") for run in self.manifest.runs)

    def plan(self):
        """What `go` would do, in words."""
        from .optimise import first_rows
        study = self.study
        rows = first_rows(study) if study.optimise else rows_of(study)
        _, prints = self.cases(rows)
        known = {run.fingerprint: run for run in self.manifest.runs}
        counts = Counter(self.state_of(known[p]) if p in known else "to run" for p in dict.fromkeys(prints))
        state = ", ".join(f"{count} {name}" for name, count in counts.items())
        if study.optimise:
            print(f"{study.title}: up to {study.optimise.runs} runs of {study.case}, the first {len(rows)} spread ({state}), "
                  f"the rest proposed in batches of {study.optimise.batch}; {study.threads} thread{'s' * (study.threads > 1)} each")
        else:
            print(f"{study.title}: {len(set(prints))} runs of {study.case} ({state}), {study.sampling.method}, "
                  f"{study.threads} thread{'s' * (study.threads > 1)} each")
        for p in study.parameters:
            values = [row[p.name] for row in rows]
            span = f"{p.shown(min(values))} to {p.shown(max(values))}" if p.quantitative else ", ".join(
                dict.fromkeys(p.shown(v) for v in values))
            print(f"  {p.name}: {len({str(v) for v in values})} values, {span}" + (f"  ({p.key})" if p.key else ""))
        print(f"  responses: {', '.join(r.name for r in study.responses)}\n  into {self.directory}")
        return DONE

    def go(self):
        if self.study.optimise:
            from .optimise import search
            code = search(self)
        else:
            rows = rows_of(self.study)
            texts, prints = self.cases(rows)
            self.manifest.let_go(set(prints), self.force)
            self.begin()
            taken = self.manifest.take(rows, texts, prints)
            places = {id(run): index for index, run in enumerate(self.manifest.runs)}
            self.manifest.samples = [places[id(run)] for run in taken]
            code = self.run_all()
        return self._close(code)

    def begin(self):
        """Everything was found right: the directory becomes this study's."""
        self.held = self.held or hold(self.directory)
        if self.retry:
            self._forget_failures()
        self.manifest.describe(self.program, self.study)
        replace_file(self.directory / "study.toml", self.study.text)

    def run_all(self):
        self.manifest.write()
        counts = Counter(self.state_of(run) for run in self.manifest.runs)
        self.say(f"{self.study.title}: {len(self.manifest.runs)} runs: " + ", ".join(f"{n} {name}" for name, n in counts.items()))
        return 0 if self.all_ended() else run_all(self.manifest, self.held, self.profile, self.jobs, self.quiet)

    def _forget_failures(self):
        for run in self.manifest.runs:
            if self.state_of(run) == "failed":
                for name in ("status.json", "ended"):
                    (self.manifest.folder(run) / name).unlink(missing_ok=True)

    def _is_old(self):
        """Whether the table or the page is missing or older than what it is made from."""
        def when(*paths):
            return [path.stat().st_mtime if path.exists() else 0.0 for path in paths]

        sources = when(self.directory / "manifest.json", *self.directory.glob("runs/*/status.json"))
        table, page = when(self.directory / "table.csv", self.directory / "report.html")
        return not max(sources) <= table <= page

    def _close(self, code):
        """The table and the report, also of a study that was stopped; says how it stands."""
        from .report import write_report
        from .table import write_table
        manifest, directory = self.manifest, self.directory
        if not self.all_ended() or self._is_old():
            write_table(manifest)
            write_report(manifest)
        states = {run.name: self.state_of(run) for run in manifest.runs}
        failed = [name for name, state in states.items() if state == "failed"]
        left = [name for name, state in states.items() if state.startswith("to")]
        done = len(states) - len(failed) - len(left)
        self.say(f"{done} of {len(states)} runs done, {len(failed)} failed, {len(left)} left")
        for name in failed:
            status = self._status(name)
            self.say(f"  run {name} failed with exit code {status['exit_code']}: {status['reason']}")
        self.say(f"wrote {directory}/table.csv, table.h5, report.html, manifest.json")
        if code:
            print("towform: stopped by a signal; the same command goes on with the study", file=sys.stderr)
            return code
        if left:
            raise Refused(f"towform: {len(left)} run{'s were' if len(left) > 1 else ' was'} interrupted in every attempt, "
                          f"{directory}/snakemake.log says how; the same command goes on", FILES)
        if failed and not done:
            code = Counter(self._status(name)["exit_code"] for name in failed).most_common(1)[0][0]
            return code if code > 0 else 128 - code  # killed by a signal: as a shell has it
        return DONE

    def _status(self, name):
        return read_json(self.directory / "runs" / name / "status.json")
