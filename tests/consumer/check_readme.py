#!/usr/bin/env python3
"""Fails when the program in README.md is not the one that is built here."""
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
readme = (here.parent.parent / "README.md").read_text()
program = (here / "main.cpp").read_text()
if f"```cpp\n{program}```" not in readme:
    print("README.md: its first program differs from tests/consumer/main.cpp")
    sys.exit(1)
