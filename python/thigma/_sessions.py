"""Sessions: the object in a hand, in lockstep or on threads."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Union

import numpy.typing as npt

from . import _core
from ._arrays import Poses, floats, pose
from ._core import Error, InputError, Sample
from ._scenes import Scene

_Run = Union[_core.SteppedRun, _core.ThreadedRun]


@dataclass(frozen=True)
class Event:
    """Something worth a line: a fault, grasping, an impact."""

    time: float
    """Session clock [s]."""
    frame: int
    kind: str
    detail: str
    text: str


@dataclass(frozen=True)
class Summary:
    """What a session was like. Durations are dicts of p50, p99, p999, max and count [s]."""

    end: str
    """duration, device_finished, stopped or fault."""
    seconds: float
    rate: float
    """Asked for [Hz]."""
    frames: int
    missed: int
    """Frames that were skipped."""
    overruns: int
    """Frames that ended after the next deadline."""
    step_cpu: dict[str, float]
    wake_late: dict[str, float]
    contact_updates: int
    query_cpu: dict[str, float]
    contacts_mean: float
    clusters_mean: float
    dropped_contacts: int
    dropped_samples: int
    force_max: float
    """Sent [N]."""
    force_rms: float
    torque_max: float
    """Felt about the handle [N m]."""
    torque_rms: float
    penetration_max: float
    """0: never inside [m]."""
    stretch_max: float
    """Of the coupling [m]."""
    energy_min: float
    """At the device's port, <= 0 [J]."""
    state_hash: str
    notes: list[str]
    figures: dict[str, Any]
    """All numbers, named and in the units of the summary of `thigma run --json`: `figures["constraint"]`,
    `figures["haptic"]["step_cpu_us"]["p99"]`. None: not known, or not a finite number."""

    def __repr__(self) -> str:
        return (
            f"<thigma.Summary {self.frames} frames in {self.seconds:.3f} s, {self.missed} missed, "
            f"force at most {self.force_max:.3g} N, end {self.end}>"
        )


class Session:
    """A scene in a hand. A context manager: leaving it ends the session with zero force.

    scene      of load_scene
    device     address, such as "hand:" or "null:"; "": the scene's
    threads    False: in lockstep, frames are made by step and run, as fast as it goes, the same
               bits every time. True: at the pace of the clock on threads of its own, in which
               Python never runs
    duration   [s]; 0: until it is ended, or the device has finished
    seed       of what is random in a simulated hand
    rate       haptic frames a second, instead of the scene's [Hz]
    start      pose of the centre of mass, instead of the scene's (7,) [m; world]
    recording  path of an .mcap file to write; "": none

    Raises DeviceAddressError, DeviceUnavailable, InputError, IoError. To be used by one thread at a
    time.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        device: str = "",
        threads: bool = False,
        duration: float = 0.0,
        seed: int = 1,
        rate: float | None = None,
        start: Poses | None = None,
        recording: str | os.PathLike[str] = "",
    ) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"session: {type(scene).__name__}, expected a thigma.Scene")
        if not 0.0 <= duration < float("inf"):
            raise InputError("session: duration must be a finite time, 0 or more [s]")
        options: dict[str, Any] = {
            "device": device,
            "duration": float(duration),
            "seed": int(seed),
            "rate": None if rate is None else float(rate),
            "start": None if start is None else pose(start, "start"),
            "recording": os.fspath(recording),
        }
        self._summary: Summary | None = None
        self._has_threads = threads
        self._run: _Run | None = (
            _core.ThreadedRun(scene._scene, options)
            if threads
            else _core.SteppedRun(scene._scene, options)
        )
        self._last: Sample | None = None
        self._events: list[Event] = []

    def _open(self) -> _Run:
        if self._run is None:
            raise Error("session: is closed, expected an open one")
        return self._run

    def _stepped(self, what: str) -> _core.SteppedRun:
        run = self._open()
        if not isinstance(run, _core.SteppedRun):
            raise Error(f"session: {what} of a session on threads, expected one in lockstep")
        return run

    def _threaded(self, what: str) -> _core.ThreadedRun:
        run = self._open()
        if not isinstance(run, _core.ThreadedRun):
            raise Error(f"session: {what} of a session in lockstep, expected one on threads")
        return run

    def step(
        self,
        handle: Poses | None = None,
        *,
        velocity: npt.ArrayLike | None = None,
        buttons: int = 1,
        frames: int = 1,
    ) -> Sample | None:
        """Makes haptic frames in lockstep; one's own controller calls it in a loop.

        handle    pose that the device tells instead of its own, held for these frames; None: its
                  own (7,) [m; device frame]
        velocity  of the handle, linear and angular; None: from the handle before (6,) [m/s, rad/s]
        buttons   of the handle; 1: the hand holds the object
        frames    how many
        returns   the last of them; None when the session has ended before
        """
        run = self._stepped("step")
        if frames < 1:
            raise InputError("step: frames must be a whole number above 0")
        if not 0 <= buttons < 2**32:
            raise InputError("step: buttons must be 0 to 2^32 - 1")
        if velocity is not None:
            velocity = floats(velocity, "velocity", "(6,)", 6)
            if not abs(velocity).max() < float("inf"):
                raise InputError("velocity: not finite, expected 6 finite numbers")
        at = None if handle is None else pose(handle, "handle")
        return run.step(frames, at, velocity, buttons)

    def __iter__(self) -> Iterator[Sample]:
        """Frames in lockstep, one by one, until the session has ended."""
        while (sample := self.step()) is not None:
            yield sample

    def run(self) -> Summary:
        """Makes frames until the session ends, and closes it. Ctrl-C ends it as well."""
        run = self._open()
        try:
            if isinstance(run, _core.SteppedRun):
                while run.step(2**62, None, None, 1) is not None:
                    pass
            else:
                run.wait()
        finally:
            summary = self.close()
        return summary

    def start(self) -> None:
        """Starts the threads."""
        self._threaded("start").start()

    @property
    def is_running(self) -> bool:
        """Whether the threads run; in lockstep, whether frames may be made."""
        run = self._run
        if isinstance(run, _core.ThreadedRun):
            return run.is_running
        return run is not None and not run.is_over

    @property
    def last(self) -> Sample | None:
        """The last haptic frame; on threads a few milliseconds late. None before the first."""
        return self._last if self._run is None else self._run.last

    @property
    def events(self) -> list[Event]:
        """What has happened so far."""
        if self._run is None:
            return list(self._events)
        return [Event(**event) for event in self._run.events]

    @property
    def summary(self) -> Summary:
        """Of a closed session."""
        if self._summary is None:
            raise Error("session: is not closed yet, expected a call of close or run before")
        return self._summary

    def close(self) -> Summary:
        """Ends the session with zero force and completes its recording; again: the same summary.

        Raises what ended the session early, such as IoError of a full disk.
        """
        if self._run is None:
            return self.summary
        run = self._run
        try:
            values = run.finish()
        finally:
            self._last, self._events, self._run = run.last, self.events, None
        self._summary = Summary(**values)
        return self._summary

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._run is not None:
            self.close()

    def __repr__(self) -> str:
        kind = "on threads" if self._has_threads else "in lockstep"
        if self._run is None:
            return f"<thigma.Session {kind}, closed>"
        last = self._run.last
        frames = 0 if last is None else last.frame + 1
        return f"<thigma.Session {kind}, {self._run.device!r}, {frames} frames>"


