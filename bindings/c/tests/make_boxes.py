#!/usr/bin/env python3
"""make_boxes.py FOLDER: box.obj, 20 mm, and plate.obj, 100 by 100 by 20 mm, about their centres [m]."""
import pathlib
import sys

FACES = [(1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5), (3, 7, 8), (3, 8, 4), (1, 5, 7), (1, 7, 3),
         (2, 4, 8), (2, 8, 6)]


def corners(x, y, z):
    return [(i * x / 2, j * y / 2, k * z / 2) for k in (-1, 1) for j in (-1, 1) for i in (-1, 1)]


if __name__ == "__main__":
    for name, size in (("box", (0.02, 0.02, 0.02)), ("plate", (0.1, 0.1, 0.02))):
        lines = ["v %r %r %r" % v for v in corners(*size)] + ["f %d %d %d" % f for f in FACES]
        (pathlib.Path(sys.argv[1]) / f"{name}.obj").write_text("\n".join(lines) + "\n")
