"""The page of a study: report DIR writes DIR/report.html, one file, with links to the runs' own directories and reports."""

import sys
from pathlib import Path

import jinja2
import numpy as np

from . import figures
from .files import replace_file
from .manifest import Manifest
from .pareto import pareto_set
from .sensitivity import rank_correlations, sobol_indices, varies
from .table import columns_of

SHOWN_BEST = 10


class Outcome:
    """A study's table as its pictures and its page want it."""

    def __init__(self, manifest, columns=None):
        self.manifest, self.runs = manifest, manifest.runs
        self.parameters, self.responses = manifest.parameters, manifest.responses
        self.columns = {column.name: column for column in columns or columns_of(manifest)}
        self.goals = [r for r in self.responses if r.goal]
        self.urls = [self._url(run) for run in self.runs]
        self.done = np.array([state == "done" for state in self.columns["status"].values], bool)
        excess = np.array([[r.excess(v) for v in self.numbers(r.name)] for r in self.responses])
        self.within = self.done & np.isfinite(self._all()).all(axis=1) & (excess <= 0.0).all(axis=0)
        self.best = np.zeros(len(self.runs), bool)
        if self.goals:
            costs = np.stack([(1 if r.goal == "minimise" else -1) * self.numbers(r.name) for r in self.goals], axis=1)
            self.best = pareto_set(np.where(self.within[:, None], costs, np.nan))
        self.colours = [figures.BEST if best else figures.GOOD if within else figures.BEYOND
                        for best, within in zip(self.best, self.within)]
        self.tips = [(url, f"run {run.name}: " + ", ".join(f"{p.label} {p.shown(run.values[p.name])}" for p in self.parameters))
                     for url, run in zip(self.urls, self.runs)]

    def _url(self, run):
        folder = f"runs/{run.name}/"
        return folder + ("report.html" if (self.manifest.directory / folder / "report.html").exists() else "")

    def _all(self):
        return np.stack([self.numbers(r.name) for r in self.responses], axis=1)

    def values(self, parameter):
        return [run.values[parameter.name] for run in self.runs]

    def numbers(self, name):
        """(runs,) with NaN where there is none."""
        return np.array([np.nan if v is None else v for v in self.columns[name].values], float)

    def ranking(self):
        """Runs within the limits, the best of the first goal first; with more goals those of the Pareto set only."""
        if not self.goals:
            return []
        goal = self.goals[0]
        order = np.argsort((1 if goal.goal == "minimise" else -1) * self.numbers(goal.name), kind="stable")
        chosen = self.best if len(self.goals) > 1 else self.within
        return [i for i in order if chosen[i]][:SHOWN_BEST if len(self.goals) == 1 else None]


def measures_of(outcome):
    """(kind, parameters, [(response, [(name of the measure, [Estimate])])]), parameters that are numbers only."""
    manifest = outcome.manifest
    varied = [p for p in outcome.parameters if p.quantitative and len(set(outcome.values(p))) > 1]
    responses = [r for r in outcome.responses if varies(outcome.numbers(r.name)[np.isfinite(outcome.numbers(r.name))])]
    if not varied or not responses or manifest.method == "optimise":  # a search's sample leans to where it searched
        return None
    if manifest.method == "saltelli":
        shape = (-1, len(outcome.parameters) + 2)
        found = [(r, sobol_indices(outcome.numbers(r.name)[manifest.samples].reshape(shape), manifest.seed)) for r in responses]
        return "sobol", outcome.parameters, [(r, [("first order", f), ("total", t)]) for r, (f, t) in found]
    x = np.array([outcome.values(p) for p in varied], float).T
    found = [(r, rank_correlations(x, outcome.numbers(r.name), manifest.seed)) for r in responses]
    found = [(r, [(name, estimates) for name, estimates in zip(("Spearman", "partial rank"), pair)
                  if any(np.isfinite(e.value) for e in estimates)]) for r, pair in found]
    found = [(r, pair) for r, pair in found if pair]  # too few runs say nothing
    return ("rank", varied, found) if found else None


def pictures_of(outcome, measures, chosen=None):
    """{what: SVG}: responses (those chosen, by name), sensitivities, pareto and search, where there is something to show."""
    parameters, method = outcome.parameters, outcome.manifest.method
    if not outcome.done.any():
        return {}
    family = method == "grid" and len(parameters) == 2 and all(p.quantitative for p in parameters)
    pictures = {"responses": figures.families(outcome, chosen) if family else figures.against_parameters(outcome)}
    pictures["coloured"] = not family and bool(outcome.goals or any(r.limits() for r in outcome.responses))
    if measures:
        pictures["sensitivities"] = figures.sensitivities([p.label for p in measures[1]],
                                                          [(r.label, pair) for r, pair in measures[2]])
    if len(outcome.goals) > 1:
        pictures["pareto"] = figures.pareto(outcome)
    if method == "optimise":
        pictures["search"] = figures.search(outcome)
    return pictures


def write_report(manifest):
    outcome = Outcome(manifest)
    measures = measures_of(outcome)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters["number"] = lambda v: "–" if v is None or v != v else f"{v:.4g}" if isinstance(v, float) else v
    states = outcome.columns["status"].values
    page = environment.get_template("report.html.j2").render(
        m=manifest, o=outcome, pictures=pictures_of(outcome, measures), measures=measures, ranking=outcome.ranking(),
        count={state: states.count(state) for state in ("done", "failed", "left")},
        failed=[i for i, state in enumerate(states) if state == "failed"],
        missing=[i for i, (state, why) in enumerate(zip(states, outcome.columns["reason"].values)) if state == "done" and why],
        wall=sum(w for w in outcome.columns["wall_time_s"].values if w),
        versions=sorted({v for v in outcome.columns["version"].values if v}),
        limits=[(r.label, r.limits()) for r in outcome.responses if r.limits()],
        study_text=(manifest.directory / "study.toml").read_text())
    replace_file(manifest.directory / "report.html", page)
    (manifest.directory / "report.html").touch()


if __name__ == "__main__":
    write_report(Manifest.read(Path(sys.argv[1])))
