"""Contacts of an object with a scene at many poses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Ints, Poses, pose, poses as pose_rows
from ._core import InputError
from ._meshes import Clod, exact

_IDENTITY = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
_HAPTIC_THRESHOLD = 0.025


@dataclass(frozen=True, repr=False)
class Contacts:
    """Contacts of n poses, N in all; those of pose i are rows start[i] to start[i + 1]."""

    distance: Floats
    """Least of the contacts, negative where they overlap; infinite without one (n,) [m]."""
    start: npt.NDArray[np.int64]
    """(n + 1,)."""
    point: Floats
    """On the object (N, 3) [m; world]."""
    scene_point: Floats
    """On the scene (N, 3) [m; world]."""
    normal: Floats
    """Out of the object, into the scene (N, 3) [world]."""
    depth: Floats
    """Positive where they overlap (N,) [m]."""
    bound: Floats
    """Of the error of depth, 0 of exact contacts (N,) [m]."""
    level: Ints
    """Of detail, of object and scene, 0 the finest (N, 2)."""
    cpu: Floats
    """CPU time of the query (n,) [s]."""
    front: npt.NDArray[np.int64]
    """Pairs of nodes held after the query (n,)."""
    tests: npt.NDArray[np.int64]
    """Pairs of nodes looked at (n,)."""

    def __len__(self) -> int:
        return len(self.distance)

    @property
    def count(self) -> npt.NDArray[np.int64]:
        """Contacts of each pose (n,)."""
        return np.diff(self.start)

    @property
    def pose(self) -> npt.NDArray[np.int64]:
        """Index of the pose of each contact (N,)."""
        return np.repeat(np.arange(len(self)), self.count)

    def at(self, index: int) -> dict[str, Any]:
        """Contacts of one pose, views by the names above."""
        if not -len(self) <= index < len(self):
            raise IndexError(f"pose {index}, expected below {len(self)}")
        index %= len(self)
        rows = slice(int(self.start[index]), int(self.start[index + 1]))
        names = ("point", "scene_point", "normal", "depth", "bound", "level")
        return {name: getattr(self, name)[rows] for name in names}

    def __repr__(self) -> str:
        near = int(np.isfinite(self.distance).sum())
        return f"<thigma.Contacts {len(self.depth)} at {near} of {len(self)} poses>"


def contacts(
    object: Any,
    scene: Any,
    poses: Poses,
    tolerance: float,
    *,
    scene_pose: Poses = _IDENTITY,
    threshold: float | None = None,
    velocity: float | None = None,
    deviation_cap: float | None = None,
    budget_us: float | None = None,
    budget_tests: int | None = None,
    step_time: float = 0.001,
    fresh: bool = False,
) -> Contacts:
    """Every pair of surface patches that come within `tolerance`, as `thigma contacts` finds them.

    object, scene  Clod, Mesh, or an object that Mesh takes
    poses          of the object: (n, 7) x, y, z, qx, qy, qz, qw, or (positions, rotation) with
                   positions (n, 3) and SciPy's Rotation [m; world]
    tolerance      [m]
    scene_pose     of the scene, one pose
    threshold      levels of detail by contact: s0, a fraction of the smaller radius (0.025)
    velocity       s0 = velocity * relative speed at the contact [s]
    deviation_cap  most surface deviation of a contact, a fraction of the smaller radius
    budget_us      CPU time of a query [us]; what is left coarse for it shows in `bound`
    budget_tests   the same in pairs looked at: reproducible
    step_time      from pose to pose, for speeds [s]
    fresh          forget the pose before at every pose

    Without any of the five options of levels contacts are exact. Python's lock is released; Ctrl-C
    ends the work. Raises InputError, and TypeError for other types.
    """
    levels = (threshold, velocity, deviation_cap, budget_us, budget_tests)
    is_exact = all(option is None for option in levels)
    sides = []
    for name, side in (("object", object), ("scene", scene)):
        clod = side if isinstance(side, Clod) else exact(side)
        if not is_exact and not clod.has_levels:
            raise InputError(f"{name}: without levels of detail, expected those of build_clod")
        sides.append(clod._clod)
    options = {
        "is_exact": is_exact,
        "threshold": _HAPTIC_THRESHOLD if threshold is None else float(threshold),
        "velocity": 0.0 if velocity is None else float(velocity),
        "deviation_cap": float("inf") if deviation_cap is None else float(deviation_cap),
        "budget_tests": 0 if budget_tests is None else int(budget_tests),
        "budget_cpu": 0.0 if budget_us is None else 1e-6 * float(budget_us),
        "step_time": float(step_time),
        "fresh": bool(fresh),
    }
    rows = pose_rows(poses)
    found = _core.contacts(
        sides[0], sides[1], rows, pose(scene_pose, "scene_pose"), float(tolerance), options
    )
    return Contacts(**found)
