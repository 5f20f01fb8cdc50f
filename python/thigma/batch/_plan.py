"""From folders and ranges to tasks."""

from __future__ import annotations

import itertools
import os
import pathlib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Optional

import thigma

from . import _scenes
from ._kinds import read_poses
from ._store import Task, canonical, known_digest


def parts_of(paths: Iterable[str | os.PathLike[str]]) -> dict[str, str]:
    """Parts by name: files, mesh files of folders, "procedural:..." and lists of these (.txt)."""
    found: dict[str, str] = {}
    endings = set(thigma.mesh_formats().values())

    def add(name: str, path: str) -> None:
        if found.setdefault(name, path) != path:
            raise thigma.InputError(f"{path}: a second part of the name {name}, expected one")

    for entry in paths:
        text = os.fspath(entry)
        path = pathlib.Path(text)
        if text.startswith("procedural:"):
            add(text, text)
        elif path.is_dir():
            for file in sorted(path.iterdir()):
                if file.suffix.lower() in endings:
                    add(file.name, os.fspath(file.resolve()))
        elif path.suffix == ".txt":
            lines = path.read_text("utf-8").splitlines()
            for line in filter(None, (line.split("#")[0].strip() for line in lines)):
                model = line.startswith("procedural:")
                more = parts_of([line if model else path.parent / line])
                for name, file_path in more.items():
                    add(name, file_path)
        else:
            add(path.name, os.fspath(path.resolve()))
    if not found:
        raise thigma.InputError("no part found, expected mesh files or procedural models")
    return found


def _task(kind: str, part: str, parameters: dict[str, Any], files: dict[str, str]) -> Task:
    inputs = {role: path for role, path in files.items() if not path.startswith("procedural:")}
    try:
        canonical(parameters)
    except ValueError:
        raise thigma.InputError(f"{kind}: {parameters}: expected finite numbers") from None
    digests = {}
    for role, path in inputs.items():
        try:
            digests[role] = known_digest(path)
        except OSError as error:
            digests[role] = f"absent: {error.strerror}"
    return Task(kind, part, parameters, inputs, digests)


def assets_tasks(parts: dict[str, str], *, scale: float = 1.0, repair: bool = False) -> list[Task]:
    """Levels of detail of every part, a .clod file each."""
    parameters = {"scale": float(scale), "repair": repair}
    return [_task("assets", name, parameters, {"part": path}) for name, path in parts.items()]


def contacts_tasks(
    parts: dict[str, str],
    against: str,
    *,
    poses: str | os.PathLike[str] | None = None,
    count: int = 100_000,
    chunk: int = 10_000,
    seed: int = 1,
    reach: tuple[float, float] = (0.8, 1.0),
    scale: float = 1.0,
    repair: bool = False,
    tolerance: float | None = None,
    threshold: float | None = None,
) -> list[Task]:
    """Contacts of every part with `against`, in chunks of poses.

    poses      .npy (n, 7) or .csv of the parts; None: `count` random ones a part, the centres of
               both at `reach` times the sum of their radii
    tolerance  [m]; None: 1 % of the smaller radius
    threshold  levels of detail; parts and `against` are .clod files then
    """
    if chunk < 1 or count < 1:
        raise thigma.InputError("contacts: poses and chunk must be whole numbers above 0")
    if not 0.0 <= reach[0] <= reach[1] < float("inf"):
        raise thigma.InputError("contacts: reach must be two numbers of 0 or more, the least first")
    total = count if poses is None else len(read_poses(os.fspath(poses)))
    if total == 0:
        raise thigma.InputError(f"{poses}: no pose, expected one or more")
    model = against.startswith("procedural:")
    files = {"against": against if model else os.fspath(pathlib.Path(against).resolve())}
    if poses is not None:
        files["poses"] = os.fspath(pathlib.Path(poses).resolve())
    tasks = []
    for (name, path), first in itertools.product(parts.items(), range(0, total, chunk)):
        parameters: dict[str, Any] = {
            "against": against if model else pathlib.Path(against).name,
            "scale": float(scale),
            "repair": repair,
            "tolerance": tolerance,
            "threshold": threshold,
            "first": first,
            "count": min(chunk, total - first),
        }
        if poses is None:
            parameters |= {
                "seed": seed,
                "chunk": first // chunk,
                "least": reach[0],
                "most": reach[1],
            }
        tasks.append(_task("contacts", name, parameters, {"part": path, **files}))
    return tasks


def _scene(path: str) -> tuple[str, dict[str, str]]:
    """Name and files; a built-in scene has none."""
    if path in thigma.builtin_scenes() and not os.path.exists(path):
        return path, {}
    full = pathlib.Path(path).resolve()
    return full.name, _scenes.files_of(full) if full.is_file() else {"scene": os.fspath(full)}


def _device(address: str) -> dict[str, str]:
    """The file of a script, which decides as much as the scene."""
    scheme, _, file = address.partition(":")
    return {"device": os.fspath(pathlib.Path(file).resolve())} if scheme == "script" else {}


def gains_tasks(
    scenes: Iterable[str],
    *,
    devices: Sequence[str] = ("",),
    delays: Sequence[Optional[float]] = (None,),
) -> list[Task]:
    """Gains of every scene in every device with every delay [s]."""
    tasks = []
    for path, device, delay in itertools.product(scenes, devices, delays):
        name, files = _scene(path)
        tasks.append(_task("gains", name, {"device": device, "delay": delay}, {**files, **_device(device)}))
    return tasks


def sweep_tasks(
    scenes: Iterable[str],
    changes: Mapping[str, Sequence[Any]],
    *,
    device: str = "hand:",
    duration: float = 4.0,
    seeds: Sequence[int] = (1,),
) -> list[Task]:
    """Sessions in lockstep for every combination of values of the changed keys of a scene.

    changes  such as {"coupling.linear_stiffness": [100.0, 300.0, 1000.0]}
    """
    tasks = []
    for path, seed, *values in itertools.product(scenes, seeds, *changes.values()):
        name, files = _scene(path)
        parameters = {
            "device": device,
            "duration": float(duration),
            "seed": seed,
            "set": dict(zip(changes, values)),
        }
        tasks.append(_task("sweep", name, parameters, {**files, **_device(device)}))
    return tasks


def throws_tasks(
    scenes: Iterable[str],
    *,
    count: int = 100,
    chunk: int = 10,
    seed: int = 1,
    speeds: tuple[float, float] = (0.05, 5.0),
    changes: dict[str, Any] | None = None,
) -> list[Task]:
    """The object of every scene led through the first static one along random lines.

    speeds   least and most [m/s]
    changes  keys of the scene, one value each
    """
    if chunk < 1 or count < 1:
        raise thigma.InputError("throws: count and chunk must be whole numbers above 0")
    if not 0.0 < speeds[0] <= speeds[1] < float("inf"):
        raise thigma.InputError("throws: speeds must be two numbers above 0, the least first")
    tasks = []
    for path, first in itertools.product(scenes, range(0, count, chunk)):
        name, files = _scene(path)
        parameters = {
            "seed": seed,
            "first": first,
            "count": min(chunk, count - first),
            "least_speed": speeds[0],
            "most_speed": speeds[1],
            "after": 50,
            "set": changes or {},
        }
        tasks.append(_task("throws", name, parameters, files))
    return tasks
