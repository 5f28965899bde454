"""Blur of an extended source on the pixels of a receiver, its derivatives, and diffraction."""

import math
from dataclasses import dataclass, replace
from typing import Literal, Self

import numpy as np

from workbench.arrays import Array
from workbench.geometry.outlines import outline_named
from workbench.measured.lamps import of_known_size
from workbench.scene import Scene

# Sufficient positions per pixel by the width of a smooth blur along an axis: (least width in
# pixels, positions).
_PLACES = ((20.0, 1), (9.0, 2), (0.0, 4))
# Most positions in a pixel along an axis.
_MOST_PLACES = 8
# Positions of uniform light within the width of a uniform blur: they differ at its edge only.
_EVEN_PLACES = 128.0
# Subdivisions of light within the blur's width, and most subdivisions of a pixel: with a sun
# blurred over 4.6 pixels, the image has an error of 0.43 % with thirds and of 0.33 % with quarters,
# which take 1.3 times the time.
_PARTS, _MOST_PARTS = 16.0, 4
# Least subdivisions of light within a blur's width, and within a pixel where the blur is narrower:
# a run with quarters of a pixel saw 0.64 % of the 1.45 % of a letter blurred over 0.98 pixels, one
# with fifths ends at 1.33 %.
_NARROW_PARTS = 5.0
# A blur wider than this many images is equivalent to one of this width: at most one of its edges is
# in the image. Transforms of the full width would exceed the memory.
_WIDEST = 2.0
# Least distance of a source in half-widths of the lens for one blur over the whole lens.
_FAR = 4.0
# Stands for a width of 0, in pixels.
_LEAST = 1e-6
# Half-width in pixels of what has none along an axis.
_MICRO = 1e-3  # millimetres


