"""thigma-batch: killed workers, killed runs, two runs at once; the results are those of one process."""

import contextlib
import io
import json
import logging
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import box_arrays

import thigma

pytest.importorskip("distributed")
from thigma import batch  # noqa: E402
from thigma.batch._cli import main as batch_main  # noqa: E402
from thigma.batch._store import row_of  # noqa: E402

SMALL = [f"procedural:{model}?triangles={n}" for model in ("ball", "torus") for n in (320, 500, 720)]


def tree(folder):
    """Every result, byte for byte; times of runs are none."""
    root = pathlib.Path(folder)
    paths = [p for name in ("rows", "files") for p in (root / name).rglob("*") if p.is_file()]
    return {str(p.relative_to(root)): p.read_bytes() for p in paths}


@pytest.fixture(scope="module")
def tasks(tmp_path_factory):
    """Six models, one broken part."""
    broken = tmp_path_factory.mktemp("parts") / "broken.obj"
    broken.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n")
    return batch.assets_tasks(batch.parts_of([*SMALL, broken]))


@pytest.fixture(scope="module")
def expected(tasks, tmp_path_factory):
    """One process."""
    folder = tmp_path_factory.mktemp("serial") / "results"
    outcome = batch.run(tasks, folder, serial=True)
    assert (outcome.worked, outcome.count("done"), outcome.count("failed")) == (7, 6, 1)
    return tree(folder)


@pytest.fixture
def two_workers():
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    ) as cluster:
        yield cluster


def killer(cluster, after):
    """Kills the first worker when so many rows are there."""
    killed = []

    def progress(done, total, _bad):
        if not killed and done >= after and done < total:
            killed.append(next(iter(cluster.workers.values())).pid)
            os.kill(killed[0], signal.SIGKILL)

    return killed, progress


def test_a_killed_worker_loses_nothing(tasks, expected, two_workers, tmp_path):
    killed, progress = killer(two_workers, 2)
    outcome = batch.run(tasks, tmp_path, scheduler=two_workers, progress=progress)
    assert killed, "one worker was killed in the middle"
    assert (outcome.worked, outcome.count("done"), outcome.count("failed")) == (7, 6, 1)
    assert tree(tmp_path) == expected
    again = batch.run(tasks, tmp_path, scheduler="tcp://nobody:1")
    assert (again.worked, again.kept) == (0, 7), "nothing to do, so nobody is asked"
    row = next(r for r in again.rows if r["status"] == "failed")
    assert row["part"] == "broken.obj"
    assert row["reason"].startswith("broken.obj: ") and "\n" not in row["reason"]


def test_a_part_that_kills_its_workers_is_a_row(two_workers, tmp_path):
    """As a lack of memory does: its worker dies at the first try and no other one is allowed."""
    scheduler = two_workers.scheduler
    scheduler.allowed_failures = 0
    models = [f"procedural:torus?triangles={n}" for n in (5000, 5200)]
    tasks = batch.assets_tasks(batch.parts_of(models))

    def kill_a_busy_one():
        while True:
            for worker in list(scheduler.workers.values()):
                if any(str(task.key).startswith("assets-") for task in worker.processing):
                    time.sleep(0.3)
                    os.kill(next(w.pid for w in two_workers.workers.values()
                                 if w.worker_address == worker.address), signal.SIGKILL)  # fmt: skip
                    return
            time.sleep(0.01)

    thread = threading.Thread(target=kill_a_busy_one, daemon=True)
    thread.start()
    outcome = batch.run(tasks, tmp_path, scheduler=two_workers)
    thread.join()
    lost = [row["reason"] for row in outcome.rows if row["status"] == "lost"]
    assert lost == ["the worker died every time"] and outcome.count("done") == 1
    assert batch.run(tasks, tmp_path, serial=True).count("done") == 2, "tried again"


def cli(*arguments, **more):
    command = [sys.executable, "-m", "thigma.batch", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)


