"""Recordings of sessions as arrays."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _core
from ._arrays import Array, Floats
from ._core import InputError
from ._sessions import Event


@dataclass(frozen=True, repr=False)
class Recording:
    """What a session did. `pandas.DataFrame(recording.frames)` is a table of it."""

    frames: dict[str, Array]
    """Columns of the haptic frames, (n,) each, with the names and units of `thigma export`."""
    contacts: dict[str, Array]
    """Columns of the contact frames, (k,) each."""
    events: list[Event]
    config: dict[str, Any]
    """Everything that a replay needs."""
    cut_off: str
    """Where and why the file ends early; "" of a whole one."""
    warnings: list[str]

    def vector(self, name: str) -> Floats:
        """Columns of one vector of the frames, (n, 3), or (n, 4) of a quaternion.

        name  as in the columns, without the axis: "body", "body q", "P", "command f"
        """
        columns: list[Array] = []
        for prefix in (name, name + " "):
            for axis in "xyzw":
                wanted = prefix + axis
                columns += [v for k, v in self.frames.items() if k.split(" [")[0] == wanted]
        if len(columns) < 3:
            raise InputError(f"recording: no vector '{name}', expected one of its columns")
        return np.stack(columns, axis=1)

    def __repr__(self) -> str:
        times = self.frames["time [s]"]
        end = f", cut off: {self.cut_off}" if self.cut_off else ""
        seconds = times[-1] if len(times) else 0.0
        return f"<thigma.Recording {len(times)} frames, {seconds:.3f} s{end}>"


@dataclass(frozen=True)
class Replay:
    """How running a recording again went."""

    identical: bool
    frames: int
    reason: str
    """Of the first difference, "" without one."""


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Reads a recording into memory. Raises InputError "FILE: what, where, what was expected"."""
    parts = _core.read_recording(os.fspath(path))
    frames = {k: np.asarray(v) for k, v in parts["frames"].items()}
    contacts = {k: np.asarray(v) for k, v in parts["contacts"].items()}
    return Recording(
        frames=frames,
        contacts=contacts,
        events=[Event(**event) for event in parts["events"]],
        config=json.loads(parts["config"]),
        cut_off=parts["cut_off"],
        warnings=parts["warnings"],
    )


def replay(path: str | os.PathLike[str]) -> Replay:
    """Runs a recorded session again from its samples: bit for bit, or the first difference."""
    return Replay(*_core.replay(os.fspath(path)))


def export_csv(path: str | os.PathLike[str], csv: str | os.PathLike[str]) -> None:
    """Writes the frames of a recording as a table."""
    _core.export_csv(os.fspath(path), os.fspath(csv))
