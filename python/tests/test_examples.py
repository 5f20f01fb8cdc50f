"""The examples run."""

import os
import pathlib
import subprocess
import sys

import pytest
from conftest import box_arrays

import thigma

examples = pathlib.Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("path", sorted(examples.glob("*.py")), ids=lambda path: path.stem)
def test_example(path, tmp_path):
    pytest.importorskip("matplotlib")
    thigma.Mesh(*box_arrays((40, 40, 40))).save(tmp_path / "upper.obj")
    thigma.Mesh(*box_arrays((200, 200, 20))).save(tmp_path / "lower.obj")
    done = subprocess.run(
        [sys.executable, str(path)],
        cwd=tmp_path,
        env={**os.environ, "MPLBACKEND": "Agg"},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    if path.stem == "contacts_plot":
        assert (tmp_path / "distance.png").stat().st_size > 5000
