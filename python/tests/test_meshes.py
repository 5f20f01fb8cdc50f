"""Meshes and levels: arrays in, views out, what is refused."""

import types

import numpy as np
import pytest
from conftest import box_arrays

import thigma


def test_arrays_come_out_as_they_went_in():
    vertices, triangles = box_arrays((0.1, 0.2, 0.3))
    mesh = thigma.Mesh(vertices, triangles)
    assert mesh.vertices.dtype == np.float64 and mesh.triangles.dtype == np.int32
    np.testing.assert_array_equal(mesh.vertices[mesh.triangles], vertices[triangles])
    assert mesh.radius == pytest.approx(np.sqrt(0.1**2 + 0.2**2 + 0.3**2) / 2, rel=1e-6)


def test_views_are_read_only_share_memory_and_outlive_the_mesh():
    mesh = thigma.Mesh(*box_arrays((1, 1, 1)))
    view = mesh.vertices
    assert np.shares_memory(view, mesh.vertices) and np.shares_memory(
        mesh.triangles, mesh.triangles
    )
    kept = view.copy()
    with pytest.raises(ValueError):
        view[0, 0] = 2.0
    del mesh
    np.testing.assert_array_equal(view, kept)


def test_other_layouts_and_types_are_copied():
    vertices, triangles = box_arrays((1, 1, 1))
    wide = np.zeros((len(vertices), 6))
    wide[:, ::2] = vertices
    expected = thigma.Mesh(vertices, triangles)
    for v, t in (
        (np.asfortranarray(vertices), np.asfortranarray(triangles)),
        (wide[:, ::2], triangles[::1]),
        (vertices.astype(np.float32), triangles.astype(np.int64)),
        (vertices.tolist(), triangles.tolist()),
    ):
        np.testing.assert_array_equal(thigma.Mesh(v, t).vertices, expected.vertices)


def test_equal_positions_become_one_vertex_as_in_a_file():
    vertices, triangles = box_arrays((1, 1, 1))
    soup = vertices[triangles].reshape(-1, 3)
    mesh = thigma.Mesh(soup, np.arange(len(soup), dtype=np.int32).reshape(-1, 3))
    assert len(mesh.vertices) == 8 and len(mesh.triangles) == 12


def test_meshes_of_trimesh_and_meshio():
    vertices, triangles = box_arrays((1, 1, 1))
    trimesh = types.SimpleNamespace(vertices=vertices, faces=triangles.astype(np.int64))
    block = types.SimpleNamespace(type="triangle", data=triangles)
    line = types.SimpleNamespace(type="line", data=triangles[:, :2])
    meshio = types.SimpleNamespace(points=vertices, cells=[line, block])
    for mesh in (trimesh, meshio, thigma.Mesh(vertices, triangles)):
        assert len(thigma.Mesh(mesh).triangles) == 12
    with pytest.raises(thigma.InputError, match="cells without triangles"):
        thigma.Mesh(types.SimpleNamespace(points=vertices, cells=[line]))
    with pytest.raises(TypeError, match="trimesh"):
        thigma.Mesh(3)


def test_the_libraries_themselves():
    trimesh = pytest.importorskip("trimesh")
    assert len(thigma.Mesh(trimesh.creation.icosphere(subdivisions=2)).triangles) == 320
    meshio = pytest.importorskip("meshio")
    vertices, triangles = box_arrays((1, 1, 1))
    assert len(thigma.Mesh(meshio.Mesh(vertices, [("triangle", triangles)])).triangles) == 12


