"""Scene files: what they read, and copies with changed keys."""

from __future__ import annotations

import os
import pathlib
import sys
from typing import Any

import thigma

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

_FILES = ("mesh", "texture")


def _read(path: str | os.PathLike[str]) -> dict[str, Any]:
    try:
        with open(path, "rb") as file:
            return tomllib.load(file)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise thigma.InputError(f"{path}: {error}, expected a scene file") from None


def _objects(scene: dict[str, Any]) -> list[dict[str, Any]]:
    statics = scene.get("static", [])
    found = [scene.get("object"), *(statics if isinstance(statics, list) else [])]
    return [entry for entry in found if isinstance(entry, dict)]


def files_of(path: str | os.PathLike[str]) -> dict[str, str]:
    """The scene file and the files that it names, role to path."""
    here = pathlib.Path(path).parent
    found = {"scene": os.fspath(path)}
    try:
        entries = _objects(_read(path))
    except thigma.InputError:
        return found  # the task says so
    for number, entry in enumerate(entries):
        for name in _FILES:
            value = entry.get(name)
            if isinstance(value, str) and not value.startswith("procedural:"):
                found[f"{name} {number}"] = os.fspath(here / value)
    return found


def write_changed(path: str, changed: dict[str, Any], folder: str) -> str:
    """A copy of a scene file in `folder`, with keys such as "coupling.linear_stiffness" changed."""
    if not os.path.isfile(path):
        raise thigma.InputError(f"{path}: no file, expected a scene file where keys are changed")
    try:
        import tomli_w
    except ImportError as error:
        raise thigma.InputError("tomli-w is missing: pip install 'thigma[batch]'") from error
    scene = _read(path)
    here = pathlib.Path(path).resolve().parent
    for entry in _objects(scene):
        for name in _FILES:
            value = entry.get(name)
            if isinstance(value, str) and not value.startswith("procedural:"):
                entry[name] = os.fspath(here / value)
    for key, value in changed.items():
        *tables, last = key.split(".")
        at: Any = scene
        for table in tables:
            at = at.setdefault(table, {})
            if not isinstance(at, dict):
                raise thigma.InputError(f"{key}: {table} is no table, expected SECTION.KEY")
        at[last] = value
    copy = pathlib.Path(folder) / pathlib.Path(path).name
    copy.write_text(tomli_w.dumps(scene), "utf-8")
    return os.fspath(copy)