def test_a_killed_run_goes_on(tmp_path):
    """And two runs at once on one folder lose nothing."""
    parts = [f"procedural:torus?triangles={n}" for n in range(320, 1600, 160)]
    arguments = ("assets", *parts, "-o", tmp_path / "a", "--serial", "--quiet")
    first = cli(*arguments)
    deadline = time.time() + 60
    while len(list((tmp_path / "a").glob("rows/assets/*.json"))) < 2 and time.time() < deadline:
        time.sleep(0.01)
    first.kill()
    first.communicate()
    both = [cli(*arguments), cli(*arguments)]
    for run in both:
        said = run.communicate(timeout=120)
        assert run.returncode == 0, said
        assert "8 rows: " in said[0]
    whole = batch.assets_tasks(batch.parts_of(parts))
    assert batch.run(whole, tmp_path / "b", serial=True).worked == 8
    assert tree(tmp_path / "a") == tree(tmp_path / "b")
    assert "8 rows: 0 worked, 8 kept" in cli(*arguments).communicate()[0]


def test_every_kind_has_a_row_and_a_place_in_the_report(tmp_path):
    thigma.Mesh(*box_arrays((0.02, 0.02, 0.02))).save(tmp_path / "box.obj")
    scene = tmp_path / "press.toml"
    scene.write_text(
        '[object]\nmesh = "box.obj"\nunit_scale = 1.0\nposition = [0.0, 0.0, 0.05]\n'
        '[[static]]\nmesh = "procedural:ball?triangles=320"\n[contact]\nresponse = "constraint"\n'
    )
    out = tmp_path / "out"
    for arguments in (
        ("contacts", tmp_path / "box.obj", "--against", "procedural:ball?triangles=320",
         "--poses", 300, "--chunk", 100),
        ("gains", scene, "--device", "hand:", "--delay", 0, "--delay", 0.005),
        ("sweep", scene, "--set", "coupling.linear_stiffness=100,1000", "--duration", 0.3),
        ("throws", scene, "--count", 4, "--chunk", 2, "--speeds", "1,2"),
    ):  # fmt: skip
        run = cli(*arguments, "-o", out, "--serial", "--quiet")
        said = run.communicate(timeout=120)
        assert run.returncode == 0, said
    run = cli("sweep", scene, "--set", "coupling.linear_stiffness=soft", "-o", out, "--serial", "--quiet")
    said = run.communicate(timeout=120)
    assert run.returncode == 1 and "press.toml: coupling.linear_stiffness is text" in said[1]
    rows = batch.Store(out).rows()
    kinds = [row["kind"] for row in rows if row["status"] == "done"]
    assert [kinds.count(k) for k in ("contacts", "gains", "sweep", "throws")] == [3, 2, 2, 2]
    assert all(r["values"]["poses"] == 100 for r in rows if r["kind"] == "contacts")
    assert all(r["values"]["penetration_max_m"] == 0.0 for r in rows if r["kind"] == "sweep" and r["values"])
    page = (out / "report.html").read_text()
    for wanted in ("<h2>Contacts", "<h2>Gains", "<h2>Sessions", "<h2>Throws", "is text", "<svg"):
        assert wanted in page
    assert 'src="' not in page and 'href="http' not in page, "all of it is inside"


def test_contacts_are_those_of_the_poses(box, tmp_path):
    """Chunks of a file of poses are the poses in their order."""
    box.save(tmp_path / "box.obj")
    poses = np.tile((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), (25, 1))
    poses[:, 2] = np.linspace(0.0195, 0.0215, 25)
    np.save(tmp_path / "poses.npy", poses)
    tasks = batch.contacts_tasks(
        batch.parts_of([tmp_path / "box.obj"]), str(tmp_path / "box.obj"),
        poses=tmp_path / "poses.npy", chunk=10, tolerance=0.001,
    )  # fmt: skip
    batch.run(tasks, tmp_path / "out", serial=True)
    store = batch.Store(tmp_path / "out")
    found = [np.load(store.file_path(task.key, "npz"))["distance"] for task in tasks]
    assert [len(chunk) for chunk in found] == [10, 10, 5]
    direct = thigma.contacts(box, box, poses, 0.001)
    np.testing.assert_array_equal(np.concatenate(found), direct.distance)


