#!/usr/bin/env python3
"""count_tests.py BUILD CTEST_LOG PRESET: adds up GoogleTest's XML reports and ctest's plain tests.

Prints a line for every failed and every skipped case (with its reason), then "PASSED FAILED SKIPPED"."""
import pathlib
import re
import sys
import xml.etree.ElementTree as tree

build, log, preset = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
passed = failed = skipped = 0
reported = {}  # program: failures in its report
for report in sorted((build / "results").glob("*.xml")):
    reported[report.stem] = 0
    try:
        cases = list(tree.parse(report).iter("testcase"))
    except tree.ParseError:
        print(f"FAILED  {preset} {report.stem}: its report is damaged")
        failed += 1
        reported[report.stem] = 1
        continue
    for case in cases:
        name = f"{preset} {case.get('classname')}.{case.get('name')}"
        if case.find("failure") is not None:
            failed += 1
            reported[report.stem] += 1
            reason = " ".join((case.find("failure").get("message") or "").split())
            print(f"FAILED  {name}: {reason[:300]}")
        elif case.find("skipped") is not None:
            skipped += 1
            message = (case.find("skipped").get("message") or "").strip().splitlines()
            print(f"skipped {name}: {message[-1] if message else 'no reason given'}")
        elif case.get("status") == "run":
            passed += 1

# Tests that are no GoogleTest executables, executables that died before writing a report, and those whose every case passed
# and that a sanitizer failed at the end.
for line in log.read_text(errors="replace").splitlines():
    match = re.match(r"\s*\d+/\d+ Test\s+#\d+: (\S+) \.*\s*(\S.*?)\s+[\d.]+ sec", line)
    if not match:
        continue
    name, result = match.groups()
    if name in reported:
        if "Failed" in result and reported[name] == 0:
            failed += 1
            print(f"FAILED  {preset} {name}: every case passed, the program did not: see {log}")
        continue
    if result.startswith("Passed"):
        passed += 1
    elif "Skipped" in result:
        skipped += 1
        print(f"skipped {preset} {name}: see {log}")
    else:
        failed += 1
        print(f"FAILED  {preset} {name}: {result}")
print(passed, failed, skipped)
