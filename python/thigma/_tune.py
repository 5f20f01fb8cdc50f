"""Gains of coupling and contact, and what limits them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import floats
from ._core import InputError
from ._scenes import Scene


@dataclass(frozen=True)
class Gain:
    """A stiffness with its critical damping [N/m, N s/m], or [N m/rad, N m s/rad]."""

    stiffness: float
    damping: float
    limit: float
    """Of the stiffness."""
    binds: str
    """What sets it: device, friction, loop or frames."""
    limits: dict[str, float]


@dataclass(frozen=True)
class GainWarning:
    """One gain of a scene that lies outside."""

    gain: str
    value: float
    limit: float
    text: str


@dataclass(frozen=True)
class Gains:
    """What `thigma tune` proposes."""

    linear: Gain
    angular: Gain
    contact: Gain
    """Stiffness 0 where contacts are constraints."""
    max_force: float
    """Where the linear spring levels off; 0: the device is not known [N]."""
    max_torque: float
    """And the angular one [N m]."""
    warnings: list[GainWarning]
    """Of the scene's own gains."""


def _gains(parts: dict[str, Any]) -> Gains:
    return Gains(
        linear=Gain(**parts["linear"]),
        angular=Gain(**parts["angular"]),
        contact=Gain(**parts["contact"]),
        max_force=parts["max_force"],
        max_torque=parts["max_torque"],
        warnings=[GainWarning(**warning) for warning in parts["warnings"]],
    )


def _delay(delay: float | None) -> float:
    if delay is None:
        return -1.0
    if not 0.0 <= delay <= 1.0:
        raise InputError("tune: delay must be 0 to 1 s")
    return float(delay)


def tune(scene: Scene, *, device: str = "", delay: float | None = None) -> Gains:
    """Gains for the object of a scene in a device.

    device  address; "": the scene's
    delay   of device samples [s]; None: the device's
    """
    return _gains(_core.tune_scene(scene._scene, device, _delay(delay)))


def tune_body(
    device: str,
    mass: float,
    inertia: npt.ArrayLike,
    *,
    rate: float = 1000.0,
    delay: float | None = None,
    motion_scale: float = 1.0,
    response: str = "constraint",
) -> Gains:
    """Gains for a body in a device, without a scene.

    mass          [kg]
    inertia       one moment, or three about the principal axes [kg m^2]
    rate          of haptic frames [Hz]
    motion_scale  virtual metres per device metre
    """
    moments = np.asarray(inertia)
    if moments.ndim == 0:
        moments = np.broadcast_to(moments, (3,))
    if not 50.0 <= rate <= 20000.0:
        raise InputError("tune: rate must be 50 to 20000 Hz")
    if not 0.0 < motion_scale < float("inf"):
        raise InputError("tune: motion_scale must be a number above 0")
    options = {
        "rate": float(rate),
        "delay": _delay(delay),
        "motion_scale": float(motion_scale),
        "response": response,
    }
    checked = floats(moments, "inertia", "one moment or (3,)", 3)
    return _gains(_core.tune_body(device, float(mass), checked, options))
