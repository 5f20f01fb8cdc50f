#!/usr/bin/env python3
"""Fails when the programs in README.md are not those of examples/, which are built and run here."""
import pathlib
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent
readme = (root / "README.md").read_text()
missing = [name for name in ("hello.cpp", "two_meshes.cpp")
           if f"```cpp\n{(root / 'examples' / name).read_text()}```" not in readme]
for name in missing:
    print(f"README.md: lacks examples/{name} as it is")
sys.exit(1 if missing else 0)
