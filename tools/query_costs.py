"""Contact queries of the bench's stored pairs: instructions and accuracy, by thigma_count_queries under callgrind."""
import json
import pathlib
import subprocess
import sys

from call_costs import counted

COUNTER = pathlib.Path(__file__).resolve().parent.parent / "build" / "release" / "thigma_count_queries"


def asked(*words):
    """What the counter says, or None; ends the program where it fails."""
    run = subprocess.run([COUNTER, *map(str, words)], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(run.stderr.strip())
    return json.loads(run.stdout) if run.stdout else None


def prepare(folder, pair, triangles):
    """Builds the models of a pair into a folder, once; `triangles` of each, 0: its own."""
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / f"{pair}.scene.clod").exists():
        asked("prepare", folder, pair, triangles)


def query_cost(folder, pair, path, way):
    """Instructions a query, contacts and pairs looked at (means), and how near it is to the exact query's, where that
    is known."""
    words = (folder, pair, path, way)
    text, instructions, _ = counted("^thigma_counted_query$", [COUNTER, "count", *words])
    count = json.loads(text)
    cost = {"instructions": instructions / count["queries"], "contacts": count["contacts"], "tests": count["tests"]}
    # Of the discs the exact query takes a second a pose.
    return cost if pair == "discs" else {**cost, **asked("quality", *words)}
