"""What one task computes. Values and files depend on nothing but inputs, parameters and library."""

from __future__ import annotations

import functools
import pathlib
import tempfile
import time
import warnings
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np

import thigma

from .._arrays import Floats
from . import _scenes
from ._store import Store, Task, known_digest


class TimeLimit(Exception):
    """A task took longer than it may."""


@dataclass
class Work:
    """A task being worked on."""

    task: Task
    store: Store
    deadline: float
    """time.monotonic()."""

    def check(self, _share: float = 0.0) -> None:
        if time.monotonic() > self.deadline:
            raise TimeLimit("longer than the time limit")

    def add(self, name: str, write: Callable[[pathlib.Path], None]) -> dict[str, str]:
        self.check_inputs()
        return {name: self.store.add_file(self.task.key, name, write)}

    def check_inputs(self) -> None:
        """What is read is what the key says, on every machine and to the end."""
        for role, digest in self.task.digests.items():
            path = self.task.inputs[role]
            if digest.startswith("absent"):
                raise thigma.IoError(f"{path}: {digest}")
            if known_digest(path) != digest:
                raise thigma.IoError(f"{path}: changed since the run began, expected one content")

    @property
    def device(self) -> str:
        """Its address; a script where it lies."""
        file = self.task.inputs.get("device")
        return self.task.parameters["device"] if file is None else f"script:{file}"


def _load(path: str, scale: float, repair: bool) -> thigma.Mesh:
    return thigma.Mesh.from_file(path, scale=scale, repair=repair)


def assets(work: Work) -> tuple[dict[str, Any], dict[str, str]]:
    """Levels of detail of a part."""
    p = work.task.parameters
    mesh = _load(work.task.inputs.get("part", work.task.part), p["scale"], p["repair"])
    clod = thigma.build_clod(mesh, threads=1, progress=work.check)
    files = work.add("clod", lambda path: clod.save(path))
    levels = clod.levels
    meshes = [level for level in levels if not level.is_free]
    values = {
        "triangles": clod.triangle_count,
        "radius_m": clod.radius,
        "levels": len(levels),
        "level_meshes": len(meshes),
        "coarsest_triangles": meshes[-1].triangles,
        "deviation_max_m": max(level.deviation_max for level in levels),
        "bytes": work.store.file_path(work.task.key, "clod").stat().st_size,
        "repairs": mesh.repairs,
    }
    return values, files


@functools.lru_cache(maxsize=4)
def _surface(path: str, digest: str, scale: float, repair: bool) -> thigma.Clod:
    """Kept by a worker from chunk to chunk."""
    if path.endswith(".clod"):
        return thigma.load_clod(path, scale=scale)
    return thigma.exact(_load(path, scale, repair))


def _side(work: Work, role: str, name: str) -> thigma.Clod:
    p = work.task.parameters
    path = work.task.inputs.get(role, name)
    return _surface(path, work.task.digests.get(role, ""), p["scale"], p["repair"])


def random_units(words: Any, count: int) -> Floats:
    """`count` numbers of [0, 1) from a bit generator, whose stream NumPy keeps for good."""
    return np.asarray(
        (words.random_raw(count) >> np.uint64(11)).astype(np.float64) * 2.0**-53, dtype=np.float64
    )


def _in_ball(words: Any, count: int, axes: int) -> Floats:
    """Directions (count, axes), by rejection: no trigonometry, the same bits everywhere."""
    found = np.empty((0, axes))
    while len(found) < count:
        tried = 2.0 * random_units(words, axes * 2 * count).reshape(-1, axes) - 1.0
        length = np.sqrt((tried * tried).cumsum(axis=1)[:, -1])
        keep = (length > 0.1) & (length <= 1.0)
        found = np.vstack((found, tried[keep] / length[keep, np.newaxis]))
    return np.asarray(found[:count], dtype=np.float64)


def random_poses(seed: int, chunk: int, count: int, least: float, most: float) -> Floats:
    """Poses (count, 7) about the origin at distances least to most [m], any orientation."""
    words = np.random.PCG64(np.random.SeedSequence([seed, chunk]))
    away = least + (most - least) * random_units(words, count)
    places = _in_ball(words, count, 3) * away[:, np.newaxis]
    return np.hstack((places, _in_ball(words, count, 4)))


