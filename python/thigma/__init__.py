"""Six-degree-of-freedom haptic rendering with polygon meshes.

Units are SI: lengths [m], forces [N], times [s]. A pose is the seven numbers
x, y, z, qx, qy, qz, qw: world from body. Whatever a function cannot use is an exception with one
line that says what, where and what was expected.
"""

from ._arrays import Array, Rotations
from ._contacts import Contacts, contacts
from ._core import (
    DeviceAddressError,
    DeviceUnavailable,
    Error,
    InputError,
    IoError,
    Sample,
    __version__,
)
from ._meshes import Clod, Level, Mesh, build_clod, exact, load_clod, mesh_formats
from ._page import Page
from ._recordings import Recording, Replay, export_csv, read_recording, replay
from ._scenes import Scene, builtin_scenes, load_scene, scene_from_pair
from ._sessions import Event, Session, Summary
from ._textures import Texture, bake, depth, load_texture
from ._tune import Gain, Gains, GainWarning, tune, tune_body

__all__ = [
    "Array",
    "Clod",
    "Contacts",
    "DeviceAddressError",
    "DeviceUnavailable",
    "Error",
    "Event",
    "Gain",
    "GainWarning",
    "Gains",
    "InputError",
    "IoError",
    "Level",
    "Mesh",
    "Page",
    "Recording",
    "Replay",
    "Rotations",
    "Sample",
    "Scene",
    "Session",
    "Summary",
    "Texture",
    "__version__",
    "bake",
    "build_clod",
    "builtin_scenes",
    "contacts",
    "depth",
    "exact",
    "export_csv",
    "load_clod",
    "load_scene",
    "load_texture",
    "mesh_formats",
    "read_recording",
    "replay",
    "scene_from_pair",
    "tune",
    "tune_body",
]
