"""Haptic textures: fine relief over coarse surfaces, and the depth between two of them."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Array, Floats, Poses, floats, pose, poses as pose_rows
from ._core import InputError
from ._meshes import Mesh, _mesh

_IDENTITY = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
_MOST_TEXELS = 16384


class Texture:
    """A coarse surface and what is added to it per texel; made by bake and load_texture."""

    __slots__ = ("_texture",)

    def __init__(self, texture: _core.Texture) -> None:
        self._texture = texture

    @property
    def coarse(self) -> Mesh:
        """The surface below [m]."""
        return Mesh._of(self._texture.coarse)

    @property
    def displacements(self) -> npt.NDArray[np.float32]:
        """From the coarse surface to the fine one (height, width, 3) [m; mesh frame]."""
        return self._texture.displacements

    @property
    def texel_size(self) -> float:
        """Mean side of a texel on the coarse surface [m]."""
        return self._texture.texel_size

    @property
    def amplitude(self) -> float:
        """Half the range of displacements along the coarse normals [m]."""
        return self._texture.amplitude

    @property
    def charts(self) -> int:
        """Connected pieces of the map."""
        return self._texture.charts

    @property
    def figures(self) -> dict[str, float | None]:
        """distortion_max, and fit_error_rms, fit_error_max, crack_max [m]; None: of a height map."""
        names = ("distortion_max", "fit_error_rms", "fit_error_max", "crack_max")
        return {name: getattr(self._texture, name) for name in names}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a .tex file, as `thigma bake` does. Raises IoError."""
        self._texture.save(os.fspath(path))

    def __repr__(self) -> str:
        return (
            f"<thigma.Texture {self._texture.width} x {self._texture.height} texels of "
            f"{self.texel_size:.3g} m, {self.charts} charts, amplitude {self.amplitude:.3g} m>"
        )


def bake(fine: Any, coarse: Any, *, texels: int = 1024, seed: int = 1) -> Texture:
    """The fine surface as a texture over charts of the coarse one.

    fine, coarse  Mesh, or objects that Mesh takes, in one frame [m]
    texels        along each side of the map, 16 to 16384
    seed          of the samples of the fit error

    Python's lock is released. Raises InputError.
    """
    if not 16 <= texels <= _MOST_TEXELS:
        raise InputError(f"bake: texels must be 16 to {_MOST_TEXELS}")
    if not 0 <= seed < 2**64:
        raise InputError("bake: seed must be 0 to 2^64 - 1")
    return Texture(_core.bake(_mesh(fine)._mesh, _mesh(coarse)._mesh, texels, seed))


def load_texture(path: str | os.PathLike[str], *, scale: float = 1.0) -> Texture:
    """Reads a .tex file of one texture, lengths times `scale`. Raises InputError with the reason."""
    if not (0.0 < scale < float("inf")):
        raise InputError("load_texture: scale must be a finite number above 0")
    return Texture(_core.load_texture(os.fspath(path), float(scale)))


def depth(
    object: Texture,
    scene: Texture,
    poses: Poses,
    direction: npt.ArrayLike = (0.0, 0.0, -1.0),
    *,
    scene_pose: Poses = _IDENTITY,
    method: str = "grid",
    resolution: int = 50,
) -> tuple[Floats, Array]:
    """How deep two textured surfaces are in each other along one direction.

    object, scene  Texture
    poses          of the object (n, 7) x, y, z, qx, qy, qz, qw, or (positions, rotation) [m; world]
    direction      out of the object, into the scene (3,) [world]; made of unit length
    scene_pose     one pose
    method         "grid": samples over the common domain; "branch": over all texels
    resolution     of the grid along each axis, 2 to 4096
    returns        depths (n,), positive where they penetrate, -inf where the surfaces do not face
                   each other [m]; and (n,) bool: both are height fields at the deepest place

    The translational penetration depth of textured patches, Eqs. 4.3 and 4.9. Every triangle of both
    coarse surfaces that faces the other counts. Python's lock is released; Ctrl-C ends the work.
    """
    if method not in ("grid", "branch"):
        raise InputError(f"depth: method {method!r}, expected grid or branch")
    for name, side in (("object", object), ("scene", scene)):
        if not isinstance(side, Texture):
            raise TypeError(f"{name}: {type(side).__name__}, expected Texture")
    if not 2 <= resolution <= 4096:
        raise InputError("depth: resolution must be 2 to 4096")
    towards = floats(direction, "direction", "(3,)", 3)
    length = float(np.linalg.norm(towards))
    if not 0.0 < length < float("inf"):
        raise InputError("direction: no length, expected a finite vector that is not zero")
    found = _core.depths(
        object._texture,
        scene._texture,
        pose_rows(poses),
        pose(scene_pose, "scene_pose"),
        towards / length,
        {"method": method, "resolution": int(resolution)},
    )
    return found["depth"], found["is_height_field"].astype(bool)
