#!/usr/bin/env python3
"""Instructions a call of a function, by valgrind's callgrind: figures that no other job on the machine changes.

  tools/call_costs.py FUNCTION COMMAND...

FUNCTION is a regular expression on names as callgrind demangles them. Prints the mean number of instructions a call,
with all that it calls, and how many calls there were.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

NAMED = re.compile(r"(c?fn)=\((\d+)\)(?: (.*))?")


def call_costs(lines):
    """{name: (calls, instructions with all they call)} of a callgrind file without compressed positions; a function's own
    recursion counts once more a level."""
    names, costs, callee, calls = {}, {}, None, None
    for line in lines:
        if calls is not None:  # the line after calls=: position and inclusive cost
            name = names[callee]
            before = costs.get(name, (0, 0))
            costs[name] = (before[0] + calls, before[1] + int(line.split()[1]))
            calls = None
        elif found := NAMED.match(line):
            kind, key, name = found.groups()
            if name:
                names[key] = name
            if kind == "cfn":
                callee = key
        elif line.startswith("calls="):
            calls = int(line[6:].split()[0])
    return costs


def counted(function, command):
    """What COMMAND prints, the instructions of all calls of what FUNCTION matches, and how many calls there were."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", *map(str, command)],
                             capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}: {(run.stderr.strip().splitlines() or ['failed'])[-1]}")
        with out.open() as lines:
            costs = call_costs(lines)
    pattern = re.compile(function)
    chosen = [cost for name, cost in costs.items() if pattern.search(name)]
    return run.stdout, sum(i for _, i in chosen), sum(n for n, _ in chosen)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    _, instructions, calls = counted(sys.argv[1], sys.argv[2:])
    if calls == 0:
        sys.exit(f"call_costs: nothing matches '{sys.argv[1]}'")
    print(f"{instructions / calls:.0f} instructions a call, {calls} calls")


if __name__ == "__main__":
    main()
