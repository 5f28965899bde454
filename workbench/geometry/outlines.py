"""Outlines of an element within its bounding rectangle.

A new outline is a class here, a row in ``_OUTLINES``, and its name in `workbench.scene.element`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.scene import Element

if TYPE_CHECKING:
    from torch import Tensor

Numeric = TypeVar("Numeric", npt.NDArray[Any], "Tensor")


class Outline(Protocol):
    """A centred, convex outline, symmetric in x and in y; lengths in scene units."""

    @property
    def half_width(self) -> tuple[float, float]:
        """Half-widths of its bounding rectangle."""
        ...

    @property
    def area(self) -> float:
        """Its area."""
        ...

    @property
    def whole(self) -> bool:
        """Whether it is the whole bounding rectangle."""
        ...

    def contains(self, x: Numeric, y: Numeric) -> Numeric:
        """Whether points are inside or on the outline; x and y broadcast."""
        ...

    def area_inside(
        self, x: tuple[npt.ArrayLike, npt.ArrayLike], y: tuple[npt.ArrayLike, npt.ArrayLike]
    ) -> Array:
        """Area of cells within the outline, in closed form.

        ``x`` and ``y`` are low and high ends of the cells; all four broadcast.
        """
        ...

    def evenly(self, a: Array, b: Array) -> tuple[Array, Array]:
        """Map the square [0, 1]² to (x, y) with constant density."""
        ...

    def from_square(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Array, Array]:
        """Map the square [-1, 1]² smoothly to (x, y), rim onto rim."""
        ...

    def stretch(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Jacobian determinant of `from_square`."""
        ...

    def boundary(self, count: int) -> Array:
        """Closed polyline (m, 2), counterclockwise from +x, with at least ``count`` points."""
        ...


