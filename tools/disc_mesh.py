#!/usr/bin/env python3
"""Writes a round blank as a Gmsh file (MSH 4.1, ASCII): rings of triangles inside, rings of quadrilaterals outside.

    tools/disc_mesh.py -o meshes/disc.msh                  the blank of cases/disc.toml, lengths in mm
    tools/disc_mesh.py --radius 100 --rings 16 --quadrilaterals 4 -o disc.msh

Ring k of the inside has 6 k nodes, so that its triangles are nearly equilateral; the rings outside keep the number
that the inside ends with.
"""

import argparse
from math import cos, pi, sin


def rings_of_nodes(radius, rings, quadrilaterals):
    """Number of nodes and radius of each ring, the middle first."""
    inside = rings - quadrilaterals
    return [(1, 0.0)] + [(6 * min(k, inside), radius * k / rings) for k in range(1, rings + 1)]


def mesh(radius, rings, quadrilaterals):
    """(nodes, triangles, quads, edge): places, and node numbers from 1."""
    nodes, first = [], []
    for count, r in rings_of_nodes(radius, rings, quadrilaterals):
        first.append(len(nodes) + 1)
        nodes += [(r * cos(2 * pi * i / count), r * sin(2 * pi * i / count)) for i in range(count)]
    inside = rings - quadrilaterals
    node = lambda ring, i: first[ring] + (i % (6 * min(ring, inside)) if ring else 0)
    triangles, quads = [], []
    for k in range(1, inside + 1):
        for sector in range(6):
            for i in range(k):
                a, b = node(k, sector * k + i), node(k, sector * k + i + 1)
                triangles.append((a, b, node(k - 1, sector * (k - 1) + i)))
                if i + 1 < k:
                    triangles.append((b, node(k - 1, sector * (k - 1) + i + 1), node(k - 1, sector * (k - 1) + i)))
    for k in range(inside + 1, rings + 1):
        for i in range(6 * inside):
            quads.append((node(k - 1, i), node(k, i), node(k, i + 1), node(k - 1, i + 1)))
    edge = [(node(rings, i), node(rings, i + 1)) for i in range(6 * inside)]
    return nodes, triangles, quads, edge


def text(nodes, triangles, quads, edge):
    """The file of any flat mesh: places (x, y), and elements and sides of the outline by node numbers from 1."""
    low, high = ([pick(c) for c in zip(*nodes)] for pick in (min, max))
    box = f"{low[0]:.9g} {low[1]:.9g} 0 {high[0]:.9g} {high[1]:.9g} 0"
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat"]
    lines += ["$Entities", "0 1 1 0", f"1 {box} 0 0", f"1 {box} 0 1 1", "$EndEntities"]  # Gmsh itself needs them
    lines += ["$Nodes", f"1 {len(nodes)} 1 {len(nodes)}", f"2 1 0 {len(nodes)}"]
    lines += [str(tag) for tag in range(1, len(nodes) + 1)]
    lines += [f"{x:.9g} {y:.9g} 0" for x, y in nodes]
    blocks = [(1, 1, 1, edge), (2, 1, 2, triangles), (2, 1, 3, quads)]  # dimension, entity, type
    blocks = [block for block in blocks if block[3]]
    total = sum(len(block[3]) for block in blocks)
    lines += ["$EndNodes", "$Elements", f"{len(blocks)} {total} 1 {total}"]
    tag = 0
    for dimension, entity, kind, elements in blocks:
        lines.append(f"{dimension} {entity} {kind} {len(elements)}")
        for element in elements:
            tag += 1
            lines.append(" ".join(map(str, (tag, *element))))
    return "\n".join(lines + ["$EndElements", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--radius", type=float, default=150.0, help="in any unit; the default is in mm")
    parser.add_argument("--rings", type=int, default=30, help="from the middle to the edge")
    parser.add_argument("--quadrilaterals", type=int, default=10, help="how many of the rings, the outermost")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    if not 0 <= arguments.quadrilaterals < arguments.rings:
        parser.error("there must be fewer rings of quadrilaterals than rings")
    with open(arguments.output, "w") as file:
        file.write(text(*mesh(arguments.radius, arguments.rings, arguments.quadrilaterals)))


if __name__ == "__main__":
    main()
