#!/usr/bin/env python3
"""make_meshes.py FOLDER: lower.obj, a ball, and upper.obj, a plate below it, in units of 0.24 mm."""
import math
import pathlib
import sys

folder = pathlib.Path(sys.argv[1])
rings, sides, radius = 12, 24, 80.0
vertices = [(0.0, 0.0, radius)]
for i in range(1, rings):
    for j in range(sides):
        polar, turn = math.pi * i / rings, 2.0 * math.pi * j / sides
        vertices.append((radius * math.sin(polar) * math.cos(turn), radius * math.sin(polar) * math.sin(turn),
                         radius * math.cos(polar)))
vertices.append((0.0, 0.0, -radius))
at = lambda i, j: 2 + (i - 1) * sides + j % sides
faces = [(1, at(1, j), at(1, j + 1)) for j in range(sides)]
for i in range(1, rings - 1):
    for j in range(sides):
        faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
faces += [(len(vertices), at(rings - 1, j + 1), at(rings - 1, j)) for j in range(sides)]


def write(name, vertices, faces):
    lines = [f"v {x} {y} {z}" for x, y, z in vertices] + ["f %d %d %d" % face for face in faces]
    (folder / name).write_text("\n".join(lines) + "\n")


write("lower.obj", vertices, faces)
box = [(x, y, z) for z in (-140.0, -100.0) for y in (-300.0, 300.0) for x in (-300.0, 300.0)]
write("upper.obj", box, [(1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5), (3, 7, 8), (3, 8, 4),
                         (1, 5, 7), (1, 7, 3), (2, 4, 8), (2, 8, 6)])
