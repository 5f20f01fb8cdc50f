#!/usr/bin/env python3
"""Fails when a source includes a room that tools/layers.txt does not allow or a file of another room's inner folder,
and when it lies in no inner folder and has no test of its name."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
source = root / "src" / "thigma"

allowed = {}
for line in (root / "tools" / "layers.txt").read_text().splitlines():
    line = line.split("#")[0].strip()
    if line:
        name, _, rooms = line.partition(":")
        allowed[name] = set(rooms.split())

problems = []
for path in sorted(source.rglob("*.h")) + sorted(source.rglob("*.cpp")):
    relative = path.relative_to(source).as_posix()
    if relative == "thigma.h":  # the front door
        continue
    room = relative.split("/")[0]
    own_rule = allowed.get(relative)
    may = own_rule if own_rule is not None else allowed.get(room)
    if may is None:
        problems.append(f"src/thigma/{relative}: room '{room}' is not in tools/layers.txt")
        continue
    for number, text in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'#include "thigma/(\w+)/([\w/.]+)"', text)
        if not match:
            continue
        other, file = match.group(1), match.group(2)
        if other != room and "/" in file:
            problems.append(f"src/thigma/{relative}:{number}: {other}/{file} is inside another room")
        if own_rule is not None:
            own_header = relative.replace(".cpp", ".h")
            if other in may or f"{other}/{file}" in may or f"{other}/{file}" == own_header:
                continue
        elif other == room or other in may:
            continue
        problems.append(f"src/thigma/{relative}:{number}: {room} may not include {other}/{file}")

for path in sorted(source.rglob("*.cpp")):
    relative = path.relative_to(source)
    test = root / "tests" / relative.parent / (path.stem + "_test.cpp")
    if len(relative.parts) == 2 and not test.exists():
        problems.append(f"src/thigma/{relative.as_posix()}: no tests/{test.relative_to(root / 'tests').as_posix()}")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
