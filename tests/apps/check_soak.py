"""scripts/soak, shortly: pieces are written, an interrupted run goes on, what is wrong is told."""
import importlib.machinery
import json
import os
import pathlib
import subprocess
import sys
import tempfile

soak, program = sys.argv[1:]
sys.dont_write_bytecode = True


def looks(rate):
    """A look a second, of a rate by the second [bytes a second of CPU time]."""
    seen = [{"cpu": 0.0, "bytes": 0.0}]
    for k in range(80):
        seen.append({"cpu": k + 1.0, "bytes": seen[-1]["bytes"] + rate(k)})
    return seen


# A neighbour that takes half in six of eight windows does not show; one in all of them does, as would a slower program.
fastest = importlib.machinery.SourceFileLoader("soak", soak).load_module().fastest
assert fastest(looks(lambda k: 1000.0 if 20 <= k < 40 else 500.0)) == 1000.0
assert fastest(looks(lambda k: 500.0)) == 500.0
assert fastest(looks(lambda k: 0.0)[:1]) is None
with tempfile.TemporaryDirectory() as folder:
    state = pathlib.Path(folder) / "soak.jsonl"
    scene = pathlib.Path(folder) / "balls.toml"
    ball = 'mesh = "procedural:ball?triangles=320"\n'
    scene.write_text(f"[object]\n{ball}mass = 0.01\n[[static]]\n{ball}[contact]\nexact = true\n")

    def run(seconds):
        command = [sys.executable, soak, str(scene), "--seconds", str(seconds), "--piece", "40", "--state", str(state)]
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "THIGMA_PROGRAM": program})
        return done.returncode, done.stdout + done.stderr

    code, said = run(60)
    assert code == 0, said
    lines = state.read_text().splitlines()
    pieces = [json.loads(line) for line in lines]
    assert len(pieces) == 2, said
    for piece in pieces:
        assert piece["session_seconds"] in (40.0, 20.0), piece
        assert piece["identical"] and piece["frames"] > 0, piece
        assert piece["start"]["memory_mib"] > 1 and piece["end"]["memory_mib"] > 1, piece
        assert piece["start"]["bytes_per_cpu_s"] > 0, piece
    # Goes on where it was, and leaves a line alone that a kill cut off.
    state.write_text("\n".join([lines[0], lines[1][: len(lines[1]) // 2]]) + "\n")
    code, said = run(60)
    assert code == 0, said
    assert len(state.read_text().splitlines()) == 3, said
    # Done already: nothing runs, and the sum is told.
    code, again = run(5)
    assert code == 0 and "piece" in again and len(state.read_text().splitlines()) == 3, again
    # Memory that grew is a fault.
    pieces[1]["end"]["memory_mib"] = 10 * pieces[1]["start"]["memory_mib"] + 100
    state.write_text("\n".join(json.dumps(p) for p in pieces) + "\n")
    assert run(5)[0] == 1
    # So is a rate that fell.
    piece = {**json.loads(lines[0]), "seconds": 100.0}
    piece["end"]["bytes_per_cpu_s"] = 0.8 * piece["start"]["bytes_per_cpu_s"]
    state.write_text(json.dumps(piece) + "\n")
    assert run(5)[0] == 1
    piece["end"]["bytes_per_cpu_s"] = 0.95 * piece["start"]["bytes_per_cpu_s"]
    state.write_text(json.dumps(piece) + "\n")
    assert run(5)[0] == 0
