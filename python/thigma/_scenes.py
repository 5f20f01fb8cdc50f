"""Scenes: what is grasped, what stands around it, and every number of the interaction."""

from __future__ import annotations

import os
from typing import Any, Callable

from . import _core
from ._arrays import Floats, Poses, pose as one_pose
from ._core import InputError
from ._meshes import Clod, _mesh


class Scene:
    """A scene with its surfaces loaded; made by load_scene and scene_from_pair, never changed."""

    __slots__ = ("_scene",)

    def __init__(self, scene: _core.Scene) -> None:
        self._scene = scene

    @property
    def file(self) -> str:
        """Name or path."""
        return self._scene.file

    @property
    def title(self) -> str:
        """One line."""
        return self._scene.title

    @property
    def device(self) -> str:
        """Address of the device that the scene asks for."""
        return self._scene.device

    @property
    def rate(self) -> float:
        """Haptic frames a second [Hz]."""
        return self._scene.rate

    @property
    def response(self) -> str:
        """penalty, direct, constraint or potential."""
        return self._scene.response

    @property
    def mass(self) -> float:
        """Of the object [kg]."""
        return self._scene.mass

    @property
    def tolerance(self) -> float:
        """Contacts begin at this distance [m]."""
        return self._scene.tolerance

    @property
    def start(self) -> Floats:
        """Pose of the object's centre of mass as the scene has it (7,) [m; world]."""
        return self._scene.start

    @property
    def body_from_mesh(self) -> Floats:
        """Pose of the object's mesh about its centre of mass (7,) [m]."""
        return self._scene.body_from_mesh

    @property
    def object(self) -> Clod:
        """Surface of the grasped object."""
        return Clod(self._scene.object)

    @property
    def statics(self) -> list[Clod]:
        """Surfaces around it."""
        return [Clod(body) for body in self._scene.statics]

    @property
    def static_poses(self) -> list[Floats]:
        """Where they stand, (7,) each [m; world]."""
        return self._scene.static_poses

    def __repr__(self) -> str:
        return (
            f"<thigma.Scene {self.file!r}, {self.object.triangle_count} triangles against "
            f"{len(self.statics)}, response {self.response}>"
        )


def _options(
    repair: bool,
    textures: bool,
    keep_levels: bool,
    cache_folder: str | os.PathLike[str],
    log: Callable[[str], None] | None,
) -> dict[str, Any]:
    return {
        "repair": bool(repair),
        "textures": bool(textures),
        "keep_levels": bool(keep_levels),
        "cache_folder": os.fspath(cache_folder),
        "log": log,
    }


def load_scene(
    path: str | os.PathLike[str],
    *,
    repair: bool = False,
    textures: bool = True,
    keep_levels: bool = True,
    cache_folder: str | os.PathLike[str] = "",
    log: Callable[[str], None] | None = None,
) -> Scene:
    """Loads a scene file (.toml) or a built-in scene; may take minutes where levels are built.

    repair        take meshes that need it repaired
    textures      False: coarse surfaces alone
    keep_levels   keep levels of detail that were built for the next time
    cache_folder  where; "": beside the mesh, or in the user's cache folder
    log           called with lines for people, such as print
    """
    options = _options(repair, textures, keep_levels, cache_folder, log)
    return Scene(_core.load_scene(os.fspath(path), options))


def scene_from_pair(
    object: Any,
    against: Any,
    scale: float = 1.0,
    *,
    pose: Poses = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    response: str = "",
    repair: bool = False,
    keep_levels: bool = True,
    cache_folder: str | os.PathLike[str] = "",
    log: Callable[[str], None] | None = None,
) -> Scene:
    """A scene of two meshes: gains by their size.

    Mesh files, models such as "procedural:ball", or meshes in memory: Mesh, or what Mesh takes. Of
    these contacts are exact, and the response is the constraint where none is named.

    object    is grasped, its mesh at `pose` [m; world]
    against   stands at the identity
    scale     metres per unit of both
    response  penalty, direct, constraint or potential; "": as fits
    others    as of load_scene, for files
    """
    if not isinstance(object, (str, os.PathLike)):
        if isinstance(against, (str, os.PathLike)):
            raise InputError("against: a file, expected a mesh in memory as the object is")
        if scale != 1.0:
            raise InputError("scale: of files, expected 1 for meshes in memory, which are in metres")
        held, standing = _mesh(object)._mesh, _mesh(against)._mesh
        return Scene(_core.mesh_pair(held, standing, one_pose(pose, "pose"), response))
    if not isinstance(against, (str, os.PathLike)):
        raise InputError("against: a mesh in memory, expected a file as the object is")
    options = _options(repair, True, keep_levels, cache_folder, log)
    return Scene(
        _core.load_pair(
            os.fspath(object),
            os.fspath(against),
            float(scale),
            one_pose(pose, "pose"),
            response,
            options,
        )
    )


def builtin_scenes() -> list[str]:
    """Names that load_scene knows without a file."""
    return _core.builtin_scene_names()
