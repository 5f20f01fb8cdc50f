"""Arrays that come in: shapes and types checked, copied where their memory is laid out otherwise."""

from __future__ import annotations

from typing import Any, Protocol, Union, runtime_checkable

import numpy as np
import numpy.typing as npt

from ._core import InputError

Array = npt.NDArray[Any]
Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int32]


@runtime_checkable
class Rotations(Protocol):
    """What SciPy's Rotation is, as far as it is needed here."""

    def as_quat(self) -> Array:
        """(4,) or (n, 4): x, y, z, w."""
        ...


Poses = Union[npt.ArrayLike, "tuple[npt.ArrayLike, Rotations]"]


def _shape_of(array: Array) -> str:
    return f"shape {array.shape}"


def floats(values: npt.ArrayLike, name: str, expected: str, *shape: int | None) -> Floats:
    """A C-ordered float64 array of this shape (None: any length)."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: dtype {array.dtype}, expected numbers, {expected}")
    if array.ndim != len(shape) or any(
        n is not None and n != m for n, m in zip(shape, array.shape)
    ):
        raise InputError(f"{name}: {_shape_of(array)}, expected {expected}")
    return np.ascontiguousarray(array, dtype=np.float64)


def indices(values: npt.ArrayLike, name: str) -> Ints:
    """A C-ordered int32 array (m, 3)."""
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: dtype {array.dtype}, expected whole numbers, (m, 3) int32")
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{name}: {_shape_of(array)}, expected (m, 3)")
    limits = np.iinfo(np.int32)
    if array.size and (array.min() < limits.min or array.max() > limits.max):
        raise InputError(f"{name}: an index beyond 32 bits, expected (m, 3) int32")
    return np.ascontiguousarray(array, dtype=np.int32)


def pose(values: Poses, name: str) -> Floats:
    """One pose (7,)."""
    rows = poses(values, name)
    if len(rows) != 1:
        raise InputError(f"{name}: {len(rows)} poses, expected one of 7 numbers")
    return np.ascontiguousarray(rows[0])


def poses(values: Poses, name: str = "poses") -> Floats:
    """Poses (n, 7), from rows of seven or from positions and a rotation."""
    expected = "(n, 7): x, y, z, qx, qy, qz, qw"
    if isinstance(values, Rotations):
        raise InputError(f"{name}: rotations without positions, expected (positions, rotations)")
    if isinstance(values, tuple) and len(values) == 2 and isinstance(values[1], Rotations):
        places = floats(np.atleast_2d(np.asarray(values[0])), name, "positions (n, 3)", None, 3)
        turns = np.atleast_2d(np.asarray(values[1].as_quat(), dtype=np.float64))
        if len(turns) == 1:
            turns = np.broadcast_to(turns, (len(places), 4))
        if len(places) == 1:
            places = np.broadcast_to(places, (len(turns), 3))
        if len(turns) != len(places):
            raise InputError(
                f"{name}: {len(places)} positions and {len(turns)} rotations, expected as many"
            )
        return np.ascontiguousarray(np.hstack((places, turns)))
    array = np.asarray(values)
    if array.ndim == 1:
        array = array[np.newaxis]
    return floats(array, name, expected, None, 7)