def test_keys_follow_everything_that_decides(box, tmp_path):
    path = tmp_path / "box.obj"
    box.save(path)

    def key(**more):
        return batch.assets_tasks({"box.obj": str(path)}, **more)[0].key

    keys = {key(), key(scale=2.0), key(repair=True)}
    path.write_text(path.read_text() + "# changed\n")
    keys.add(key())
    assert len(keys) == 4
    assert key() == key()


def test_what_cannot_be_used(tmp_path):
    with pytest.raises(thigma.InputError, match="is a file, expected a folder"):
        (tmp_path / "file").write_text("")
        batch.run([], tmp_path / "file")
    with pytest.raises(thigma.InputError, match="no part found"):
        batch.parts_of([tmp_path])
    with pytest.raises(thigma.InputError, match="a second part of the name"):
        (tmp_path / "a").mkdir()
        for folder in (tmp_path, tmp_path / "a"):
            (folder / "x.obj").write_text("")
        batch.parts_of([tmp_path / "x.obj", tmp_path / "a" / "x.obj"])
    task = batch.assets_tasks({"gone.obj": str(tmp_path / "gone.obj")})
    row = batch.run(task, tmp_path / "out", serial=True).rows[0]
    assert row["status"] == "lost" and row["reason"].startswith("gone.obj: absent")
    slow = batch.assets_tasks(batch.parts_of(["procedural:torus?triangles=5000"]))
    row = batch.run(slow, tmp_path / "out", serial=True, time_limit=0.05).rows[0]
    assert (row["status"], row["reason"]) == ("lost", "longer than the time limit")
    half = batch.Store(tmp_path / "out").row_path("assets", slow[0].key)
    half.write_text('{"key":')
    assert batch.run(slow, tmp_path / "out", serial=True).count("done") == 1, "a torn row is made again"
    assert json.loads(half.read_text())["status"] == "done"


def test_arguments_that_decide_nothing_good(box, tmp_path):
    """One line and the exit code of bad input, before anything is worked on."""
    box.save(tmp_path / "box.obj")
    (tmp_path / "words.csv").write_text("x,y,z,qx,qy,qz,qw\n1,2,3,a,b,c,d\n")
    (tmp_path / "bare.csv").write_text("1,2,3,0,0,0,1\n1,2,3,0,0,0,1\n")
    (tmp_path / "order.csv").write_text("x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,0\n")
    (tmp_path / "none.csv").write_text("x,y,z,qx,qy,qz,qw\n")
    (tmp_path / "torn.npy").write_bytes(b"\x93NUMPY")
    np.savez(tmp_path / "many.npy.npz", a=np.zeros((1, 7)))
    os.rename(tmp_path / "many.npy.npz", tmp_path / "many.npy")
    np.save(tmp_path / "six.npy", np.zeros((3, 6)))
    np.save(tmp_path / "complex.npy", np.zeros((3, 7), dtype=complex))
    (tmp_path / "latin.toml").write_bytes(b"title = \"\xe9\"\n")
    pair = ("contacts", tmp_path / "box.obj", "--against", tmp_path / "box.obj")
    for arguments, wanted in (
        (("assets", tmp_path / "box.obj", "--scale", "nan"), "expected finite numbers"),
        ((*pair, "--tolerance", "inf"), "expected finite numbers"),
        ((*pair, "--poses", "0"), "above 0"),
        *(((*pair, "--poses", tmp_path / f"{name}.csv"), name) for name in ("words", "none", "bare", "order")),
        *(((*pair, "--poses", tmp_path / f"{name}.npy"), name) for name in ("torn", "many", "six", "complex")),
        (("throws", "ellipsoid", "--chunk", "0"), "above 0"),
        (("throws", "ellipsoid", "--count", "0"), "above 0"),
        (("sweep", "ellipsoid", "--set", "coupling.linear_stiffness=NaN"), "expected finite numbers"),
        (("gains", "ellipsoid", "--delay", "nan"), "expected finite numbers"),
    ):  # fmt: skip
        with contextlib.redirect_stderr(io.StringIO()) as said:
            code = batch_main([*map(str, arguments), "-o", str(tmp_path / "out"), "--serial", "--quiet"])
        assert code == 4 and wanted in said.getvalue(), (arguments, code, said.getvalue())
        assert said.getvalue().count("\n") == 1, said.getvalue()
    row = batch.run(batch.gains_tasks([str(tmp_path / "latin.toml")]), tmp_path / "out", serial=True).rows[0]
    assert row["status"] == "failed" and row["reason"].startswith("latin.toml: "), row