@dataclass(frozen=True)
class Blur:
    """Image that one point of a lens makes of an extended source, in pixels of a receiver.

    Examples
    --------
    A sun 0.533° wide on a screen at 500 mm whose pixels are 0.78 mm wide:

    >>> import math
    >>> sun = 500 * math.radians(0.533) / 0.78
    >>> blur = Blur((sun, sun), "ellipse")
    >>> blur.margin, len(blur.kernels())
    ((3, 3), 16)
    """

    widths: tuple[float, float]  # full widths along x and y, pixels
    # Uniform rectangle or ellipse of these widths.
    shape: Literal["rectangle", "ellipse"] = "rectangle"
    # Instead of a uniform shape, points along x and y, the outer ones on its rim.
    points: tuple[int, int] | None = None

    @classmethod
    def of(cls, scene: Scene, exit_z: float | None = None) -> Self:
        """Return the blur of a scene's source on its receiver, the same for the whole lens.

        Points closer than a pixel become the uniform light that they stand for. ``exit_z`` is z of
        the exit face, scene units; by default the point of the undesigned lens nearest to the
        receiver.
        """
        scene = scene.alone
        source, receiver = of_known_size(scene.source, scene.optic), scene.receiver
        nearer = _relative_widths(scene, source.place, exit_z)
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
        """Return a blur that makes the same images of so many pixels, up to their flux.

        Edges that can never be in the image together are moved closer; of points, which keep their
        distance, some are dropped.
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
        """Part of the flux that the blur from `seen_in` has."""
        if self.points is not None and seen.points is not None:
            return math.prod(seen.points) / math.prod(self.points)
        pairs = zip(seen.widths, self.widths, strict=True)
        return math.prod(narrow / wide for narrow, wide in pairs if narrow != wide)

    def scaled(self, factor: float) -> Self:
        """Blur of a source so many times as wide, or on so many times as many pixels."""
        x, y = self.widths
        return replace(self, widths=(factor * x, factor * y))

    @property
    def within_a_pixel(self) -> bool:
        """Whether the blur fits into one pixel and has no effect."""
        return max(self.widths) <= 1

    @property
    def parts(self) -> int:
        """Subdivisions of a pixel along each axis for light that is to be blurred."""
        width = max(min(self.widths), 1.0)
        return max(min(math.ceil(_PARTS / width), _MOST_PARTS), math.ceil(_NARROW_PARTS / width))

    @property
    def margin(self) -> tuple[int, int]:
        """Pixels along x and y that the blur needs on each side of its middle pixel."""
        x, y = (math.floor(width / 2 + 1) for width in self.widths)
        return x, y

    def offsets(self, finer: float = 1) -> tuple[Array, Array]:
        """Return positions of the blur's middle within a pixel, along x and y.

        The light of a rectangle in a pixel is linear between the positions where one of its edges
        meets an edge of a pixel, that of points is constant between two such positions: these few
        positions represent all. An ellipse has some equidistant ones, ``finer`` times as many. In
        (-0.5, 0.5], ascending.
        """
        x, y = (self._offsets(axis, finer) for axis in (0, 1))
        return x, y

    def _offsets(self, axis: int, finer: float) -> Array:
        width = max(self.widths[axis], _LEAST)
        if self.points is None and self.shape == "rectangle":
            return _in_pixel(np.array([-width / 2, width / 2]) + 0.5)
        if self.points is not None:
            edges = _in_pixel(0.5 - self._points(axis))
            if len(edges) <= _MOST_PLACES:
                return _in_pixel((edges + np.append(edges[1:], edges[0] + 1)) / 2)
        places = next(count for least, count in _PLACES if width >= least)
        count = min(max(round(places * finer), 1), _MOST_PLACES)
        return _in_pixel(np.arange(count) / count)

    def kernels(self, finer: float = 1) -> Array:
        """Kernels (positions, 2 m_y + 1, 2 m_x + 1) for all pairs of `offsets`.

        Exact integrals over pixels, each kernel summing to 1, for margins m; rows go up.
        """
        return self._at(*self.offsets(finer))

    def _at(self, x: Array, y: Array, more: int = 0) -> Array:
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
        """Kernels (m m, 2 m_y + 1, 2 m_x + 1) for all pairs of positions (m,) in a pixel.

        Positions are in (-0.5, 0.5]; those of the same y follow each other. See `kernels`.
        """
        return self._at(places, places)

    def spread(self, parts: int = 1, wider: float = 1.0) -> Array:
        """Kernels (parts parts, 2 m_y + 1, 2 m_x + 1) of parts of a pixel with uniform light.

        The light of each part fills a square ``wider`` times as wide about its middle; margins are
        then wider. Parts in the same row follow each other.
        """
        across, up = (self._even_places(axis, parts, wider) for axis in (0, 1))
        more = max(math.ceil((wider - 1) / (2 * parts)), 0)
        return np.stack([self._at(x, y, more).mean(axis=0) for y in up for x in across])

    def _even_places(self, axis: int, parts: int, wider: float) -> Array:
        most: float = _MOST_PLACES
        if self.points is None:
            most = min(most, _EVEN_PLACES / max(self.widths[axis], _LEAST))
        middles, each = (
            (np.arange(count) + 0.5) / count - 0.5
            for count in (parts, math.ceil(most * max(wider, 1.0) / parts))
        )
        return middles[:, None] + each * (wider / parts)

    def _points(self, axis: int) -> Array:
        assert self.points is not None
        count, half = self.points[axis], self.widths[axis] / 2
        return np.linspace(-half, half, count) if count > 1 else np.zeros(1)


def one_over_the_lens(scene: Scene) -> bool:
    """Whether a source is far enough away for one blur over the whole lens.

    The rim sees a near source at a slant and from farther away, and blurs it less: at this distance
    by 6 %. A torch at 1.5 half-widths made an image with an error of 11.7 % where one blur has a
    lower bound of 12.6 %; a design with one blur for an LED at one half-width made a rectangle with
    an error of 4.8 % instead of 2.1 %.
    """
    scene = scene.alone
    optic = scene.optic
    place = of_known_size(scene.source, optic).place
    return place is None or abs(optic.datum - place[2]) >= _FAR * max(optic.half_width)


def _relative_widths(
    scene: Scene, place: tuple[float, float, float] | None, exit_z: float | None
) -> tuple[float, float]:
    optic, receiver = scene.optic, scene.receiver
    if exit_z is None:
        return 1.0, 1.0
    there, here = (receiver.per_radian(z) for z in (exit_z, optic.leaving_z))
    # In the glass, the light of a near source has a smaller angle.
    glass = (exit_z - optic.front_z) / optic.index
    path = 1.0 if place is None else 1 + glass / (optic.front_z - place[2])
    x, y = (new / old / path for new, old in zip(there, here, strict=True))
    return x, y


def _in_pixel(places: Array) -> Array:
    found = np.unique(np.round(places - np.ceil(places - 0.5), 9))
    return found[found > -0.5]


def _shares(points: Array, edges: tuple[Array, Array]) -> Array:
    low, high = (each[..., None] for each in edges)
    return np.asarray(((points >= low) & (points < high)).mean(axis=-1))


def changes_at(blur: Blur, places: Array) -> Array:
    """Derivatives (3, m m, 2 m_y + 1, 2 m_x + 1) of `Blur.at` at positions (m,) in a pixel.

    By the relative width along x and along y, and by the correlation of x and y: a shear, half of
    which moves x and half y. Each sums to 0. Raise TypeError for a blur of points, whose light
    jumps from pixel to pixel.
    """
    if blur.points is not None:
        raise TypeError("light of points jumps from pixel to pixel as their distance changes")
    r_x, r_y = (max(width / 2, _LEAST) for width in blur.widths)
    area = outline_named(blur.shape, (r_x, r_y)).area
    # Sides of pixels, all with the axes [places along y, places along x, rows, columns].
    sides_x, sides_y = (np.arange(-m - 0.5, m + 1) - places[:, None] for m in blur.margin)
    x, y = sides_x[None, :, None, :], sides_y[:, None, :, None]
    across = r_y * _chord(blur.shape, x / r_x), y[:, :, :-1], y[:, :, 1:]
    along = r_x * _chord(blur.shape, y / r_y), x[..., :-1], x[..., 1:]
    wider = -np.diff(x * _length(*across), axis=3)
    higher = -np.diff(y * _length(*along), axis=2)
    by_y, by_x = np.diff(_moment(*across), axis=3), np.diff(_moment(*along), axis=2)
    leaning = -(r_x / r_y * by_y + r_y / r_x * by_x) / 2
    found = np.stack([wider, higher, leaning]) / area
    return np.asarray(found.reshape(3, -1, *found.shape[3:]))


def _chord(shape: str, part: Array) -> Array:
    inside = np.abs(part) < 1
    half = np.sqrt(1 - np.square(part.clip(-1, 1))) if shape == "ellipse" else 1.0
    return np.where(inside, half, 0.0)


def _length(half: Array, low: Array, high: Array) -> Array:
    return np.asarray(np.clip(high, -half, half) - np.clip(low, -half, half))


def _moment(half: Array, low: Array, high: Array) -> Array:
    ends = (np.square(np.clip(end, -half, half)) for end in (high, low))
    return np.asarray((next(ends) - next(ends)) / 2)


def diffraction(scene: Scene) -> float:
    """Return the scale below which diffraction removes details, in the receiver's measure.

    √(λ · distance) on a screen: a wider part of the lens could focus better, a narrower one spreads
    more. In a far field, wavelength over width of the lens.
    """
    optic, receiver = scene.optic, scene.receiver
    wavelength = _MICRO * wavelength_um(scene)
    if not receiver.at_distance:
        return float(np.degrees(wavelength / (2 * min(optic.half_width))))
    return math.sqrt(wavelength * abs(receiver.plane_z - optic.leaving_z))


def wavelength_um(scene: Scene) -> float:
    """Wavelength of the scene's light; that of green light by default."""
    return scene.source.stated_wavelength or 0.55
