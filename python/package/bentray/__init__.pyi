from collections.abc import Mapping, Sequence
from enum import IntEnum
from os import PathLike
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

class SceneError(ValueError):
    """A scene is invalid. `errors` has one dict for each error."""

    errors: list[dict[str, Any]]

class DeviceError(RuntimeError):
    """No device can render, or the device failed."""

class RenderError(RuntimeError):
    """A render failed."""

class Status(IntEnum):
    """The codes of the array `status`: how a ray ended."""

    HIT = 1
    ESCAPED = 2
    CAPTURED = 3
    ENDED = 4
    EXHAUSTED = 5
    STALLED = 6
    FAILED = 7
    OUTSIDE = 9
    CUT = 10

def devices() -> list[str]:
    """Return the names of the devices that can render, best first."""

class LensMap:
    """The ends of the rays of an image. `lens_map["direction.X"]` is an array of the shape (height, width), for the first ray of each pixel."""

    def keys(self) -> list[str]:
        """Return the names of the values."""

    def __getitem__(self, name: str) -> NDArray[Any]: ...
    @property
    def size(self) -> tuple[int, int]:
        """The width and height of the image."""

class Scene:
    """A scene, with its program on a device.

    `source` is the text of a scene file, or a dict with the same tables and keys. Files that it names are relative to `folder`.
    `device` selects a device by a part of its name.
    """

    def __init__(
        self,
        source: Union[str, Mapping[str, Any]],
        *,
        folder: Optional[Union[str, PathLike[str]]] = None,
        device: Optional[str] = None,
    ) -> None: ...
    @staticmethod
    def load(path: Union[str, PathLike[str]], *, device: Optional[str] = None) -> Scene:
        """Return the scene of a file."""

    def set(self, changes: Mapping[str, Any]) -> None:
        """Change keys of the scene, such as `{"camera.fov": 30}`; `None` removes a key.

        The next render compiles nothing if the scene needs the same program, and keeps the integration method.
        """

    def render(
        self,
        *,
        size: Optional[tuple[int, int]] = None,
        samples: Optional[int] = None,
        layers: Optional[Sequence[str]] = None,
        lens_map: Optional[LensMap] = None,
    ) -> dict[str, NDArray[Any]]:
        """Return an image: arrays by the names of layers, with the first row at the top.

        `color` has the shape (height, width, 3) and is linear; `alpha` is there if the image has any. `layers` lists other layers,
        such as `depth` and `redshift`. `size` and `samples` replace those of the scene.

        With `lens_map`, no ray is followed: the sky, lights, colors, textures and temperatures may differ from those of the scene
        that made the map.
        """

    def map(self) -> LensMap:
        """Follow the rays of the image, and return their ends, for `render(lens_map=...)`."""

    def verify(self, rays: int = 1000) -> dict[str, Any]:
        """Follow the rays of random pixels again in 64 bits, and return the errors of the image.

        `rays` is the number of pixels. Returns the keys of `verification` in the JSON of `bentray render --verify`.
        """

    def compare(
        self,
        methods: Optional[Sequence[str]] = None,
        *,
        rays: int = 100_000,
        compared: int = 300,
        repeats: int = 3,
    ) -> list[dict[str, Any]]:
        """Measure the time and the error of integration methods over their settings, like `bentray compare`.

        `methods` are names of methods, all that the law has by default. `rays` are timed, and the errors of `compared` are measured.
        Returns a dict for each setting: `method`, `words`, `setting`, `seconds_per_ray`, `evaluations_per_ray`, `error_median` and
        `error_p99` in radians (with `[radiation]`, those of the light, relative to it), `image_rms`, `wrong_terminations` and
        `unresolved`.
        """

    def trace(
        self,
        x: ArrayLike,
        v: ArrayLike,
        *,
        paths: bool = False,
        crossings: bool = False,
        jacobian: bool = False,
        optical_path: bool = False,
    ) -> dict[str, Any]:
        """Follow rays to their ends, backward in time: light arrives from the direction `v`.

        `x` and `v` are positions and velocities of the shape (rays, 3), or (3,) for all rays. Returns `status`, `x`, `v`, `tau`,
        `segments`, `steps`, `rejected` and `object`, which is -1 for none. With `paths`, it also returns `paths`, a list with the
        points of each ray's path as an array of the shape (points, 3). With `crossings`, it also returns `crossings`, a dict of arrays of
        the shape (rays, 4): `object`, `x`, `tau`, `r`, `phi`, `t`, `g` and `angle` where the ray crosses translucent surfaces and where
        it ends on a surface; NaN where there is none. With `jacobian`, it also returns `jacobian`, a dict of `direction` and `position`
        of the shape (rays, 2, 2), the derivatives of the end by the direction at the start, and `magnification`. With `optical_path`, it also returns
        `length` and `optical_path`, the integrals of ds and n ds, in media whose index is a formula.
        """

    def profile(
        self,
        kind: str = "line",
        *,
        emissivity: Optional[str] = None,
        range: Optional[tuple[float, float]] = None,
        points: int = 200,
        objects: Optional[Sequence[int]] = None,
    ) -> dict[str, NDArray[np.float64]]:
        """Return a line profile, a light curve or a spectrum of the surfaces that the camera sees.

        `kind` is "line", "light-curve" or "spectrum", and the first array is `g`, `t` or `frequency` (in hertz). `flux` belongs to
        each of its values, and `orders` has the shape (points, 4): the parts of the flux by the order of the image. `emissivity` is a
        formula of `r`, `phi`, `t` and `mu`, "r^-3" by default. `objects` are the indices of the objects that emit, all by default.
        """

    @property
    def size(self) -> tuple[int, int]:
        """The width and height of the image."""

    @property
    def method(self) -> Optional[str]:
        """The integration method, once it is chosen."""

    @property
    def toml(self) -> str:
        """The text of the scene, without later changes."""

    def png(self) -> bytes:
        """Return the image as a PNG, with the exposure and tone map of the scene."""
