"""How much each parameter counts for a response, with the uncertainty that the sample leaves.

Sobol's indices from a Saltelli sample: the first-order index is the part of the response's variance that a parameter
explains alone, the total index the part that is lost when all others are known (Jansen, Comput. Phys. Commun. 117, 1999;
Saltelli et al., Comput. Phys. Commun. 181, 2010). Any other sample: Spearman's rank correlation, and the partial rank
correlation, which takes the other parameters' part away first. Intervals come from bootstrap samples: of indices their
percentiles, of correlations from their standard error after Fisher's transformation, since repeated rows make ties, and
those bias a correlation near 1.
"""

import warnings
from dataclasses import dataclass

import numpy as np
from scipy.stats import rankdata

BOOTSTRAPS, CONFIDENCE = 1000, 0.95
_NEARLY_ONE = 1.0 - 1e-6  # correlation beyond which Fisher's transformation is of no use
_CONSTANT = 1e-12  # relative spread below which a response does not vary


@dataclass
class Estimate:
    """A measure of one parameter and the interval that holds it with 95 % confidence."""

    value: float
    low: float
    high: float


def varies(values):
    values = np.asarray(values, float)
    return len(values) > 1 and np.ptp(values) > _CONSTANT * max(np.abs(values).max(), 1e-300)


def sobol_indices(rows, seed=0):
    """([first], [total]) of a response's values at the rows of sampling.saltelli: (base points, parameters + 2), columns A,
    B, AB_1, …. Base points with a NaN are left out; NaN estimates where too few are left or nothing varies."""
    rows = np.asarray(rows, float)
    rows = rows[np.isfinite(rows).all(axis=1)]
    d = rows.shape[1] - 2
    if len(rows) < 4 or not varies(rows.ravel()):
        nothing = [Estimate(np.nan, np.nan, np.nan)] * d
        return nothing, nothing
    picks = np.random.default_rng(seed).integers(0, len(rows), (BOOTSTRAPS, len(rows)))
    value = _indices(rows[None])
    spread = np.concatenate([_indices(rows[chunk]) for chunk in np.array_split(picks, 20)], axis=0)
    low, high = _interval(spread)
    first, total = ([Estimate(value[0, k, i], low[k, i], high[k, i]) for i in range(d)] for k in range(2))
    return first, total


def _indices(rows):
    """(b, 2, d) of samples (b, n, d + 2)."""
    a, b, mixed = rows[:, :, 0, None], rows[:, :, 1, None], rows[:, :, 2:]
    variance = np.concatenate([a, b], axis=1).var(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        first = 1.0 - ((b - mixed) ** 2).mean(axis=1) / (2.0 * variance)
        total = ((a - mixed) ** 2).mean(axis=1) / (2.0 * variance)
    return np.stack([first, total], axis=1)


def rank_correlations(x, y, seed=0):
    """([Spearman], [partial]) of parameters (n, d) with a response (n,), without rows that have a NaN."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    good = np.isfinite(y) & np.isfinite(x).all(axis=1)
    x, y = x[good], y[good]
    d = x.shape[1]
    nothing = [Estimate(np.nan, np.nan, np.nan)] * d
    if len(y) < 4 or not varies(y):
        return nothing, nothing
    partial_too = len(y) > d + 3
    random = np.random.default_rng(seed)
    value = _ranked(x, y, partial_too)
    spread = np.stack([_ranked(x[pick], y[pick], partial_too) for pick in random.integers(0, len(y), (BOOTSTRAPS, len(y)))])
    z = np.arctanh(np.clip(value, -_NEARLY_ONE, _NEARLY_ONE))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of what is NaN throughout
        error = 1.96 * np.nanstd(np.arctanh(np.clip(spread, -_NEARLY_ONE, _NEARLY_ONE)), axis=0)
    low, high = np.minimum(np.tanh(z - error), value), np.maximum(np.tanh(z + error), value)
    spearman, partial = ([Estimate(value[k, i], low[k, i], high[k, i]) for i in range(d)] for k in range(2))
    return spearman, partial


def _interval(spread):
    tail = 50.0 * (1.0 - CONFIDENCE)
    with np.errstate(invalid="ignore"):
        return np.nanpercentile(spread, tail, axis=0), np.nanpercentile(spread, 100.0 - tail, axis=0)


def _correlation(a, b):
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        return (a * b).sum(axis=0) / np.sqrt((a**2).sum(axis=0) * (b**2).sum(axis=0))


def _ranked(x, y, partial_too):
    """(2, d): Spearman's and the partial rank correlations."""
    ranks, response = rankdata(x, axis=0), rankdata(y)
    spearman = _correlation(ranks, response[:, None])
    if not partial_too:
        return np.stack([spearman, np.full_like(spearman, np.nan)])
    partial = np.empty_like(spearman)
    for i in range(x.shape[1]):
        others = np.column_stack([np.ones(len(y)), np.delete(ranks, i, axis=1)])
        both = np.column_stack([ranks[:, i], response])
        rest = both - others @ np.linalg.lstsq(others, both, rcond=None)[0]
        partial[i] = _correlation(rest[:, 0], rest[:, 1])
    return np.stack([spearman, partial])
