"""The blur that a source of some size lays over the pixels of a receiver."""

import math
from dataclasses import dataclass, replace
from typing import Literal, Self

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import outline_named
from workbench.measured.lamps import of_known_size
from workbench.scene import Scene

# Where a blur is smooth along an axis, so many places of it in each pixel tell it from all others:
# (least width in pixels, places).
_PLACES = ((20.0, 1), (9.0, 2), (0.0, 4))
# Places in a pixel along an axis, at most.
_MOST_PLACES = 8
# Places of evenly spread light in the width of an even blur: only at its edge do they differ.
_EVEN_PLACES = 128.0
# Light that is to be blurred is divided into so many parts of the blur's width, but not in more
# than so many parts of a pixel: of a lens that blurs the sun over 4.6 pixels, the image is 0.43 %
# off with thirds and 0.33 % with quarters, which take 1.3 times the time.
_PARTS, _MOST_PARTS = 16.0, 4
# A blur that is wider than so many images is as good as one of this width: wherever its light is
# put, one edge of it is in the image at most. Transforms of all of it would take all memory.
_WIDEST = 2.0
# Half-widths of the lens that a source is away, at least, for one blur over all of it.
_FAR = 4.0
# Width in pixels of what has none along an axis.
_LEAST = 1e-6


@dataclass(frozen=True)
class Blur:
    """What one place of a lens makes of a source on the pixels of a receiver.

    Attributes
    ----------
    widths : tuple[float, float]
        Full widths along x and y, pixels.
    shape : str
        An evenly bright rectangle or ellipse of these widths.
    points : tuple[int, int], optional
        In place of an even shape, so many points along x and y, the outer ones on its rim.

    Examples
    --------
    A sun 0.533° wide on a screen at 500 mm whose pixels are 0.78 mm wide:

    >>> import math
    >>> sun = 500 * math.radians(0.533) / 0.78
    >>> blur = Blur((sun, sun), "ellipse")
    >>> blur.margin, len(blur.kernels())
    ((3, 3), 16)
    """

    widths: tuple[float, float]
    shape: Literal["rectangle", "ellipse"] = "rectangle"
    points: tuple[int, int] | None = None

    @classmethod
    def of(cls, scene: Scene, exit_z: float | None = None) -> Self:
        """The blur that a scene's source lays over its receiver, the same all over the lens.

        Points that are closer than a pixel are the even light that they stand for, each that of a
        cell about it.

        Parameters
        ----------
        scene : Scene
            The design task.
        exit_z : float, optional
            Where the exit face is, scene units; where that of the undesigned lens is nearest to
            the receiver by default.
        """
        scene = scene.alone
        source, receiver = of_known_size(scene.source, scene.optic), scene.receiver
        nearer = _nearer(scene, source.place, exit_z)
        x, y = (
            width * part * pixels / (2 * half)
            for width, part, pixels, half in zip(
                source.blur(scene.optic, receiver),
                nearer,
                receiver.pixels,
                receiver.half_extent,
                strict=True,
            )
        )
        points = source.blur_points
        if points is not None and x <= points[0] - 1 and y <= points[1] - 1:
            m_x, m_y = points
            x, y = x * m_x / max(m_x - 1, 1), y * m_y / max(m_y - 1, 1)
            points = None
        return cls((x, y), source.blur_shape, points)

    def seen_in(self, pixels: tuple[int, int]) -> Self:
        """A blur that makes the same images of so many pixels along x and y, up to their flux.

        Edges of it that can never be in the image together are brought nearer to each other; of
        points, which stay as far apart as they are, some are left out.
        """
        widths, counts = list(self.widths), list(self.points or ())
        for axis, count in enumerate(pixels):
            most, width = _WIDEST * count, widths[axis]
            if width > most and not counts:
                widths[axis] = most
            elif width > most:
                apart = width / (counts[axis] - 1)
                counts[axis] = 1 + math.floor(most / apart)
                widths[axis] = apart * (counts[axis] - 1)
        points = (counts[0], counts[1]) if counts else None
        return replace(self, widths=(widths[0], widths[1]), points=points)

    def part_in(self, seen: Self) -> float:
        """Which part of its light one that is `seen_in` an image has."""
        if self.points is not None and seen.points is not None:
            return math.prod(seen.points) / math.prod(self.points)
        pairs = zip(seen.widths, self.widths, strict=True)
        return math.prod(narrow / wide for narrow, wide in pairs if narrow != wide)

    def scaled(self, factor: float) -> Self:
        """That of a source so many times as wide, or on so many times as many pixels."""
        x, y = self.widths
        return replace(self, widths=(factor * x, factor * y))

    @property
    def within_a_pixel(self) -> bool:
        """Whether it hides nothing: all of it fits into one pixel."""
        return max(self.widths) <= 1

    @property
    def parts(self) -> int:
        """Into how many parts along each axis pixels are cut for light that it is to blur."""
        return min(math.ceil(_PARTS / max(min(self.widths), 1.0)), _MOST_PARTS)

    @property
    def margin(self) -> tuple[int, int]:
        """Pixels along x and y that it takes on each side of the one that its middle is in."""
        x, y = (math.floor(width / 2 + 1) for width in self.widths)
        return x, y

    def offsets(self, finer: int = 1) -> tuple[Array, Array]:
        """Places of its middle along x and y to look at, pixels from the middle of a pixel.

        The light of a rectangle in a pixel is linear between the places where one of its edges
        meets one of a pixel, that of points is the same all the way between two such places: these
        few places stand for all. Of an ellipse there are some, evenly spread.

        Parameters
        ----------
        finer : int
            Times as many places, where a few do not stand for all.

        Returns
        -------
        tuple of two ndarray
            In (-0.5, 0.5], ascending.
        """
        x, y = (self._offsets(axis, finer) for axis in (0, 1))
        return x, y

    def _offsets(self, axis: int, finer: int) -> Array:
        width = max(self.widths[axis], _LEAST)
        if self.points is None and self.shape == "rectangle":
            return _in_pixel(np.array([-width / 2, width / 2]) + 0.5)
        if self.points is not None:
            edges = _in_pixel(0.5 - self._points(axis))
            if len(edges) <= _MOST_PLACES:
                return _in_pixel((edges + np.append(edges[1:], edges[0] + 1)) / 2)
        places = next(count for least, count in _PLACES if width >= least)
        count = min(places * finer, _MOST_PLACES)
        return _in_pixel(np.arange(count) / count)

    def kernels(self, finer: int = 1) -> Array:
        """Light in each pixel about that of its middle, for all pairs of `offsets`.

        Returns
        -------
        ndarray, shape (places, 2 m_y + 1, 2 m_x + 1)
            Exact integrals over pixels, each kernel summing to 1, for margins m; rows go up.
        """
        return self._at(*self.offsets(finer))

    def _at(self, x: Array, y: Array, more: int = 0) -> Array:
        """Kernels with the middle at places x, y in a pixel, or up to ``more`` pixels beyond."""
        (left, right), (low, high) = (
            (edges[..., :-1], edges[..., 1:])
            for edges in (
                np.arange(-m - more - 0.5, m + more + 1) - offsets[:, None]
                for m, offsets in zip(self.margin, (x, y), strict=True)
            )
        )
        if self.points is not None:
            across, up = (
                _shares(self._points(axis), edges)
                for axis, edges in enumerate(((left, right), (low, high)))
            )
            found = up[:, None, :, None] * across[None, :, None, :]
        else:
            r_x, r_y = (max(width, _LEAST) / 2 for width in self.widths)
            outline = outline_named(self.shape, (r_x, r_y))
            ends = (
                (left[None, :, None, :], right[None, :, None, :]),
                (low[:, None, :, None], high[:, None, :, None]),
            )
            found = outline.area_inside(*ends) / outline.area
        return np.asarray(found.reshape(-1, *found.shape[2:]))

    def at(self, places: Array) -> Array:
        """Kernels for a middle at all pairs of places in a pixel; see `kernels`.

        Parameters
        ----------
        places : ndarray, shape (m,)
            In (-0.5, 0.5], along each axis.

        Returns
        -------
        ndarray, shape (m m, 2 m_y + 1, 2 m_x + 1)
            Those of the same place along y one after the other.
        """
        return self._at(places, places)

    def spread(self, parts: int = 1, wider: float = 1.0) -> Array:
        """Light in each pixel about parts of one whose light is spread evenly before it is blurred.

        Parameters
        ----------
        parts : int
            Into so many along each axis a pixel is cut.
        wider : float
            The light of each part is spread over a square so many times as wide about its middle.

        Returns
        -------
        ndarray, shape (parts parts, 2 m_y + 1, 2 m_x + 1)
            Parts in the same row one after the other. Margins m are wider where light is spread
            beyond the pixel.
        """
        across, up = (self._even_places(axis, parts, wider) for axis in (0, 1))
        more = max(math.ceil((wider - 1) / (2 * parts)), 0)
        return np.stack([self._at(x, y, more).mean(axis=0) for y in up for x in across])

    def _even_places(self, axis: int, parts: int, wider: float) -> Array:
        """Places that stand for the light about each part of a pixel, shape (parts, places)."""
        most: float = _MOST_PLACES
        if self.points is None:
            most = min(most, _EVEN_PLACES / max(self.widths[axis], _LEAST))
        middles, each = (
            (np.arange(count) + 0.5) / count - 0.5
            for count in (parts, math.ceil(most * max(wider, 1.0) / parts))
        )
        return middles[:, None] + each * (wider / parts)

    def _points(self, axis: int) -> Array:
        """Where its points are along an axis, pixels from its middle."""
        assert self.points is not None
        count, half = self.points[axis], self.widths[axis] / 2
        return np.linspace(-half, half, count) if count > 1 else np.zeros(1)