def _check_names(path: str) -> None:
    names = "x,y,z,qx,qy,qz,qw"
    with open(path, encoding="utf-8", errors="replace") as text:
        first = text.readline(1000).strip()
    if first.replace(" ", "") != names:
        raise thigma.InputError(f"{path}: line 1 is '{first[:60]}', expected {names}")


def read_poses(path: str, first: int = 0, count: int | None = None) -> Floats:
    """Rows x, y, z, qx, qy, qz, qw of a .npy file, or of a text that begins with these names."""
    if not path.endswith(".npy"):
        _check_names(path)
    try:
        if path.endswith(".npy"):
            rows = np.load(path, mmap_mode="r")
            if not isinstance(rows, np.ndarray):
                raise ValueError("an archive of arrays")
        else:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of a file without rows
                rows = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)
    except (ValueError, EOFError) as error:
        said = str(error).splitlines()[0]
        raise thigma.InputError(f"{path}: {said}, expected rows of seven numbers") from None
    if rows.size and (rows.ndim != 2 or rows.shape[1] != 7 or rows.dtype.kind not in "fiu"):
        raise thigma.InputError(
            f"{path}: shape {rows.shape} of {rows.dtype}, expected (n, 7) numbers"
        )
    last = None if count is None else first + count
    return np.array(rows[first:last], dtype=np.float64)


def contacts(work: Work) -> tuple[dict[str, Any], dict[str, str]]:
    """Contacts of a part with another at a chunk of poses."""
    p = work.task.parameters
    part = _side(work, "part", work.task.part)
    other = _side(work, "against", p["against"])
    tolerance = p["tolerance"]
    if tolerance is None:
        tolerance = 0.01 * min(part.radius, other.radius)
    if "poses" in work.task.inputs:
        rows = read_poses(work.task.inputs["poses"], p["first"], p["count"])
    else:
        reach = part.radius + other.radius
        rows = random_poses(p["seed"], p["chunk"], p["count"], p["least"] * reach, p["most"] * reach)
        # The centre of the part stands there; its mesh frame is elsewhere.
        q, c = rows[:, 3:], part.center
        turned = c + 2.0 * np.cross(q[:, :3], np.cross(q[:, :3], c) + q[:, 3:] * c)
        rows[:, :3] += other.center - turned
    distance, count, bound = [], [], []
    for first in range(0, len(rows), 1000):
        work.check()
        found = thigma.contacts(
            part, other, rows[first : first + 1000], tolerance, threshold=p["threshold"], fresh=True
        )
        distance.append(found.distance)
        count.append(found.count.astype(np.int32))
        widest = np.zeros(len(found))
        np.maximum.at(widest, found.pose, found.bound)
        bound.append(widest)
    columns: dict[str, Any] = {
        "distance": np.concatenate(distance),
        "count": np.concatenate(count),
        "bound": np.concatenate(bound),
    }
    files = work.add("npz", lambda path: np.savez(path, **columns))
    near = np.isfinite(columns["distance"])
    values = {
        "poses": len(rows),
        "near": int(near.sum()),
        "overlapping": int((columns["distance"] < 0.0).sum()),
        "contacts": int(columns["count"].sum()),
        "least_m": float(columns["distance"][near].min()) if near.any() else None,
        "bound_max_m": float(columns["bound"].max()) if len(rows) else 0.0,
        "tolerance_m": tolerance,
    }
    return values, files


def _loaded(work: Work, folder: str, more: dict[str, Any] | None = None) -> thigma.Scene:
    p = work.task.parameters
    path = work.task.inputs.get("scene", work.task.part)
    changed = {**p.get("set", {}), **(more or {})}
    if changed:
        path = _scenes.write_changed(path, changed, folder)
    try:
        return thigma.load_scene(path, cache_folder=work.store.folder / "levels")
    except thigma.InputError as error:
        raise thigma.InputError(str(error).replace(f"{folder}/", "")) from None


def gains(work: Work) -> tuple[dict[str, Any], dict[str, str]]:
    """What `thigma tune` proposes."""
    p = work.task.parameters
    with tempfile.TemporaryDirectory() as folder:
        found = thigma.tune(_loaded(work, folder), device=work.device, delay=p["delay"])
    values: dict[str, Any] = {"max_force_N": found.max_force, "max_torque_Nm": found.max_torque}
    for name in ("linear", "angular", "contact"):
        gain = getattr(found, name)
        values |= {
            f"{name}_stiffness": gain.stiffness,
            f"{name}_damping": gain.damping,
            f"{name}_limit": gain.limit if np.isfinite(gain.limit) else None,
            f"{name}_binds": gain.binds,
        }
    values["warnings"] = [warning.text for warning in found.warnings]
    return values, {}