def test_levels_are_scaled_as_meshes_are(box, tmp_path):
    box.save(tmp_path / "box.obj")
    thigma.build_clod(box).save(tmp_path / "box.clod")
    np.save(tmp_path / "poses.npy", np.array([[0.0, 0.0, 0.0205 * 3.0, 0.0, 0.0, 0.0, 1.0]]))
    found = []
    for name in ("box.obj", "box.clod"):
        tasks = batch.contacts_tasks(
            batch.parts_of([tmp_path / name]), str(tmp_path / name),
            poses=tmp_path / "poses.npy", tolerance=0.003, scale=3.0,
        )  # fmt: skip
        batch.run(tasks, tmp_path / "out", serial=True)
        found.append(np.load(batch.Store(tmp_path / "out").file_path(tasks[0].key, "npz"))["distance"])
    assert np.isfinite(found[0]).all()
    np.testing.assert_allclose(found[1], found[0], rtol=1e-12)


def test_a_tolerance_of_zero_is_one(box, tmp_path):
    box.save(tmp_path / "box.obj")
    parts = batch.parts_of([tmp_path / "box.obj"])
    tasks = batch.contacts_tasks(parts, str(tmp_path / "box.obj"), count=10, tolerance=0.0)
    assert batch.run(tasks, tmp_path / "out", serial=True).rows[0]["values"]["tolerance_m"] == 0.0


def test_inputs_that_change_under_a_run_are_no_result(box, tmp_path):
    """The key says what is read; a row of another content under it would be wrong for good."""
    path = tmp_path / "box.obj"
    box.save(path)
    tasks = batch.assets_tasks({"box.obj": str(path)})
    path.write_text(path.read_text() + "# changed\n")
    row = batch.run(tasks, tmp_path / "out", serial=True).rows[0]
    assert row["status"] == "lost" and "box.obj: changed since the run began" in row["reason"]
    assert not list((tmp_path / "out" / "files").iterdir())


def test_a_script_decides_as_a_scene_does(tmp_path):
    script = tmp_path / "motion.csv"
    keys = set()
    for x in ("0", "0.001"):
        script.write_text(f"t,x,y,z,qx,qy,qz,qw\n0,0,0,0.05,0,0,0,1\n1,{x},0,0.05,0,0,0,1\n")
        tasks = batch.sweep_tasks(["ellipsoid"], {}, device=f"script:{script}", duration=0.1)
        row = batch.run(tasks, tmp_path / "out", serial=True).rows[0]
        assert row["status"] == "done", row["reason"]
        keys.add(row["key"])
    assert len(keys) == 2


