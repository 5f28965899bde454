"""Images of a lens on screens at several distances, by the rays of the independent check."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import Tally
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.progress import Progress, fraction_of, no_progress
from workbench.scene import Scene
from workbench.scene.train import leaving


def through_focus(
    scene: Scene,
    heights: Mapping[str, Array],
    distances: Sequence[float] | None,
    rays: int = 1_000_000,
    seed: int = 1,
    progress: Progress = no_progress,
) -> Array:
    """Return the irradiance (k, n_y, n_x) on screens at several z, from one trace.

    Without ``distances`` it is that of the scene's receiver. Raises `Refused` if a screen may touch
    the lens, or the lens is no solid body.
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
    """Return the scene with its screen at z.

    Raises `Refused` if it may touch the lens there, or light comes to it across the z axis.
    """
    way = leaving(scene.source, scene.elements, scene.receiver)
    if scene.receiver.at_distance and abs(float(way[2])) < _ALONG * math.hypot(*way):
        raise Refused(
            "images[0].receiver.position[2]",
            Message(
                "{z:g}: light comes to the screen across the z axis, along which its distance "
                "changes; {now:g}",
                z=z,
                now=scene.receiver.plane_z,
            ),
        )
    there = scene.with_receiver(scene.receiver.moved_to(z))
    there.check()
    return there


_ALONG = 0.5  # least cosine of the light to the z axis along which a screen is moved
_LARGEST_IMAGES = 1 << 27  # bytes of all images of a trace
_MOST_PIXELS = 512  # along each side of an image that is returned


@dataclass(frozen=True, eq=False)
class Focus:
    """The image at one distance."""

    z: float  # of the screen
    relative_l2: float  # error against the target with ray noise; 1 without light
    efficiency: float  # part of the emitted flux on the screen
    irradiance: Array  # (m_y, m_x), row 0 at +y, averaged to at most 512 pixels a side

    def to_data(self) -> dict[str, float]:
        """The figures by name, for JSON."""
        return {"z": self.z, "relative_l2": self.relative_l2, "efficiency": self.efficiency}


def screen_at(scene: Scene, heights: Mapping[str, Array], fraction: float) -> float:
    """Return z of a screen at a fraction of the distance from the last element to the screen."""
    last = scene.elements[-1].lit(scene.source.wavelength)
    if last.designed and last.upright:
        onwards = last.onwards
        ends = np.append(heights[last.designed_face].ravel(), last.edge_z)
    else:
        onwards = 1 if leaving(scene.source, scene.elements, scene.receiver)[2] > 0 else -1
        ends = last.corners[:, 2]
    edge = onwards * float((onwards * ends).max())
    return edge + fraction * (scene.receiver.plane_z - edge)


def focus_series(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    distances: Sequence[float],
    rays: int = 1_000_000,
    progress: Progress = no_progress,
) -> Iterator[Focus]:
    """Yield images at several z by the same rays; raise Refused if a screen may touch the lens.

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
        del images, image  # frees memory before the next trace


def _small(image: Array) -> Array:
    """Average pixels of an image until it has at most 512 along a side."""
    for axis in (0, 1):
        count = image.shape[axis]
        first = np.arange(0, count, -(-count // _MOST_PIXELS))
        size = np.diff(first, append=count)
        image = np.add.reduceat(image, first, axis) / np.expand_dims(size, 1 - axis)
    return image
