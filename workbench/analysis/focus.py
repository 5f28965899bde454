"""Light of a lens on screens elsewhere, by the rays of the independent check."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import Tally
from workbench.arrays import Array
from workbench.progress import Progress, fraction_of, no_progress
from workbench.scene import Scene


def through_focus(
    scene: Scene,
    heights: Mapping[str, Array],
    distances: Sequence[float] | None,
    rays: int = 1_000_000,
    seed: int = 1,
    progress: Progress = no_progress,
) -> Array:
    """Irradiance on screens at several distances, from one trace.

    `distances`: z of each screen; None stands for the scene's receiver alone. Returns (k, n_y,
    n_x): flux per area on each of the k screens, row 0 at +y. Raises `Refused` if a screen may
    touch the lens, or the lens is no body.
    """
    for z in distances or ():
        with_screen_at(scene, z)
    trace = Trace(scene, heights, rays, seed, distances=distances)
    total: Tally | None = None
    for batch in trace.batches():
        total = added(total, batch)
        del batch
        progress(trace.part)
    assert total is not None
    n_x, n_y = scene.receiver.pixels
    images: Array = total.flux.reshape(-1, n_y, n_x)
    images /= total.emitted * scene.receiver.pixel_measure
    return images


def with_screen_at(scene: Scene, z: float) -> Scene:
    """The scene with its screen elsewhere.

    Raises `Refused` if the screen may touch the lens there, or the receiver is at no distance.
    """
    there = scene.with_receiver(scene.receiver.moved_to(z))
    there.check()
    return there


# Bytes of images that one trace fills.
_LARGEST_IMAGES = 1 << 27
# Most pixels along each side of an image that is kept.
_MOST_PIXELS = 512


@dataclass(frozen=True, eq=False)
class Focus:
    """The image at one distance."""

    z: float  # where the screen is
    relative_l2: float  # error against the target, ray noise included; 1 where there is no light
    efficiency: float  # part of the emitted flux that lands on the screen
    # (m_y, m_x), flux per area, row 0 at +y; the mean of some pixels where the screen has more than
    # 512 along a side, so that a long series needs little memory.
    irradiance: Array

    def to_data(self) -> dict[str, float]:
        """The figures by name, for JSON."""
        return {"z": self.z, "relative_l2": self.relative_l2, "efficiency": self.efficiency}


def screen_at(scene: Scene, heights: Mapping[str, Array], fraction: float) -> float:
    """Where a screen stands at a part of the way from the lens to the scene's screen.

    `heights` (n_u, n_v); `fraction`: above 0, which is as high as the exit face is or may be; 1 is
    the scene's screen. Returns z of the screen.
    """
    optic, onwards = scene.optic, scene.optic.onwards
    beyond = float((onwards * heights[optic.designed_face]).max())
    edge = onwards * max(onwards * optic.edge_z, beyond)
    return edge + fraction * (scene.receiver.plane_z - edge)


def focus_series(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    distances: Sequence[float],
    rays: int = 1_000_000,
    progress: Progress = no_progress,
) -> Iterator[Focus]:
    """Images at several distances, by the same rays.

    `distances`: z of each screen; as large as the scene's. Raises `Refused` if a screen may touch
    the lens.

    Examples
    --------
    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "tophat.json"))
    >>> plate = {"lens.back": np.full(task.scene.optic.net_shape, 0.5)}
    >>> series = focus_series(task.scene, task.target, plate, (4.0, 5.0, 6.0), rays=10_000)
    >>> [focus.z for focus in series]
    [4.0, 5.0, 6.0]
    """
    at_once = max(_LARGEST_IMAGES // (8 * math.prod(scene.receiver.pixels)), 1)
    for first in range(0, len(distances), at_once):
        some = distances[first : first + at_once]
        part = fraction_of(progress, first, len(some), len(distances))
        images = through_focus(scene, heights, some, rays, progress=part)
        for z, image in zip(some, images, strict=True):
            flux = scene.receiver.total(image)
            yield Focus(z, relative_l2(image, target), flux, _small(image))
        del images, image  # large ones must not wait for the next


def _small(image: Array) -> Array:
    """A copy with few enough pixels, each the mean of those it stands for."""
    for axis in (0, 1):
        count = image.shape[axis]
        first = np.arange(0, count, -(-count // _MOST_PIXELS))
        size = np.diff(first, append=count)
        image = np.add.reduceat(image, first, axis) / np.expand_dims(size, 1 - axis)
    return image
