"""thigma-batch: killed workers, killed runs, two runs at once; the results are those of one process."""

import json
import logging
import os
import pathlib
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

    thread = threading.Thread(target=kill_a_busy_one)
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
