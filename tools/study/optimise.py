"""Looks for the best run: Optuna's tree-structured Parzen estimator, with the limits of the responses as constraints.

Runs are proposed in batches. What a batch proposes follows from the seed, the batch's number and the responses of the
batches before it, and from nothing else: not from the number of jobs, the order in which runs end or where the search was
stopped. So a search that goes on asks again for what it had, and finds it run.
"""

import warnings

import numpy as np

from .manifest import digest_of
from .sampling import scaled, unit_points
from .table import row_of

# A failed run counts as worse than any other, so that the search keeps away from where runs fail.
FAILED_EXCESS = 10.0


def first_rows(study):
    """Parameter values of the runs before the search, spread over the ranges."""
    o = study.optimise
    points = unit_points("latin_hypercube", min(o.initial, o.runs), len(study.parameters), o.seed)
    return [scaled(study.parameters, point) for point in points]


def search(campaign):
    """Runs the whole search; 0 or 75."""
    study, manifest = campaign.study, campaign.manifest
    options, rows = study.optimise, first_rows(study)
    same = manifest.study_digest == digest_of(study)
    texts, prints = campaign.checked(rows)
    if not set(prints) <= {run.fingerprint for run in manifest.runs}:  # another search
        manifest.let_go(set(prints), campaign.force)
    campaign.begin()
    mine = manifest.take(rows, texts, prints)
    code = campaign.run_all()
    batch = 0
    while code == 0 and len(mine) < options.runs and campaign.all_ended():
        batch += 1
        rows = propose(study, mine, manifest, batch, min(options.batch, options.runs - len(mine)))
        known = [next((run for run in manifest.runs if run.values == row), None) for row in rows]
        if same and all(known):
            mine += known
        else:
            mine += manifest.take(rows, *campaign.checked(rows), batch)
        if not campaign.all_ended():
            code = campaign.run_all()
    return code


def propose(study, runs, manifest, batch, wanted):
    """[{name: value}] of the next runs, from the responses of those before."""
    import optuna
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    goal = study.goals[0]
    space = {p.name: optuna.distributions.FloatDistribution(0.0, 1.0) if not p.values else
             optuna.distributions.CategoricalDistribution(list(range(len(p.values)))) for p in study.parameters}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what Optuna calls experimental
        sampler = optuna.samplers.TPESampler(seed=study.optimise.seed + batch, multivariate=True, constant_liar=True,
                                             n_startup_trials=0, constraints_func=lambda trial: trial.user_attrs["excess"])
        search = optuna.create_study(direction=goal.goal.replace("ise", "ize"), sampler=sampler)
        for row, value, excess in _known(study, runs, manifest):
            search.add_trial(optuna.trial.create_trial(
                params={p.name: _position(p, row[p.name]) for p in study.parameters}, distributions=space, value=value,
                user_attrs={"excess": excess}, system_attrs={"constraints": excess}))
        return [{p.name: _value(p, trial.params[p.name]) for p in study.parameters}
                for trial in (search.ask(space) for _ in range(wanted))]


def _position(parameter, value):
    """Where a value is in the unit range, or which of the values it is."""
    if parameter.values:
        return parameter.values.index(value)
    if parameter.log:
        return float(np.clip(np.log(value / parameter.low) / np.log(parameter.high / parameter.low), 0.0, 1.0))
    return float(np.clip((value - parameter.low) / (parameter.high - parameter.low), 0.0, 1.0))


def _value(parameter, position):
    return parameter.values[position] if parameter.values else parameter.sampled(position)


def _known(study, runs, manifest):
    """[(values, objective, [excess of every limited response])] of runs that have ended."""
    goal, limited = study.goals[0], [r for r in study.responses if r.low is not None or r.high is not None]
    sign = 1.0 if goal.goal == "minimise" else -1.0
    found = [(run.values, row_of(manifest, run)[6]) for run in runs]
    worst = sign * max([sign * v[goal.name] for _, v in found if v[goal.name] is not None], default=0.0)
    known = []
    for values, responses in found:
        whole = all(v is not None for v in responses.values())
        excess = [r.excess(responses[r.name]) if whole else FAILED_EXCESS for r in limited] or [0.0 if whole else FAILED_EXCESS]
        known.append((values, responses[goal.name] if whole else worst, excess))
    return known