def one_over_the_lens(scene: Scene) -> bool:
    """Whether a source is far enough away for one blur over the whole lens.

    The rim sees one that is near at a slant and from farther away, and blurs it less: at this
    distance by 6 %. A torch 1.5 half-widths away made an image that was 11.7 % off where one blur
    allowed no less than 12.6 %, and where a design took it for the same everywhere, an LED one
    half-width away made a rectangle that was 4.8 % off in place of 2.1 %.
    """
    scene = scene.alone
    optic = scene.optic
    place = of_known_size(scene.source, optic).place
    return place is None or abs(optic.datum - place[2]) >= _FAR * max(optic.half_width)


def _nearer(
    scene: Scene, place: tuple[float, float, float] | None, exit_z: float | None
) -> tuple[float, float]:
    """How much narrower along x and y a blur is from an exit face elsewhere."""
    optic, receiver = scene.optic, scene.receiver
    if exit_z is None:
        return 1.0, 1.0
    there, here = (receiver.per_radian(z) for z in (exit_z, optic.leaving_z))
    # In the glass, light goes on at a smaller angle from a source that is near.
    glass = (exit_z - optic.front_z) / optic.index
    way = 1.0 if place is None else 1 + glass / (optic.front_z - place[2])
    x, y = (new / old / way for new, old in zip(there, here, strict=True))
    return x, y


def _in_pixel(places: Array) -> Array:
    """Different places within a pixel, in (-0.5, 0.5]."""
    found = np.unique(np.round(places - np.ceil(places - 0.5), 9))
    return found[found > -0.5]


def _shares(points: Array, edges: tuple[Array, Array]) -> Array:
    """Parts of points in cells between low and high edges; shape of these."""
    low, high = (each[..., None] for each in edges)
    return np.asarray(((points >= low) & (points < high)).mean(axis=-1))
