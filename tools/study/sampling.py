"""Which runs a study has: rows of parameter values."""

import itertools
import math
import warnings

from .problems import Refused
from .study_file import MOST_RUNS


def rows_of(study):
    """[{name: value}] of the study's sampling, in order; a row may come twice (a Saltelli sample of few values)."""
    sampling, parameters = study.sampling, study.parameters
    if sampling.method in ("grid", "list"):
        values = [p.values for p in parameters]
        if sampling.method == "grid":
            _bounded(math.prod(len(v) for v in values), study)
        rows = itertools.product(*values) if sampling.method == "grid" else zip(*values)
        return [dict(zip((p.name for p in parameters), row)) for row in rows]
    d = len(parameters)
    _bounded(sampling.runs * (d + 2 if sampling.method == "saltelli" else 1), study)
    points = saltelli(sampling.runs, d, sampling.seed) if sampling.method == "saltelli" else \
        unit_points(sampling.method, sampling.runs, d, sampling.seed)
    return [scaled(parameters, point) for point in points]


def _bounded(runs, study):
    if runs > MOST_RUNS:
        raise Refused(f"{study.path}: has {runs} runs, more than {MOST_RUNS}; use fewer values or runs")


def scaled(parameters, point):
    """Values for a point of the unit cube."""
    return {p.name: p.sampled(u) for p, u in zip(parameters, point)}


def unit_points(method, count, dimensions, seed):
    """(count, dimensions) in [0, 1), of scipy.stats.qmc."""
    from scipy.stats import qmc
    if method == "latin_hypercube":
        return qmc.LatinHypercube(dimensions, seed=seed).random(count)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of counts that are no power of two; the study file's page says so
        return qmc.Sobol(dimensions, scramble=True, seed=seed).random(count)


def saltelli(count, dimensions, seed):
    """The sample of Sobol's indices (Saltelli et al., Comput. Phys. Commun. 181, 2010): for every base point j, rows A_j,
    B_j and, for every parameter i, A_j with the i-th coordinate of B_j."""
    both = unit_points("sobol", count, 2 * dimensions, seed)
    rows = []
    for a, b in zip(both[:, :dimensions], both[:, dimensions:]):
        rows += [a, b]
        for i in range(dimensions):
            mixed = a.copy()
            mixed[i] = b[i]
            rows.append(mixed)
    return rows