@pytest.mark.parametrize(
    "change, error, text",
    [
        (lambda v, t: (v[:, :2], t), thigma.InputError, r"vertices: shape \(8, 2\), expected"),
        (lambda v, t: (v, t[:, :2]), thigma.InputError, r"triangles: shape \(12, 2\), expected"),
        (lambda v, t: (v, t.astype(float)), TypeError, "triangles: dtype float64"),
        (lambda v, t: (v.astype(complex), t), TypeError, "vertices: dtype complex128"),
        (lambda v, t: (np.where(v > 0, np.nan, v), t), thigma.InputError, "not finite"),
        (lambda v, t: (np.where(v > 0, np.inf, v), t), thigma.InputError, "not finite"),
        (lambda v, t: (v, t + 1), thigma.InputError, "vertex 8, triangle .*expected 0 to 7"),
        (lambda v, t: (v, t - 1), thigma.InputError, "vertex -1"),
        (lambda v, t: (v, t.astype(np.int64) + 2**40), thigma.InputError, "beyond 32 bits"),
        (lambda v, t: (v, t[:0]), thigma.InputError, "no triangle"),
        (lambda v, t: (v, np.vstack((t, t[:1, ::-1]))), thigma.InputError, "repair takes it repaired"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_line(change, error, text):
    with pytest.raises(error, match=text) as caught:
        thigma.Mesh(*change(*box_arrays((1, 1, 1))))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("scale", [0.0, -1.0, float("nan"), float("inf")])
def test_scales_that_are_none(scale):
    with pytest.raises(thigma.InputError, match="scale"):
        thigma.Mesh(*box_arrays((1, 1, 1)), scale=scale)


def test_repair():
    vertices, triangles = box_arrays((1, 1, 1))
    mesh = thigma.Mesh(vertices, np.vstack((triangles, triangles[:1])), repair=True)
    assert len(mesh.triangles) == 12 and len(mesh.repairs) == 1


def test_messages_of_files_are_the_program_s(program, tmp_path):
    import os
    import subprocess

    path = tmp_path / "bad.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n")
    said = subprocess.run(
        [os.environ["THIGMA_PROGRAM"], "build", path, "-o", tmp_path / "x.clod"],
        capture_output=True,
        text=True,
    )
    with pytest.raises(thigma.InputError) as caught:
        thigma.Mesh.from_file(path)
    assert said.returncode == 4 and str(caught.value) in said.stderr
    with pytest.raises(ValueError):
        thigma.Mesh.from_file(tmp_path / "none.obj")


def test_the_formats_are_those_of_the_program(program, tmp_path):
    formats = thigma.mesh_formats()
    assert formats["OBJ"] == ".obj"
    (tmp_path / "empty.obj").write_bytes(b"")
    with pytest.raises(thigma.InputError) as caught:
        thigma.Mesh.from_file(tmp_path / "empty.obj")
    assert all(name in str(caught.value) for name in formats)


def test_save_and_load(tmp_path):
    mesh = thigma.Mesh(*box_arrays((0.1, 0.2, 0.3)))
    for name in ("a.obj", "a.ply", "a.off"):
        mesh.save(tmp_path / name)
        again = thigma.Mesh.from_file(tmp_path / name)
        np.testing.assert_array_equal(again.vertices, mesh.vertices)
    with pytest.raises(OSError):
        mesh.save(tmp_path / "none" / "a.obj")


def test_levels(program, tmp_path):
    mesh = thigma.Mesh.from_file("procedural:ball?triangles=1280")
    shares = []
    clod = thigma.build_clod(mesh, threads=2, progress=shares.append)
    assert shares == sorted(shares) and shares[-1] <= 1.0
    assert clod.has_levels and clod.levels[0].triangles == 1280
    plain = thigma.Mesh.from_file("procedural:box?triangles=12")
    assert thigma.build_clod(plain).has_levels, "too plain to have any, but built"
    assert not thigma.exact(mesh).has_levels
    scene = thigma.scene_from_pair(mesh, mesh, pose=(0, 0, 3, 0, 0, 0, 1))
    assert not scene.object.has_levels, "contacts of this scene are exact"
    counts = [level.triangles for level in clod.levels if not level.is_free]
    assert counts == sorted(counts, reverse=True) and len(counts) > 2
    assert len(clod.mesh(1).triangles) == clod.levels[1].triangles
    with pytest.raises(IndexError):
        clod.mesh(len(clod.levels))
    clod.save(tmp_path / "python.clod")
    again = thigma.load_clod(tmp_path / "python.clod", scale=2.0)
    assert again.radius == 2.0 * clod.radius and again.triangle_count == clod.triangle_count
    mesh.save(tmp_path / "ball.obj")
    program("build", tmp_path / "ball.obj", "-o", tmp_path / "program.clod")
    other = thigma.load_clod(tmp_path / "program.clod")
    for ours, theirs in zip(clod.levels, other.levels):
        assert ours == theirs
    with pytest.raises(thigma.InputError):
        thigma.load_clod(tmp_path / "ball.obj")


def test_what_progress_raises_ends_the_work():
    def stop(share):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        thigma.build_clod(thigma.Mesh.from_file("procedural:ball?triangles=1280"), progress=stop)


def test_texts():
    mesh = thigma.Mesh(*box_arrays((1, 1, 1)))
    assert repr(mesh) == "<thigma.Mesh 8 vertices, 12 triangles, radius 0.866 m>"
    assert "finest surface alone" in repr(thigma.exact(mesh))
