"""scripts/results' pieces: instructions a call from a callgrind file, and the page of what was measured."""
import sys

sys.path.insert(0, sys.argv[1])
from call_costs import call_costs
from results_page import page, three

# Names are given once; a call's line is followed by its position and what it cost with all it calls.
CALLGRIND = """\
fn=(1) main
cfn=(2) step(int)
calls=3 10
+5 300
cfn=(3) other()
calls=1 2
7 11
fn=(2)
16 20
cfn=(3)
calls=3 2
* 9
fn=(4) elsewhere
cfn=(2)
calls=1 10
-2 50
""".splitlines()
assert call_costs(CALLGRIND) == {"step(int)": (4, 350), "other()": (4, 20)}, call_costs(CALLGRIND)

assert [three(x) for x in (None, 0.0, 1234.5, 99.96, 12.34, 1.234, 0.1234, 0.01234)] == \
    ["", "0", "1,234", "100", "12.3", "1.23", "0.12", "0.012"]

figure = {"p50": 12.34, "p99": 56.78, "p999": None, "max": None}
row = {"name": "jaws, exact", "measurement": "levels-jaws", "unit": "us", "ours": figure, "ratio": 4.0,
       "baseline": {"name": "FCL", "p50": 49.36, "p99": 60.0}, "recall_ours": 1.0, "recall_baseline": 0.03,
       "error_ours": 0.0001, "error_baseline": None}
plain = {**row, "name": "haptic step", "measurement": "haptic-step", "note": "of 16 ticks", "baseline": None, "ratio": None, "recall_ours": None,
         "error_ours": None}
unknown = {**plain, "name": "new thing", "measurement": "not-yet-titled"}
session = {"contact": {"query_cpu_us": figure, "contacts_mean": 3.0}, "haptic": {"step_cpu_us": figure}, "penetration_max": 1e-6,
           "force": {"max": 1.5}, "energy_min": 0.0, "constraint": {}}
asked = {**row, "name": "jaws, exact, as the session asks", "measurement": "proxy-jaws", "baseline": {"name": "point shell", "p50": 6.17, "p99": 56.78},
         "contacts_ours": 3.0, "contacts_baseline": 5.0, "force_error_ours": 0.0, "force_error_baseline": 0.04, "error_baseline": 0.0003,
         "entered_ours": None, "entered_baseline": 0.0002, "note": "4001 frames"}
when = {"date": "2026-01-02", "commit": "abc"}
found = page({
    "bench": {**when, "processor": "some", "machine": {"dependent_adds_ghz": 4.0, "empty_loop_late_us": figure}, "rows": [row, plain, unknown]},
    "proxy": {**when, "rows": [asked, {**asked, "name": "jaws, carried"}]},
    "queries": {**when, "pairs": {"jaws": {"exact": {"instructions": 5_000_000, "contacts": 7.0, "force_error": 0.1,
                                                     "force_step": 0.2, "separation_error": 1e-4}}}},
    "calls": {**when, "functions": {"haptic-step": [17_216, 1_600], "row-solve": None}},
    "sessions": {**when, "scenes": {"jaws": session}}})
for line in ("| jaws, exact | 12.3 / 56.8 us | 5,000 | recall 1.00 (baseline 0.03), separation off by at most 0.01 % | FCL: 49.4 / 60.0 | 4.00 |",
             "Instructions a call, mean of 1,600 calls of `haptic-step`'s quick run: 17,216.",
             "| haptic step | 12.3 / 56.8 us |  |  | of 16 ticks |",
             "| jaws | point shell | 6.17 / 56.8 | 1.00, 1.00 | 5.00 | 0.03 | 0.03 | 0.0400 | 0.02 |",
             "| jaws | exact, as the session asks | 12.3 / 56.8 | 2.00, 1.00 | 3.00 | 1.00 | 0.01 | 0.0000 |  |",
             "jaws: 4001 frames.",
             "## not-yet-titled",  # what has no title is not lost
             "| jaws | exact | 5,000 | 7.00 | 0.100 | 0.200 | 0.0100 |",
             "| jaws | rows: the object stays outside | 12.3 / 56.8 | 12.3 / 56.8 | 3.00 | 0.0010 | 1.50 | 0.00 |"):
    assert line in found.splitlines(), f"{line}\nis not in\n{found}"
assert found.count("| jaws | point shell |") == 1  # once a scene
tables = [line.count("|") for line in found.splitlines() if line.startswith("|")]
assert min(tables) > 2