def test_of_two_writers_the_better_row_stays(box, tmp_path, monkeypatch):
    """One finishes a row just when the other gives it up as lost."""
    box.save(tmp_path / "box.obj")
    task = batch.assets_tasks({"box.obj": str(tmp_path / "box.obj")})[0]
    store = batch.Store(tmp_path / "out")
    link = os.link

    def late(*arguments):
        store.add_row(row_of(task, "done"))
        link(*arguments)

    monkeypatch.setattr(os, "link", late)
    assert store.add_row(row_of(task, "lost", "the time limit"))["status"] == "done"
    assert store.read("assets", task.key)["status"] == "done"
    monkeypatch.undo()
    other = batch.assets_tasks({"box.obj": str(tmp_path / "box.obj")}, scale=2.0)[0]
    for reason in ("first", "second"):
        assert store.add_row(row_of(other, "lost", reason))["reason"] == reason
        assert store.read("assets", other.key)["reason"] == reason
    assert store.add_row(row_of(other, "done"))["status"] == "done"
    assert not list((tmp_path / "out" / "tmp").iterdir())


def test_a_report_adds_up_one_piece_of_work_at_a_time(box, tmp_path):
    """Not the poses of two versions of a part, nor chunks that overlap."""
    path, names = tmp_path / "$_x$.obj", batch.parts_of
    for text in ("# one\n", "# two\n"):
        box.save(path)
        path.write_text(path.read_text() + text)
        for chunk in (40, 60):
            tasks = batch.contacts_tasks(names([path]), str(path), count=100, chunk=chunk)
            batch.run(tasks, tmp_path / "out", serial=True)
    page = batch.write_report(batch.Store(tmp_path / "out")).read_text()
    rows = re.findall(r"<tr><td>\$_x\$\.obj</td><td>\$_x\$\.obj</td><td>([^<]*)</td><td class=n>([\d,]+)</td>", page)
    assert [poses for _, poses in rows] == ["100"] * 4, rows
    assert len({said for said, _ in rows}) == 2 and all("part " in said for said, _ in rows), rows


@pytest.mark.skipif(not os.environ.get("THIGMA_FULL"), reason="60 parts: with scripts/test --full")
def test_sixty_parts(two_workers, tmp_path, capsys):
    """The shared meshes and models: two workers, one of them killed; one worker; one process."""
    shared = pathlib.Path(os.environ.get("THIGMA_SHARED", "")) / "meshes"
    found = sorted(shared.glob("*.obj"))[:16]
    if len(found) < 16:
        pytest.skip("THIGMA_SHARED has no meshes")
    broken = tmp_path / "broken.obj"
    broken.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n")
    models = [f"procedural:{m}?triangles={320 + 80 * n}" for n in range(22) for m in ("ball", "torus")]
    parts = batch.parts_of([*found, broken, *models[:43]])
    assert len(parts) == 60
    small = {name: path for name, path in parts.items() if "triangles" in name}
    tasks = batch.contacts_tasks(
        parts, "procedural:ball?triangles=320", count=4000, chunk=2000, repair=True
    ) + batch.assets_tasks(small)
    assert len(tasks) == 163
    killed, progress = killer(two_workers, 40)
    batch.run(tasks, tmp_path / "killed", scheduler=two_workers, progress=progress)
    assert killed
    again = batch.run(tasks, tmp_path / "killed", scheduler=two_workers)
    assert (again.worked, again.count("lost")) == (0, 0)
    assert {row["part"] for row in again.rows if row["status"] == "failed"} == {"broken.obj"}
    serial = batch.run(tasks, tmp_path / "serial", serial=True)
    assert tree(tmp_path / "killed") == tree(tmp_path / "serial")
    times = [batch.run(tasks, tmp_path / f"by {n}", workers=n).seconds for n in (1, 2)]
    with capsys.disabled():
        print(
            f"\n60 parts, {len(tasks)} rows: in this process {serial.seconds:.1f} s, by one worker "
            f"{times[0]:.1f} s, by two {times[1]:.1f} s, {times[0] / times[1]:.2f} times the rows a second"
        )
        row = next(row for row in again.rows if row["status"] == "failed")
        print(f"  failed: {row['part']}: {row['reason']}")
