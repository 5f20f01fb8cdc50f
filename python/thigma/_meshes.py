"""Meshes and contact levels of detail."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Ints, floats, indices
from ._core import InputError


def _arrays_of(mesh: Any) -> tuple[Any, Any]:
    """Vertices and triangles by the attributes of trimesh, of meshio, or of ours."""
    if hasattr(mesh, "vertices"):
        for name in ("faces", "triangles"):
            if hasattr(mesh, name):
                return mesh.vertices, getattr(mesh, name)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        blocks = [block.data for block in mesh.cells if block.type == "triangle"]
        if blocks:
            return mesh.points, np.concatenate(blocks)
        raise InputError("mesh: cells without triangles, expected cells of the type triangle")
    raise TypeError(
        f"mesh: {type(mesh).__name__}, expected vertices and triangles, or an object with vertices "
        "and faces (trimesh) or points and cells (meshio)"
    )


class Mesh:
    """A surface of triangles that can be used: counter-clockwise from outside, no edge of three.

    vertices   (n, 3) float64 [units of `scale`], or an object with `vertices` and `faces`
               (trimesh), or with `points` and `cells` (meshio)
    triangles  (m, 3) int32; left out where the first argument is an object
    scale      metres per unit
    repair     take a mesh that needs it repaired; `repairs` says what was done

    Equal positions become one vertex and unused ones go, as when a file is read.
    Raises InputError for a mesh that cannot be used, TypeError for other types.
    """

    __slots__ = ("_mesh",)

    def __init__(
        self,
        vertices: Any,
        triangles: npt.ArrayLike | None = None,
        *,
        scale: float = 1.0,
        repair: bool = False,
    ) -> None:
        if triangles is None:
            vertices, triangles = _arrays_of(vertices)
        self._mesh = _core.Mesh(
            floats(vertices, "vertices", "(n, 3)", None, 3),
            indices(triangles, "triangles"),
            float(scale),
            bool(repair),
        )

    @classmethod
    def _of(cls, mesh: _core.Mesh) -> Mesh:
        made = cls.__new__(cls)
        made._mesh = mesh
        return made

    @classmethod
    def from_file(
        cls, path: str | os.PathLike[str], *, scale: float = 1.0, repair: bool = False
    ) -> Mesh:
        """Reads a file of `mesh_formats`, or makes a model of that name, "procedural:ball"."""
        return cls._of(_core.Mesh.from_file(os.fspath(path), float(scale), bool(repair)))

    @property
    def vertices(self) -> Floats:
        """(n, 3) float64 [m], a view that cannot be written."""
        return self._mesh.vertices

    @property
    def triangles(self) -> Ints:
        """(m, 3) int32, a view that cannot be written."""
        return self._mesh.triangles

    @property
    def faces(self) -> Ints:
        """The same as `triangles`, by the name that trimesh has for them."""
        return self._mesh.triangles

    @property
    def radius(self) -> float:
        """Of the smallest enclosing ball [m]."""
        return self._mesh.radius

    @property
    def repairs(self) -> list[str]:
        """What was repaired, a line each."""
        return self._mesh.repairs

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the format that the ending of the name chooses, else OBJ. Raises IoError."""
        self._mesh.save(os.fspath(path))

    def __repr__(self) -> str:
        return (
            f"<thigma.Mesh {len(self.vertices)} vertices, {len(self.triangles)} triangles, "
            f"radius {self.radius:.4g} m>"
        )


@dataclass(frozen=True)
class Level:
    """A level of detail: 0 the finest. A free one is made of merged nodes and has no mesh."""

    is_free: bool
    triangles: int
    patches: int
    resolution: float
    """[1/m]; infinite of the finest."""
    deviation_max: float
    """From the finest surface [m]."""
    hausdorff_max: float
    """[m]."""


class Clod:
    """Contact levels of detail of a mesh: what contacts are found on."""

    __slots__ = ("_clod",)

    def __init__(self, clod: _core.Clod) -> None:
        self._clod = clod

    @property
    def radius(self) -> float:
        """Of the smallest enclosing ball, to 1 % [m]."""
        return self._clod.radius

    @property
    def center(self) -> Floats:
        """Of that ball (3,) [m; mesh frame]."""
        return self._clod.center

    @property
    def triangle_count(self) -> int:
        """Of the finest surface."""
        return self._clod.triangle_count

    @property
    def has_levels(self) -> bool:
        """False: of the finest surface alone, as `exact` makes it."""
        return self._clod.has_levels

    @property
    def levels(self) -> list[Level]:
        """The finest first."""
        return [Level(**level) for level in self._clod.levels]

    def mesh(self, level: int = 0) -> Mesh:
        """Surface of a level that is not free. Raises IndexError."""
        if level < 0:
            raise IndexError(f"level {level}, expected 0 or more")
        return Mesh._of(self._clod.mesh(level))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a .clod file, as `thigma build` does. Raises IoError."""
        self._clod.save(os.fspath(path))

    def __repr__(self) -> str:
        kind = f"{len(self._clod.levels)} levels" if self.has_levels else "finest surface alone"
        return (
            f"<thigma.Clod {self.triangle_count} triangles, {kind}, radius {self.radius:.4g} m>"
        )


def _mesh(mesh: Any) -> Mesh:
    return mesh if isinstance(mesh, Mesh) else Mesh(mesh)


def mesh_formats() -> dict[str, str]:
    """The mesh files that are read: names of their formats, and the ending of each, ".obj".

    Files are recognised by content; the ending chooses the format that `Mesh.save` writes.
    """
    return _core.mesh_formats()


def build_clod(
    mesh: Any,
    *,
    threads: int = 0,
    contact_tolerance: float | None = None,
    progress: Callable[[float], None] | None = None,
) -> Clod:
    """Builds contact levels of detail.

    mesh               a Mesh, or an object that Mesh takes
    threads            0: as many as there are; the result is the same with any
    contact_tolerance  of the queries to come, for support areas [m]; 0.4 % of the radius
    progress           called with the share that is done, 0 to 1; what it raises ends the work
    """
    if not 0 <= threads <= 256:
        raise InputError("build_clod: threads must be a whole number of 0 to 256")
    return Clod(_core.build_clod(_mesh(mesh)._mesh, threads, contact_tolerance, progress))


def exact(mesh: Any) -> Clod:
    """The finest surface alone: what exact contacts need, built in a moment."""
    return Clod(_core.build_exact(_mesh(mesh)._mesh))


def load_clod(path: str | os.PathLike[str], *, scale: float = 1.0) -> Clod:
    """Reads a .clod file, lengths times `scale`. Raises InputError with the reason."""
    if not (0.0 < scale < float("inf")):
        raise InputError("load_clod: scale must be a finite number above 0")
    return Clod(_core.load_clod(os.fspath(path), float(scale)))
