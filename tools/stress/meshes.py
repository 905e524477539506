"""Meshes that nobody should make: blanks with moved nodes or slivers, tools with slivers."""

import numpy as np

from disc_mesh import text
from stress.trials import SEED


def grid(size, squares):
    """Nodes (n,2) and triangles (m,3) of a rectangle from the origin, numbered from 0, with one diagonal a square."""
    nx, ny = squares
    x, y = np.meshgrid(np.linspace(0, size[0], nx + 1), np.linspace(0, size[1], ny + 1))
    a = (np.arange(nx)[None, :] + (nx + 1) * np.arange(ny)[:, None]).ravel()
    b, c, d = a + 1, a + nx + 2, a + nx + 1
    return np.column_stack([x.ravel(), y.ravel()]), np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def jitter(nodes, triangles, fraction, edge):
    """Every node inside moved by up to a fraction of the edge along x and y, those of the outline along it."""
    rng = np.random.default_rng(SEED)
    move = rng.uniform(-fraction * edge, fraction * edge, nodes.shape)
    for axis in (0, 1):
        on_side = (nodes[:, axis] == nodes[:, axis].min()) | (nodes[:, axis] == nodes[:, axis].max())
        move[on_side, axis] = 0.0
    return nodes + move, triangles


def chosen(triangles, share):
    return np.sort(np.random.default_rng(SEED).choice(len(triangles), max(1, round(share * len(triangles))), replace=False))


def slivers(nodes, triangles, height, share=0.05):
    """Some triangles cut in three by a node over the middle of their first edge, at `height` times the edge: one of the
    three is flat."""
    new_nodes, new_triangles = [nodes], []
    cut = chosen(triangles, share)
    for k, t in enumerate(triangles[cut]):
        a, b, c = nodes[t]
        middle, edge = 0.5 * (a + b), b - a
        up = (c - middle) - edge * ((c - middle) @ edge) / (edge @ edge)
        new_nodes.append((middle + height * np.linalg.norm(edge) * up / np.linalg.norm(up))[None])
        new_triangles += [(t[0], t[1], len(nodes) + k), (t[1], t[2], len(nodes) + k), (t[2], t[0], len(nodes) + k)]
    kept = np.delete(triangles, cut, axis=0)
    return np.concatenate(new_nodes), np.concatenate([kept, np.array(new_triangles)])


def write_blank(path, maker, value, size, squares):
    """A quarter blank as a Gmsh file in mm; `size` of the quarter [mm]."""
    nodes, triangles = grid(size, squares)
    if maker == "jitter":
        nodes, triangles = jitter(nodes, triangles, value, size[0] / squares[0])
    else:
        nodes, triangles = slivers(nodes, triangles, value)
    sides = [(1, 2)]  # one line element: Gmsh wants the curve that the file declares
    path.write_text(text(nodes.tolist(), (triangles + 1).tolist(), [], sides))


FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write_sliver_tool(source, path, height):
    """A binary STL with slivers in a twentieth of its facets."""
    data = source.read_bytes()
    corners = np.frombuffer(data, FACET, offset=84)["corners"].astype(float)
    nodes, triangles = slivers(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), height)
    facets = np.zeros(len(triangles), FACET)
    facets["corners"] = nodes[triangles]
    path.write_bytes(data[:80] + np.uint32(len(facets)).tobytes() + facets.tobytes())
