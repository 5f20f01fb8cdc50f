"""Textures: baked, kept, and how deep they are in each other."""

import json

import numpy as np
import pytest
from conftest import box_arrays

import thigma


def plate(ridges=0.0, cells=24, size=0.02):
    """A closed plate whose top is flat, or has ridges along y [m]."""
    n = cells + 1
    line = np.linspace(-size / 2, size / 2, n)
    x, y = np.meshgrid(line, line, indexing="ij")
    inside = (np.abs(x) < 0.49 * size) & (np.abs(y) < 0.49 * size)
    top = np.where(inside, ridges * np.sin(8 * np.pi * x / size), 0.0)
    upper = np.stack((x, y, top), -1).reshape(-1, 3)
    lower = upper * (1, 1, 0) - (0, 0, 0.005)
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:])
    up = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    edge = np.concatenate((index[:-1, 0], index[-1, :-1], index[:0:-1, -1], index[0, :0:-1]))
    after = np.roll(edge, -1)
    m = n * n
    sides = np.concatenate((np.stack((edge, edge + m, after + m), -1), np.stack((edge, after + m, after), -1)))
    triangles = np.concatenate((up, up[:, ::-1] + m, sides))
    return thigma.Mesh(np.concatenate((upper, lower)), triangles.astype(np.int32))


@pytest.fixture(scope="module")
def ridged():
    return thigma.bake(plate(ridges=0.0003, cells=64), plate(cells=2), texels=256)


@pytest.fixture(scope="module")
def flat():
    return thigma.bake(plate(cells=2), plate(cells=2), texels=64)


def test_a_texture_is_the_fine_surface(ridged):
    assert ridged.amplitude == pytest.approx(0.0003, rel=0.05)
    assert ridged.displacements.shape[2] == 3 and ridged.displacements.dtype == np.float32
    assert np.abs(ridged.displacements[..., 2]).max() == pytest.approx(0.0003, rel=0.02)
    assert ridged.figures["fit_error_rms"] < 1e-5 and ridged.charts >= 1
    assert len(ridged.coarse.triangles) < 100
    assert repr(ridged).startswith("<thigma.Texture 256 x 256 texels")


def test_a_file_of_it_is_the_program_s(ridged, program, tmp_path):
    ridged.save(tmp_path / "a.tex")
    again = thigma.load_texture(tmp_path / "a.tex")
    again.save(tmp_path / "b.tex")
    assert (tmp_path / "a.tex").read_bytes() == (tmp_path / "b.tex").read_bytes()
    larger = thigma.load_texture(tmp_path / "a.tex", scale=2.0)
    assert larger.amplitude == pytest.approx(2 * ridged.amplitude)
    plate(ridges=0.0003, cells=64).save(tmp_path / "fine.ply")
    plate(cells=2).save(tmp_path / "coarse.ply")
    program("bake", tmp_path / "fine.ply", "--onto", tmp_path / "coarse.ply", "--texels", 256,
            "-o", tmp_path / "c.tex")  # fmt: skip
    other = thigma.load_texture(tmp_path / "c.tex")
    np.testing.assert_array_equal(other.displacements, ridged.displacements)


@pytest.mark.parametrize("method", ["grid", "branch"])
def test_depth_of_a_plate_over_ridges(ridged, flat, method):
    """A flat plate turned over, its top at height h: the crests, 0.3 mm, reach 0.3 mm - h into it."""
    heights = np.linspace(-0.0002, 0.0005, 15)
    poses = np.zeros((15, 7))
    poses[:, 2], poses[:, 3] = heights, 1.0  # about x by 180 degrees
    found, is_height_field = thigma.depth(flat, ridged, poses, (0, 0, -1), method=method, resolution=200)
    np.testing.assert_allclose(found, 0.0003 - heights, atol=1e-5)
    assert is_height_field.all()
    away = poses.copy()
    away[:, 0] = 0.1
    apart, _ = thigma.depth(flat, ridged, away, (0, 0, -1), method=method)
    assert np.isneginf(apart).all()


def test_what_cannot_be_used(ridged, tmp_path):
    pose = (0, 0, 0, 0, 0, 0, 1)
    with pytest.raises(thigma.InputError, match="method 'gpu', expected grid or branch"):
        thigma.depth(ridged, ridged, pose, method="gpu")
    with pytest.raises(TypeError, match="scene: Mesh, expected Texture"):
        thigma.depth(ridged, ridged.coarse, pose)
    with pytest.raises(thigma.InputError, match="direction: no length"):
        thigma.depth(ridged, ridged, pose, (0, 0, 0))
    with pytest.raises(thigma.InputError, match="texels must be 16"):
        thigma.bake(plate(cells=2), plate(cells=2), texels=1)
    (tmp_path / "x.tex").write_text(json.dumps({}))
    with pytest.raises(thigma.InputError, match="x.tex: "):
        thigma.load_texture(tmp_path / "x.tex")


def test_a_scene_of_meshes_in_memory(scene, tmp_path):
    """The frames are those of the same meshes from files."""
    box = thigma.Mesh(*box_arrays((0.02, 0.02, 0.02)))
    plate_mesh = thigma.Mesh(*box_arrays((0.1, 0.1, 0.02)))
    made = thigma.scene_from_pair(box, plate_mesh, pose=(0, 0, 0.03, 0, 0, 0, 1))
    assert made.response == "constraint" and "12 triangles against 1" in repr(made)
    hashes = [thigma.Session(s, device="hand:", duration=0.5).run().state_hash for s in (scene, made)]
    assert hashes[0] == hashes[1]
    with pytest.raises(thigma.InputError, match="expected 1 for meshes in memory"):
        thigma.scene_from_pair(box, plate_mesh, 0.001)
    with pytest.raises(thigma.InputError, match="expected a file as the object is"):
        thigma.scene_from_pair("a.obj", plate_mesh)
    with pytest.raises(thigma.InputError, match="expected a mesh in memory"):
        thigma.scene_from_pair(box, "b.obj")
