#!/usr/bin/env python3
"""Headers that are installed: the front door, those that cmake/installed_headers.txt names, and what they include.

  tools/installed_headers.py           prints them, one a line
  tools/installed_headers.py --check   fails when one lies in an inner folder, there are more than 90, the front door
                                       reaches more than 40, or docs/architecture.md names others
  tools/installed_headers.py --write   writes the list in docs/architecture.md
"""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
source = root / "src"
document = root / "docs" / "architecture.md"
begin, end = "<!-- installed headers -->", "<!-- end -->"


def reached(starts):
    found, todo = set(), list(starts)
    while todo:
        header = todo.pop()
        if header in found:
            continue
        found.add(header)
        todo += re.findall(r'#include "(thigma/[^"]+)"', (source / header).read_text())
    return found


def summary(header):
    """The first sentence of a header's opening comment."""
    lines = []
    for line in (source / header).read_text().splitlines()[1:]:
        if not line.startswith("//"):
            break
        lines.append(line.lstrip("/ ").strip())
    return re.split(r"(?<=[.:])(?<!Sec\.)(?<!Eq\.)(?<!Fig\.) ", " ".join(lines))[0].rstrip(".:")


names = [line.split("#")[0].strip() for line in (root / "cmake" / "installed_headers.txt").read_text().splitlines()]
installed = sorted(reached(["thigma/thigma.h"] + [name for name in names if name]))
if len(sys.argv) < 2:
    print("\n".join(installed))
    sys.exit(0)

door = reached(["thigma/thigma.h"]) - {"thigma/thigma.h"}
table = "\n".join(["", f"{len(installed)} headers; {len(door)} of them (marked *) are reached from `thigma/thigma.h`.", "",
                   "| header | what |", "|---|---|"] +
                  [f"| `{name[7:]}`{' *' if name in door else ''} | {summary(name)} |" for name in installed] + [""])
text = document.read_text() if document.exists() else ""
written = text[:text.index(begin) + len(begin)] + table + text[text.index(end):] if begin in text else None
if sys.argv[1] == "--write":
    document.write_text(written)
    sys.exit(0)
problems = [f"src/{name}: is installed and lies in an inner folder" for name in installed if name.count("/") > 2]
if len(installed) > 90:
    problems.append(f"{len(installed)} headers are installed, expected at most 90")
if len(door) > 40:
    problems.append(f"thigma/thigma.h reaches {len(door)} headers, expected at most 40")
if written is not None and written != text:
    problems.append("docs/architecture.md: the list of installed headers is not the present one; run tools/installed_headers.py --write")
print("\n".join(problems), end="\n" if problems else "")
sys.exit(1 if problems else 0)