@dataclass(frozen=True)
class Rectangle:
    """The whole bounding rectangle."""

    half_width: tuple[float, float]
    whole: ClassVar[bool] = True

    @property
    def area(self) -> float:
        """See `Outline.area`."""
        return 4 * self.half_width[0] * self.half_width[1]

    def contains(self, x: Numeric, y: Numeric) -> Numeric:
        """See `Outline.contains`."""
        r_x, r_y = self.half_width
        return (abs(x) <= r_x) & (abs(y) <= r_y)

    def area_inside(
        self, x: tuple[npt.ArrayLike, npt.ArrayLike], y: tuple[npt.ArrayLike, npt.ArrayLike]
    ) -> Array:
        """See `Outline.area_inside`."""
        width, height = (
            np.clip(np.asarray(high), -r, r) - np.clip(np.asarray(low), -r, r)
            for (low, high), r in zip((x, y), self.half_width, strict=True)
        )
        return np.asarray(width * height)

    def evenly(self, a: Array, b: Array) -> tuple[Array, Array]:
        """See `Outline.evenly`."""
        r_x, r_y = self.half_width
        return (a * 2 - 1) * r_x, (b * 2 - 1) * r_y

    def from_square(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Array, Array]:
        """See `Outline.from_square`."""
        r_x, r_y = self.half_width
        x, y = np.broadcast_arrays(np.asarray(u) * r_x, np.asarray(v) * r_y)
        return x, y

    def stretch(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """See `Outline.stretch`."""
        return np.full(np.broadcast(u, v).shape, self.area / 4)

    def boundary(self, count: int) -> Array:
        """See `Outline.boundary`."""
        side = np.linspace(-1, 1, -(-count // 4), endpoint=False)
        one = np.ones_like(side)
        u = np.concatenate([one, -side, -one, side])
        v = np.concatenate([side, one, -side, -one])
        return _closed(np.stack([u, v], axis=1) * self.half_width)


@dataclass(frozen=True)
class Ellipse:
    """Ellipse with the half-widths as semi-axes."""

    half_width: tuple[float, float]
    whole: ClassVar[bool] = False

    @property
    def area(self) -> float:
        """See `Outline.area`."""
        return float(np.pi * self.half_width[0] * self.half_width[1])

    def contains(self, x: Numeric, y: Numeric) -> Numeric:
        """See `Outline.contains`."""
        r_x, r_y = self.half_width
        return (x / r_x) ** 2 + (y / r_y) ** 2 <= 1

    def area_inside(
        self, x: tuple[npt.ArrayLike, npt.ArrayLike], y: tuple[npt.ArrayLike, npt.ArrayLike]
    ) -> Array:
        """See `Outline.area_inside`."""
        r_x, r_y = self.half_width
        left, right, low, high = np.broadcast_arrays(
            *(np.divide(end, r_x) for end in x), *(np.divide(end, r_y) for end in y)
        )
        area = (
            _quadrant_area(right, high)
            - _quadrant_area(left, high)
            - _quadrant_area(right, low)
            + _quadrant_area(left, low)
        )
        # Cells that are not cut: exact, without the rounding of four large terms.
        nearest, farthest = (
            sum(np.square(part) for part in parts)
            for parts in (
                (np.clip(0.0, left, right), np.clip(0.0, low, high)),
                (np.maximum(-left, right), np.maximum(-low, high)),
            )
        )
        area = np.where(farthest <= 1, (right - left) * (high - low), area.clip(min=0))
        return np.asarray(np.where(nearest >= 1, 0.0, area) * (r_x * r_y))

    def evenly(self, a: Array, b: Array) -> tuple[Array, Array]:
        """See `Outline.evenly`: rings and sectors."""
        r_x, r_y = self.half_width
        radius, angle = np.sqrt(a), 2 * np.pi * b
        return r_x * radius * np.cos(angle), r_y * radius * np.sin(angle)

    def from_square(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Array, Array]:
        """See `Outline.from_square`; lines of one u or v become arcs of ellipses."""
        across, up = self._shrinking(u, v)
        r_x, r_y = self.half_width
        return np.asarray(np.multiply(u, r_x) * across), np.asarray(np.multiply(v, r_y) * up)

    def stretch(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """See `Outline.stretch`; 0 at the corners of the square, where its angles open."""
        across, up = self._shrinking(u, v)
        r_x, r_y = self.half_width
        return np.asarray(r_x * r_y * (1 - (np.square(u) + np.square(v)) / 2) / (across * up))

    def boundary(self, count: int) -> Array:
        """See `Outline.boundary`."""
        angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
        return _closed(np.stack([np.cos(angle), np.sin(angle)], axis=1) * self.half_width)

    @staticmethod
    def _shrinking(u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Array, Array]:
        return np.sqrt(1 - np.square(v) / 2), np.sqrt(1 - np.square(u) / 2)


_OUTLINES: Mapping[str, Callable[[tuple[float, float]], Outline]] = {
    "rectangle": Rectangle,
    "ellipse": Ellipse,
}


def outline_of(optic: Element) -> Outline:
    """Outline of an element."""
    return outline_named(optic.outline, optic.half_width)


def outline_named(name: str, half_width: tuple[float, float]) -> Outline:
    """Outline by its name in a scene, with the half-widths of its bounding rectangle."""
    return _OUTLINES[name](half_width)


def _quadrant_area(x: Array, y: Array) -> Array:
    far, high = np.abs(x).clip(max=1), np.abs(y).clip(max=1)
    corner = np.sqrt(1 - high**2)  # where the line y = const meets the circle
    beyond = np.maximum(far, corner)
    area = high * np.minimum(far, corner) + _area_below_arc(beyond) - _area_below_arc(corner)
    return np.asarray(np.sign(x) * np.sign(y) * area)


def _area_below_arc(x: Array) -> Array:
    return np.asarray((x * np.sqrt(1 - x**2) + np.arcsin(x)) / 2)


def _closed(places: Array) -> Array:
    return np.concatenate([places, places[:1]])
