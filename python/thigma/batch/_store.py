"""The result folder: content-addressed rows and files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import pathlib
import time
import uuid
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Callable

import thigma

FORMAT = 1
"""Of rows and of what a kind computes; another one makes every key new."""

DONE, FAILED, LOST = "done", "failed", "lost"
"""LOST: not by its inputs, such as a dead worker; the next run tries again."""


def canonical(value: Any) -> str:
    """JSON of one spelling."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False)


def digest_of(said: Any) -> str:
    """Of its JSON: the same for equal values."""
    return hashlib.sha256(canonical(said).encode()).hexdigest()


def digest_of_file(path: str | os.PathLike[str]) -> str:
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


_digests: dict[tuple[str, int, int], str] = {}


def known_digest(path: str) -> str:
    """Kept while size and time of change stay."""
    known = os.stat(path)
    mark = (path, known.st_size, known.st_mtime_ns)
    if mark not in _digests:
        _digests[mark] = digest_of_file(path)
    return _digests[mark]


_library: list[str] = []


def library() -> str:
    """Version and digest of the module that computes."""
    if not _library:
        binary = digest_of_file(str(thigma._core.__file__))
        _library.append(f"{thigma.__version__}+{binary[:16]}")
    return _library[0]


@dataclass(frozen=True)
class Task:
    """One row to be made."""

    kind: str
    """assets, contacts, gains, sweep or throws."""
    part: str
    """Name in reports."""
    parameters: dict[str, Any]
    """JSON values."""
    inputs: dict[str, str] = field(default_factory=dict)
    """Role to path."""
    digests: dict[str, str] = field(default_factory=dict)
    """Role to SHA-256."""

    @property
    def key(self) -> str:
        """SHA-256 of everything that decides the result."""
        return digest_of(
            {
                "kind": self.kind,
                "part": self.part,
                "parameters": self.parameters,
                "inputs": self.digests,
                "library": library(),
                "format": FORMAT,
            }
        )


Row = dict[str, Any]


class Store:
    """rows/KIND/KEY.json, files/KEY.NAME, runs/*.json; safe for any number of writers."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = pathlib.Path(folder).resolve()
        if self.folder.exists() and not self.folder.is_dir():
            raise thigma.InputError(f"{folder}: is a file, expected a folder of results")
        for name in ("rows", "files", "runs", "tmp"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)

    def row_path(self, kind: str, key: str) -> pathlib.Path:
        return self.folder / "rows" / kind / f"{key}.json"

    def file_path(self, key: str, name: str) -> pathlib.Path:
        return self.folder / "files" / f"{key}.{name}"

    def read(self, kind: str, key: str) -> Row | None:
        """A row; None where there is none that can be used."""
        try:
            row = json.loads(self.row_path(kind, key).read_text("utf-8"))
        except (OSError, ValueError):
            return None
        if not isinstance(row, dict) or row.get("key") != key:
            return None
        held = (self.file_path(key, name).is_file() for name in row.get("files", {}))
        return row if all(held) else None

    def rows(self, kind: str | None = None) -> list[Row]:
        """All rows, by kind, part, parameters."""
        found = []
        for path in (self.folder / "rows").glob(f"{kind or '*'}/*.json"):
            row = self.read(path.parent.name, path.stem)
            if row is not None:
                found.append(row)
        return sorted(found, key=lambda r: (r["kind"], r["part"], canonical(r["parameters"])))

    @contextlib.contextmanager
    def writing(self, target: pathlib.Path) -> Iterator[pathlib.Path]:
        """A path to write to; takes the place of `target` when it is complete."""
        target.parent.mkdir(parents=True, exist_ok=True)
        path = self.folder / "tmp" / f"{uuid.uuid4().hex}{target.suffix}"
        try:
            yield path
            with open(path, "rb") as file:
                os.fsync(file.fileno())
            os.replace(path, target)
        finally:
            path.unlink(missing_ok=True)

    def add_file(self, key: str, name: str, write: Callable[[pathlib.Path], None]) -> str:
        """Writes a file of a row; its SHA-256."""
        with self.writing(self.file_path(key, name)) as path:
            write(path)
            return digest_of_file(path)

    def add_row(self, row: Row) -> Row:
        """The row that now stands; a lost one never takes the place of another."""
        target = self.row_path(row["kind"], row["key"])
        text = json.dumps(row, indent=1, sort_keys=True) + "\n"
        if row["status"] == LOST:
            return self._add_lost(row, text, target)
        with self.writing(target) as path:
            path.write_text(text, "utf-8")
        return row

    def _add_lost(self, row: Row, text: str, target: pathlib.Path) -> Row:
        """Linked, not moved: of two writers at once the one with a better row wins."""
        target.parent.mkdir(parents=True, exist_ok=True)
        path = self.folder / "tmp" / f"{uuid.uuid4().hex}.json"
        try:
            path.write_text(text, "utf-8")
            with contextlib.suppress(FileExistsError, PermissionError):
                os.link(path, target)
                return row
            standing = self.read(row["kind"], row["key"])
            if standing is not None and standing["status"] != LOST:
                return standing
            os.replace(path, target)  # one that was lost before, or torn
            return row
        finally:
            path.unlink(missing_ok=True)

    def add_run(self, run: dict[str, Any]) -> None:
        name = time.strftime("%Y%m%dT%H%M%S", time.gmtime()) + f"-{uuid.uuid4().hex[:8]}.json"
        with self.writing(self.folder / "runs" / name) as path:
            path.write_text(json.dumps(run, indent=1, sort_keys=True) + "\n", "utf-8")

    def runs(self) -> list[dict[str, Any]]:
        """The oldest first."""
        paths = sorted((self.folder / "runs").glob("*.json"))
        return [json.loads(path.read_text("utf-8")) for path in paths]

    def sweep_out(self, age: float = 86400.0) -> None:
        """Removes what killed writers left a day ago."""
        for path in (self.folder / "tmp").iterdir():
            with contextlib.suppress(OSError):
                if path.stat().st_mtime < time.time() - age:
                    path.unlink()


def row_of(task: Task, status: str, reason: str = "") -> Row:
    """A row without values."""
    return {
        "key": task.key,
        "kind": task.kind,
        "part": task.part,
        "parameters": task.parameters,
        "inputs": task.digests,
        "library": library(),
        "status": status,
        "reason": reason,
        "values": {},
        "files": {},
    }
