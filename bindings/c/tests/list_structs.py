#!/usr/bin/env python3
"""list_structs.py HEADER: a C program that prints size and offsets of every plain struct, and the result codes."""
import pathlib
import re
import sys

text = re.sub(r"/\*.*?\*/", "", pathlib.Path(sys.argv[1]).read_text(), flags=re.S)
print('#include <stddef.h>\n#include <stdio.h>\n#include <thigma/thigma_c.h>\nint main(void) {')
for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\}", text, flags=re.S):
    print(f'  printf("struct {name} %zu\\n", sizeof({name}));')
    for field in (d.strip() for d in body.split(";")):
        for member in re.findall(r"\*?\s*(\w+)(?:\[\d+\])?\s*(?:,|$)", field):
            print(f'  printf("  {member} %zu\\n", offsetof({name}, {member}));')
for code in re.findall(r"\b(THIGMA_[A-Z_]+) =", text):
    print(f'  printf("{code} %d\\n", {code});')
print("  return 0;\n}")
