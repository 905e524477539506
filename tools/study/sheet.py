"""Places on a formed sheet: points and sections in plan, and its outline."""

import numpy as np

SAMPLES = 400  # of a section
_CHUNK = 64  # points at a time, to bound memory


def values_at(results, frame, values, points, flat=False):
    """(k,) of the elements' values under the points (k,2) in plan, NaN outside; of several layers the uppermost's. Values
    at nodes (n,) are interpolated."""
    corners = (results.reference if flat else frame.position)[results.triangles]  # (m,3,3)
    a = corners[:, 0, :2]
    u, v = corners[:, 1, :2] - a, corners[:, 2, :2] - a
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    area = np.where(area == 0.0, np.nan, area)
    found = np.full(len(points), np.nan)
    for start in range(0, len(points), _CHUNK):
        p = np.asarray(points[start:start + _CHUNK])[:, None, :] - a[None]
        s = (p[..., 0] * v[:, 1] - p[..., 1] * v[:, 0]) / area
        t = (u[:, 0] * p[..., 1] - u[:, 1] * p[..., 0]) / area
        weights = np.stack([1.0 - s - t, s, t], axis=2)
        with np.errstate(invalid="ignore"):
            inside = (weights > -1e-9).all(axis=2)
        height = np.where(inside, np.einsum("kmc,mc->km", np.nan_to_num(weights), corners[:, :, 2]), -np.inf)
        element = height.argmax(axis=1)
        rows = np.arange(len(element))
        hit = inside[rows, element]
        if len(values) == len(results.triangles):
            here = values[element]
        else:
            here = np.einsum("kc,kc->k", np.nan_to_num(weights[rows, element]), values[results.triangles[element]])
        found[start:start + _CHUNK] = np.where(hit, here, np.nan)
    return found


def along(results, frame, values, section, flat=False):
    """Values along a straight section ((x, y), (x, y)) in plan, where there is sheet."""
    start, end = (np.array(point) for point in section)
    points = start + (end - start) * np.linspace(0.0, 1.0, SAMPLES)[:, None]
    found = values_at(results, frame, values, points, flat)
    return found[np.isfinite(found)]


def outline_edges(results):
    """(k,2) nodes of the edges at the blank's rim, the blank on their left; edges on mirror planes are none."""
    t = results.triangles
    x, y = results.reference[t, 0], results.reference[t, 1]
    area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    t = np.where(area[:, None] > 0.0, t, t[:, ::-1])
    sides = t[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    edges = sides[first[count == 1]]
    symmetry = results.case["blank"].get("symmetry", "none")
    small = 1e-6 * np.ptp(results.reference[:, :2], axis=0).max()
    for axis, names in ((0, ("x", "quarter")), (1, ("y", "quarter"))):
        if symmetry in names:
            edges = edges[~(np.abs(results.reference[edges, axis]) < small).all(axis=1)]
    return edges


def draw_in(results, frame):
    """(k,) mm: how far the nodes of the outline have moved inwards in plan, square to the flat outline; of a node between
    two straight sides the larger of both."""
    edges = outline_edges(results)
    flat = results.reference[:, :2]
    along_edge = flat[edges[:, 1]] - flat[edges[:, 0]]
    inwards = np.stack([-along_edge[:, 1], along_edge[:, 0]], axis=1)
    inwards /= np.linalg.norm(inwards, axis=1)[:, None]
    moved = frame.position[:, :2] - flat
    most = np.full(len(flat), -np.inf)
    for end in range(2):
        np.maximum.at(most, edges[:, end], (moved[edges[:, end]] * inwards).sum(axis=1))
    return 1e3 * most[np.isfinite(most)]
