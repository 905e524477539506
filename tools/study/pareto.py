"""The runs that no other run beats in everything."""

import numpy as np


def pareto_set(costs):
    """(n,) bool: rows of costs (n, goals), all to be small, that no row dominates; rows with a NaN are not in it."""
    costs = np.asarray(costs, float)
    good = np.isfinite(costs).all(axis=1)
    best = good.copy()
    for i in np.flatnonzero(good):
        better = (costs[good] <= costs[i]).all(axis=1) & (costs[good] < costs[i]).any(axis=1)
        best[i] = not better.any()
    return best
