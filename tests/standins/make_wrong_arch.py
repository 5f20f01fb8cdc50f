#!/usr/bin/env python3
"""make_wrong_arch.py FILE: a shared library as a 32-bit ARM loader would begin to read it."""
import pathlib
import struct
import sys

identity = b"\x7fELF" + bytes([1, 1, 1]) + bytes(9)  # 32 bits, little end first
shared, arm = 3, 40
head = identity + struct.pack("<HHIIIIIHHHHHH", shared, arm, 1, 0, 52, 0, 0x5000400, 52, 32, 0, 40, 0, 0)
pathlib.Path(sys.argv[1]).write_bytes(head + bytes(4096))
