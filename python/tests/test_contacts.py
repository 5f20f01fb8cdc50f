"""Contacts at poses: known distances, and the program's own answers bit for bit."""

import json

import numpy as np
import pytest

import thigma


def heights(values):
    rows = np.zeros((len(values), 7))
    rows[:, 2] = values
    rows[:, 6] = 1.0
    return rows


def test_a_box_over_a_box(box):
    z = np.array([0.0215, 0.0202, 0.02, 0.019, 0.05])
    found = thigma.contacts(box, box, heights(z), 0.002)
    assert len(found) == 5 and found.start[0] == 0 and found.start[-1] == len(found.depth)
    np.testing.assert_allclose(found.distance[:4], z[:4] - 0.02, atol=1e-12)
    assert found.distance[4] == np.inf and found.count[4] == 0
    first = found.at(0)
    np.testing.assert_allclose(first["normal"], np.tile((0, 0, -1.0), (len(first["depth"]), 1)),
                               atol=1e-9)  # fmt: skip
    gap = ((first["point"] - first["scene_point"]) * first["normal"]).sum(axis=1)
    np.testing.assert_allclose(gap, first["depth"], atol=1e-15)
    np.testing.assert_array_equal(found.pose, np.repeat(np.arange(5), found.count))
    assert (found.bound == 0).all() and (found.level == 0).all() and (found.cpu > 0).all()
    with pytest.raises(IndexError):
        found.at(5)
    assert repr(found).startswith("<thigma.Contacts ")


def test_the_scene_may_stand_elsewhere(box):
    placed = thigma.contacts(
        box, box, heights([0.0215]), 0.002, scene_pose=(0, 0, 0.001, 0, 0, 0, 1)
    )
    assert placed.distance[0] == pytest.approx(0.0005, abs=1e-12)


@pytest.fixture(scope="module")
def torus():
    mesh = thigma.Mesh.from_file("procedural:torus?triangles=2000")
    return mesh, thigma.build_clod(mesh)


def tumbling(n):
    random = np.random.default_rng(7)
    turns = random.normal(size=(n, 4))
    rows = np.empty((n, 7))
    rows[:, :3] = random.uniform(-0.08, 0.08, size=(n, 3))
    rows[:, 3:] = turns / np.linalg.norm(turns, axis=1)[:, np.newaxis]
    return rows


@pytest.mark.parametrize(
    "options, flags",
    [
        ({}, []),
        ({"threshold": 0.025}, ["--threshold", "0.025"]),
        ({"budget_tests": 300}, ["--budget-tests", "300"]),
    ],
)
def test_the_numbers_are_the_program_s(program, tmp_path, torus, options, flags):
    mesh, clod = torus
    clod.save(tmp_path / "torus.clod")
    rows = tumbling(60)
    with open(tmp_path / "poses.csv", "w") as file:
        file.write("x,y,z,qx,qy,qz,qw\n")
        file.writelines(",".join(repr(float(v)) for v in row) + "\n" for row in rows)
    said = program("contacts", tmp_path / "torus.clod", tmp_path / "torus.clod",
                   "--poses", tmp_path / "poses.csv", "--tolerance", "0.002", *flags)  # fmt: skip
    found = thigma.contacts(clod, clod, rows, 0.002, **options)
    lines = [json.loads(line) for line in said.splitlines()]
    assert len(lines) == len(found) and len(found.depth) > 50
    for i, line in enumerate(lines):
        ours = found.at(i)
        assert line["min_distance"] == (found.distance[i] if found.count[i] else None)
        assert [c["depth"] for c in line["contacts"]] == ours["depth"].tolist()
        assert [c["point"] for c in line["contacts"]] == ours["point"].tolist()
        assert [c["normal"] for c in line["contacts"]] == ours["normal"].tolist()
        assert [c["levels"] for c in line["contacts"]] == ours["level"].tolist()
        assert line["tests"] == found.tests[i] and line["front"] == found.front[i]


def test_exact_contacts_do_not_depend_on_the_pose_before(torus):
    mesh, clod = torus
    rows = tumbling(40)
    one = thigma.contacts(mesh, clod, rows, 0.002)
    two = thigma.contacts(clod, mesh, rows, 0.002, fresh=True)
    np.testing.assert_array_equal(one.depth, two.depth)


def test_rotations_of_scipy(box):
    rotations = pytest.importorskip("scipy.spatial.transform")
    turned = rotations.Rotation.from_rotvec(np.outer(np.radians((0, 45, 90)), (0, 0, 1)))
    places = np.tile((0, 0, 0.0215), (3, 1))
    by_rotation = thigma.contacts(box, box, (places, turned), 0.002)
    by_rows = thigma.contacts(box, box, np.hstack((places, turned.as_quat())), 0.002)
    np.testing.assert_array_equal(by_rotation.depth, by_rows.depth)
    one = thigma.contacts(box, box, (places[0], turned[1]), 0.002)
    assert len(one) == 1 and one.distance[0] == by_rows.distance[1]
    with pytest.raises(thigma.InputError, match="3 positions and 2 rotations"):
        thigma.contacts(box, box, (places, turned[:2]), 0.002)
    with pytest.raises(thigma.InputError, match="without positions"):
        thigma.contacts(box, box, turned, 0.002)


def test_strides_and_single_precision(box):
    rows = heights(np.linspace(0.019, 0.023, 8))
    expected = thigma.contacts(box, box, rows[::2], 0.002)
    wide = np.repeat(rows, 2, axis=1)[::2, ::2]
    np.testing.assert_array_equal(thigma.contacts(box, box, wide, 0.002).depth, expected.depth)
    assert len(thigma.contacts(box, box, rows.astype(np.float32), 0.002)) == 8
    assert len(thigma.contacts(box, box, rows[0], 0.002)) == 1
    assert len(thigma.contacts(box, box, rows[:0], 0.002)) == 0


@pytest.mark.parametrize(
    "rows, tolerance, options, error, text",
    [
        (np.zeros((3, 6)), 0.001, {}, ValueError, r"poses: shape \(3, 6\), expected \(n, 7\)"),
        (np.zeros((2, 3, 7)), 0.001, {}, ValueError, "poses: shape"),
        (np.zeros((3, 7)), 0.001, {}, ValueError, "quaternion of length 0.0.*row 0"),
        (heights([0.1, np.nan]), 0.001, {}, ValueError, "poses: nan, row 1, expected finite"),
        (heights([0.1]).astype(str), 0.001, {}, TypeError, "dtype"),
        (heights([0.1]), -1.0, {}, ValueError, "tolerance"),
        (heights([0.1]), float("nan"), {}, ValueError, "tolerance"),
        (heights([0.1]), 0.001, {"step_time": 0.0}, ValueError, "step_time"),
        (heights([0.1]), 0.001, {"threshold": 0.02}, ValueError, "without levels of detail"),
        (heights([0.1]), 0.001, {"scene_pose": heights([0, 1])}, ValueError, "2 poses"),
    ],
)
def test_what_is_no_query(box, rows, tolerance, options, error, text):
    with pytest.raises(error, match=text):
        thigma.contacts(box, box, rows, tolerance, **options)


@pytest.mark.parametrize(
    "options",
    [{"threshold": -1.0}, {"deviation_cap": 0.0}, {"budget_us": -1.0}, {"budget_tests": -1},
     {"velocity": float("nan")}],
)  # fmt: skip
def test_what_is_no_level(torus, options):
    with pytest.raises(thigma.InputError, match=next(iter(options)).split("_us")[0]):
        thigma.contacts(torus[1], torus[1], heights([0.1]), 0.001, **options)
