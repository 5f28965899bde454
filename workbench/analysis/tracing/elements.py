"""What the elements of the check do, and the rays that go from one to the next.

All of them count x, y and z as the lens does, from the middle of its entrance face. Directions and
normals may have one row that stands for all rays.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from workbench.arrays import Array, Mask


class TracedRays(NamedTuple):
    """Some rays; a ray that is lost stays among them, with no flux, and is not followed."""

    position: Array  # (m, 3), where they are, scene units
    direction: Array  # (m, 3), unit vectors
    flux: Array  # (m,), flux of each, in any unit

    def split(self, size: int) -> Iterator["TracedRays"]:
        """The same rays, at most ``size`` of them at a time."""
        alike = len(self.direction) == 1
        for first in range(0, len(self.flux), size):
            some = slice(first, first + size)
            direction = self.direction if alike else self.direction[some]
            yield TracedRays(self.position[some], direction, self.flux[some])


def joined(parts: Sequence[TracedRays]) -> TracedRays:
    """All rays of some parts."""
    return TracedRays(
        np.concatenate([rays.position for rays in parts]),
        np.concatenate([np.broadcast_to(rays.direction, rays.position.shape) for rays in parts]),
        np.concatenate([rays.flux for rays in parts]),
    )


class Crossings(NamedTuple):
    """Where rays meet a face."""

    position: Array  # (m, 3), places on the face; anything for rays without flux
    normal: Array  # (m, 3), unit normals there, to the side to which the light goes
    flux: Array  # (m,), flux of each ray that meets the face, and 0 for the others


class RandomSource(Protocol):
    """Draws rays.

    Attributes
    ----------
    beside : float
        Flux that misses the lens and is in none of the rays, over that of all rays.
    rays : int
        How many there are in all batches together.
    """

    rays: int
    beside: float

    def batch(self, number: int) -> Iterator[TracedRays]:
        """The rays of one of the batches, some at a time."""
        ...


class FaceLight(Protocol):
    """Says what light comes to places of the entrance face.

    Attributes
    ----------
    origins : int
        From how many points, or in how many directions, light comes to each place.
    emitted : float
        Flux of the source in the unit of `through`.
    places : ndarray, shape (origins, 3), optional
        Points of the origins, over the plane of the aperture; None where the light is collimated.
    """

    origins: int
    emitted: float
    places: Array | None = None

    def through(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays of one origin through places of the plane of the aperture.

        Parameters
        ----------
        origin : int
            Which of the origins.
        x, y : ndarray, shape (m,)
            Places, scene units.

        Returns
        -------
        TracedRays
            One ray for each place; its flux is that per area of the plane.
        """
        ...


class LightSource(RandomSource, FaceLight, Protocol):
    """What each kind of source is for the check.

    Attributes
    ----------
    sampled : bool
        Whether some rays are all that is known of it. Its batches are then independent samples,
        and its origins only stand for it.
    """

    sampled: bool = False

    def finer(self, level: int) -> "LightSource":
        """The same light with origins for another level of cells.

        Where few origins stand for a source of some size, they are twice as many at each level, so
        that the difference of two levels has the error of too few origins in it.
        """
        return self

    def on_disc(self, part: Array, turn: Array) -> "LightSource | None":
        """The same light from directions at some places of the disc that it comes from.

        Parameters
        ----------
        part, turn : ndarray, shape (k,)
            Places, as parts of the disc's area within their radius and of the turn.

        Returns
        -------
        LightSource or None
            Each of its k origins has as much of the light; None if there is no such disc.
        """
        return None


class TracedFace(Protocol):
    """A surface that rays meet.

    Attributes
    ----------
    missed : str
        Kind in the light account of light that does not meet it.
    """

    missed: str

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it."""
        ...

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Where rays that leave the face come back to it.

        Parameters
        ----------
        rays : TracedRays
            The rays, at the face.
        onwards : int
            1 if they are on the side of it to which +z is, -1 if on the other.

        Returns
        -------
        ndarray, shape (m, 2)
            x and y; NaN for those that do not come back.
        """
        ...


class Boundary(Protocol):
    """What a face does to the light that meets it."""

    onwards: int
    """1 if light goes on through the face, -1 if it goes back."""

    def turn(
        self, rays: TracedRays, crossings: Crossings
    ) -> tuple[TracedRays, Mapping[str, Array]]:
        """The light that goes on, and the flux (m,) that is lost, by kinds of the light account."""
        ...


class Detector(Protocol):
    """Counts rays in pixels, in one image or in several.

    Attributes
    ----------
    images : int
        How many images there are.
    pixels : int
        Pixels of each.
    """

    images: int
    pixels: int

    def hits(self, rays: TracedRays, places: Array) -> None:
        """Find where rays meet the first of the screens.

        Parameters
        ----------
        rays : TracedRays
            The rays.
        places : ndarray, shape (m, 2)
            Gets column and row in pixels; not a finite number for rays that do not meet its plane.
        """
        ...

    def in_the_way(self, rays: TracedRays, length: Array) -> Mask:
        """Which rays pass through the first of the screens before they are where they are.

        Parameters
        ----------
        rays : TracedRays
            The rays.
        length : ndarray, shape (m,)
            Length of the way that each has come.

        Returns
        -------
        ndarray of bool, shape (m,)
        """
        ...

    def count(self, rays: TracedRays, flux: Array, beside: Array) -> None:
        """Add rays to images.

        Parameters
        ----------
        rays : TracedRays
            The rays.
        flux : ndarray, shape (images, pixels)
            Flux in the pixels, along the rows.
        beside : ndarray, shape (images,)
            Flux that meets none of them.
        """
        ...
