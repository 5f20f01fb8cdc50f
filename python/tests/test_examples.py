"""The examples run."""

import os
import pathlib
import re
import subprocess
import sys

import pytest
from conftest import box_arrays

import thigma

examples = pathlib.Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("path", sorted(examples.glob("*.py")), ids=lambda path: path.stem)
def test_example(path, tmp_path):
    pytest.importorskip("gymnasium" if path.stem == "gym_press" else "matplotlib")
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
    if path.stem == "gym_press":
        wanted, has = (float(n) for n in re.findall(r"([\d.]+) N", done.stdout))
        assert has == pytest.approx(wanted, abs=0.3)


def test_the_environment_keeps_gymnasium_s_rules(monkeypatch):
    pytest.importorskip("gymnasium")
    from gymnasium.utils.env_checker import check_env

    monkeypatch.syspath_prepend(str(examples))
    from gym_press import PressEnv

    check_env(PressEnv(seconds=0.2), skip_render_check=True)