def _told(session: thigma.Session) -> dict[str, Any]:
    """Of a closed session, without times of the clock."""
    s = session.summary
    faults = [event.text for event in session.events if event.kind == "fault"]
    return {
        "end": s.end,
        "frames": s.frames,
        "force_max_N": s.force_max,
        "force_rms_N": s.force_rms,
        "torque_max_Nm": s.torque_max,
        "penetration_max_m": s.penetration_max,
        "stretch_max_m": s.stretch_max,
        "energy_min_J": s.energy_min,
        "faults": faults,
        "state_hash": s.state_hash,
    }


def sweep(work: Work) -> tuple[dict[str, Any], dict[str, str]]:
    """A session in lockstep, with keys of its scene changed."""
    p = work.task.parameters
    forces: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        scene = _loaded(work, folder)
        session = thigma.Session(
            scene, device=work.device, duration=p["duration"], seed=p["seed"]
        )
        with session:
            while (sample := session.step(frames=10)) is not None:
                work.check()
                forces.append(float(np.sqrt((sample.command[:3] ** 2).sum())))
    values = _told(session)
    # Of the last half: a force that goes on changing from sample to sample rings.
    late = np.array(forces[len(forces) // 2 :])
    values["force_jitter_N"] = float(np.abs(np.diff(late)).mean()) if len(late) > 1 else 0.0
    return values, {}


_UNLIMITED = {
    "safety.max_speed": 1000.0,
    "safety.pose_jump": 10.0,
    "safety.max_turn_speed": 1e5,
    "safety.orientation_jump": 6.0,
}


# Throws lead the hand by the axes of the world.
_AS_THE_WORLD = {"device.motion_scale": 1.0, "device.quat_xyzw": [0.0, 0.0, 0.0, 1.0]}


def throws(work: Work) -> tuple[dict[str, Any], dict[str, str]]:
    """The object of a scene, led through what stands there along lines drawn by their number."""
    p = work.task.parameters
    columns: dict[str, list[float]] = {"penetration": [], "force": [], "speed": []}
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        scene = _loaded(work, folder, {**_UNLIMITED, **_AS_THE_WORLD})
        target, radius = scene.statics[0], scene.object.radius
        center = np.asarray(scene.static_poses[0][:3]) + target.center
        way = 2.0 * (radius + target.radius)
        for number in range(p["first"], p["first"] + p["count"]):
            words = np.random.PCG64(np.random.SeedSequence([p["seed"], number]))
            towards = _in_ball(words, 1, 3)[0]
            turn = _in_ball(words, 1, 4)[0]
            speed = p["least_speed"] + (p["most_speed"] - p["least_speed"]) * float(
                random_units(words, 1)[0]
            )
            start = np.concatenate((center - 0.55 * way * towards, turn))
            session = thigma.Session(scene, device="null:", start=start)
            frames = int(np.ceil(1.1 * way / speed * scene.rate)) + p["after"]
            velocity = np.concatenate((speed * towards, np.zeros(3)))
            force = 0.0
            with session:
                for frame in range(frames):
                    if frame % 100 == 0:
                        work.check()
                    moved = min(frame / scene.rate * speed, 1.1 * way)
                    rest = moved >= 1.1 * way
                    at = np.array((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
                    at[:3] = moved * towards
                    sample = session.step(at, velocity=np.zeros(6) if rest else velocity)
                    if sample is None:
                        break
                    force = max(force, float(np.sqrt((sample.command[:3] ** 2).sum())))
            columns["penetration"].append(session.summary.penetration_max)
            columns["force"].append(force)
            columns["speed"].append(speed)
            faults += session.summary.end == "fault"
    arrays: dict[str, Any] = {name: np.array(column) for name, column in columns.items()}
    files = work.add("npz", lambda path: np.savez(path, **arrays))
    values = {
        "throws": p["count"],
        "entered": int((arrays["penetration"] > 0.0).sum()),
        "penetration_max_m": float(arrays["penetration"].max()),
        "force_max_N": float(arrays["force"].max()),
        "faults": faults,
    }
    return values, files


KINDS: dict[str, Callable[[Work], tuple[dict[str, Any], dict[str, str]]]] = {
    "assets": assets,
    "contacts": contacts,
    "gains": gains,
    "sweep": sweep,
    "throws": throws,
}
