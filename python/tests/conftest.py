"""What tests share: the program as a second opinion, meshes whose contacts are known."""

import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import thigma


@pytest.fixture(scope="session")
def program():
    """Runs the program and returns its output; skipped where it was not built."""
    path = os.environ.get("THIGMA_PROGRAM", "")
    if not pathlib.Path(path).is_file():
        pytest.skip("THIGMA_PROGRAM names no program")

    def run(*arguments):
        done = subprocess.run(
            [path, *map(str, arguments), "--quiet"], capture_output=True, text=True, timeout=300
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="session")
def program_json(program):
    return lambda *arguments: json.loads(program(*arguments, "--json"))


def box_arrays(size):
    """A box about the origin, counter-clockwise from outside."""
    corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    triangles = [
        (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
        (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5),
    ]  # fmt: skip
    return 0.5 * np.asarray(size) * np.array(corners, float), np.array(triangles, np.int32)


@pytest.fixture(scope="session")
def box():
    return thigma.Mesh(*box_arrays((0.02, 0.02, 0.02)))


@pytest.fixture(scope="session")
def scene(tmp_path_factory):
    """A small scene that starts at once: a box above a larger one."""
    folder = tmp_path_factory.mktemp("scene")
    thigma.Mesh(*box_arrays((0.02, 0.02, 0.02))).save(folder / "a.obj")
    thigma.Mesh(*box_arrays((0.1, 0.1, 0.02))).save(folder / "b.obj")
    pose = (0, 0, 0.03, 0, 0, 0, 1)
    return thigma.scene_from_pair(
        folder / "a.obj", folder / "b.obj", pose=pose, response="constraint", keep_levels=False
    )
