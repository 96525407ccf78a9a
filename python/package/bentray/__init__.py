"""Renders and traces light that does not travel straight: around black holes, through lenses, force fields and flows.

>>> import bentray
>>> scene = bentray.Scene.load("scenes/black_hole.toml")
>>> picture = scene.render(size=(320, 180))
>>> picture["color"].shape
(180, 320, 3)
"""

from enum import IntEnum

from ._bentray import DeviceError, LensMap, RenderError, Scene, SceneError, __version__, devices
from ._bentray import statuses as _statuses

__all__ = ["DeviceError", "LensMap", "RenderError", "Scene", "SceneError", "Status", "__version__", "devices"]

Status = IntEnum("Status", _statuses(), module=__name__)
Status.__doc__ = "The codes of the array `status`: how a ray ended."
