"""Fixed faces about the axis of an element: planes, conics with aspheric coefficients, other sags.

A new shape of a fixed face is a subclass of `SagSurface` with its formula, and a row in
``_SHAPES``.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from workbench.analysis.tracing.elements import Crossings, TracedFace, TracedRays
from workbench.analysis.tracing.kernels import meet_plane
from workbench.arrays import Array, Mask
from workbench.geometry.outlines import Outline
from workbench.scene.faces import ConicFace, FixedFace, PlaneFace


class FlatFace:
    """Plate about the axis; a `TracedFace`.

    Parameters
    ----------
    z : float
        Where it is, over the entrance face.
    outline : Outline
        What of the plane is glass.
    missed : str
        See `TracedFace`.
    """

    def __init__(self, z: float, outline: Outline, missed: str) -> None:
        self.missed = missed
        self._z, self._half_width = z, outline.half_width
        self._curved = not outline.whole
        self._normal = np.array([[0.0, 0.0, 1.0]])

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays meet it; see `TracedFace.meet`."""
        # Rays that do not meet it get the origin: memory as it comes might hold any number.
        position, flux = np.zeros_like(rays.position), np.empty_like(rays.flux)
        meet_plane(*rays, self._z, self._half_width, self._curved, position, flux)
        return Crossings(position, self._normal, flux)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Nowhere: it is flat; see `TracedFace.met_again`."""
        return np.full((len(rays.flux), 2), np.nan)


# Places on the rim over the half-width, and steps back along a ray over the same, by rounding.
_RIM, _BACK = 1 + 1e-9, 1e-9
# Places along a ray between which the first crossing is bracketed, samples of the sag along each
# axis, and how far the bracket goes beyond them, over their range.
_PLACES, _SAGS, _BEYOND = 16, 129, 1e-2
# Steps of Newton's method or of bisection, and the last of them over the path and the rim.
_MOST_STEPS, _ROUNDING = 60, 1e-14


class SagSurface(ABC):
    """Surface z = sag(x, y) that light crosses towards +z; a `TracedFace`.

    Rays meet it by Newton's method within a bracket.

    `z`: where its vertex is; `outline`: what of it belongs to the element; `missed`: see
    `TracedFace`; `aperture_z`: plane whose outline light passes first; other rays miss the face.
    """

    def __init__(
        self, z: float, outline: Outline, missed: str, aperture_z: float | None = None
    ) -> None:
        self.missed = missed
        self._z, self._vertex, self._aperture_z = z, np.array([0.0, 0.0, z]), aperture_z
        self._half_width, self._curved = np.array(outline.half_width), not outline.whole
        rim = self._half_width.max() if self._curved else np.hypot(*self._half_width)
        self._rim2, self._back = float(rim) ** 2, _BACK * float(rim)
        x, y = (np.linspace(-r, r, _SAGS) for r in outline.half_width)
        sags = self.shape(x[:, None], y)[0]
        margin = _BEYOND * float(np.ptp(sags)) + self._back
        self._lowest, self._highest = float(sags.min()) - margin, float(sags.max()) + margin

    @abstractmethod
    def shape(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height above the vertex at (x, y), and slopes along x and y; finite beyond the rim."""

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays first meet it, from the side of -z; see `TracedFace.meet`."""
        start = rays.position - self._vertex
        way = np.broadcast_to(rays.direction, start.shape)
        with np.errstate(all="ignore"):  # rays without flux have any direction
            place = start + self._path(start, way)[:, None] * way
            normal = self._normal(place)
            hit = (rays.flux > 0) & self._inside(place) & ((normal * way).sum(axis=1) > 0)
            if self._aperture_z is not None:
                hit &= self._through_aperture(rays, self._aperture_z)
        flux = np.where(hit, rays.flux, 0.0)
        # Rays that do not meet it get the origin.
        place = np.where(hit[:, None], place + self._vertex, 0.0)
        normal = np.where(hit[:, None], normal, 0.0)
        return Crossings(place, normal, flux)

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Nowhere: only the designed face is searched; see `TracedFace.met_again`."""
        return np.full((len(rays.flux), 2), np.nan)

    def _normal(self, place: Array) -> Array:
        _, along_x, along_y = self.shape(place[:, 0], place[:, 1])
        lean = np.column_stack([-along_x, -along_y, np.ones(len(place))])
        return np.asarray(lean / np.linalg.norm(lean, axis=1, keepdims=True))

    def _inside(self, place: Array) -> Mask:
        across, up = (np.abs(place[:, :2]) / self._half_width).T
        radius = across**2 + up**2 if self._curved else np.maximum(across, up)
        inside: Mask = radius <= _RIM
        return inside

    def _through_aperture(self, rays: TracedRays, z: float) -> Mask:
        way = rays.direction / rays.direction[:, 2:]
        crossing = rays.position + (z - rays.position[:, 2:]) * way
        through: Mask = self._inside(crossing) & (rays.direction[:, 2] > 0)
        return through

    def _path(self, start: Array, way: Array) -> Array:
        """Path of each ray to its first crossing; NaN where there is none."""
        begin = ((self._lowest - start[:, 2]) / way[:, 2]).clip(min=-self._back)
        end = (self._highest - start[:, 2]) / way[:, 2]
        low = high = np.full(len(start), np.nan)
        for part in np.linspace(1, 0, _PLACES, endpoint=False):  # the first bracket is kept last
            ends = [begin + (end - begin) * each for each in (part - 1 / _PLACES, part)]
            below, above = (self._above(start, way, each)[0] for each in ends)
            first = (below <= 0) & (above > 0)
            low, high = (
                np.where(first, each, kept) for each, kept in zip(ends, (low, high), strict=True)
            )
        path = (low + high) / 2
        for _ in range(_MOST_STEPS):
            height, slope = self._above(start, way, path)
            low, high = np.where(height <= 0, path, low), np.where(height > 0, path, high)
            newton = path - height / slope
            within = (newton >= low) & (newton <= high)
            following = np.where(within, newton, (low + high) / 2)
            moved = np.abs(following - path) > _ROUNDING * (np.abs(path) + self._back / _BACK)
            path = following
            if not moved.any():
                break
        return np.asarray(path)

    def _above(self, start: Array, way: Array, path: Array) -> tuple[Array, Array]:
        """How far places along rays are above the surface, and how fast that changes."""
        x, y, z = (start + path[:, None] * way).T
        sag, along_x, along_y = self.shape(x, y)
        return z - sag, way[:, 2] - along_x * way[:, 0] - along_y * way[:, 1]


class ConicSurface(SagSurface):
    """Surface of revolution; rays meet one without aspheric coefficients in closed form.

    `face`: its shape (ISO 10110-12); the others as for `SagSurface`.
    """

    def __init__(
        self,
        face: ConicFace,
        z: float,
        outline: Outline,
        missed: str,
        aperture_z: float | None = None,
    ) -> None:
        self._curvature, self._form = 1 / face.radius, 1 + face.conic
        self._coefficients = face.coefficients if any(face.coefficients) else ()
        super().__init__(z, outline, missed, aperture_z)

    def shape(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """See `SagSurface.shape`; level from the rim on."""
        square = x**2 + y**2
        sag, by_square = self._profile(square)
        by_square = np.where(square <= _RIM**2 * self._rim2, by_square, 0.0)
        return sag, 2 * by_square * x, 2 * by_square * y

    def _profile(self, square: Array) -> tuple[Array, Array]:
        """Sag at squared distances from the axis, and its derivative by them, up to the rim."""
        square = square.clip(max=self._rim2)
        c = self._curvature
        root = np.sqrt((1 - self._form * c * c * square).clip(min=0))
        sag = c * square / (1 + root)
        by_square = c / (2 * root)
        for number, a in enumerate(self._coefficients):
            sag = sag + a * square ** (number + 2)
            by_square = by_square + a * (number + 2) * square ** (number + 1)
        return sag, by_square

    def _normal(self, place: Array) -> Array:
        _, by_square = self._profile((place[:, :2] ** 2).sum(axis=1))
        upright = np.isinf(by_square)[:, None]  # a hemisphere stands upright at its rim
        outwards = -np.sign(by_square)[:, None] * place * [1.0, 1.0, 0.0]
        lean = np.column_stack([-2 * by_square[:, None] * place[:, :2], np.ones(len(place))])
        lean = np.where(upright, outwards, lean)
        return np.asarray(lean / np.linalg.norm(lean, axis=1, keepdims=True))

    def _path(self, start: Array, way: Array) -> Array:
        """See `SagSurface._path`; of conics the first crossing within the outline.

        Of c (r² + (1 + k) z²) = 2 z, both roots are on the surface where 1 − (1 + k) c z ≥ 0.
        """
        if self._coefficients:
            return super()._path(start, way)
        c, form = self._curvature, np.array([1.0, 1.0, self._form])
        a = c * (way**2 * form).sum(axis=1)
        b = way[:, 2] - c * (start * way * form).sum(axis=1)
        d = c * (start**2 * form).sum(axis=1) - 2 * start[:, 2]
        # a t² − 2 b t + d = 0, without the difference of two numbers that are almost the same.
        both = b + np.copysign(np.sqrt(b * b - a * d), b)
        roots = np.sort([d / both, both / a], axis=0)
        found = np.full(len(start), np.nan)
        for path in roots[::-1]:  # the first of both is written last
            place = start + path[:, None] * way
            there = (path >= -self._back) & self._inside(place)
            there &= self._form * c * place[:, 2] <= 1 + _BACK
            found = np.where(there, path, found)
        return found


_SHAPES: Mapping[type, Callable[[Any, float, Outline, str, float | None], TracedFace]] = {
    PlaneFace: lambda _, z, outline, missed, aperture_z: FlatFace(z, outline, missed),
    ConicFace: ConicSurface,
}


def fixed_surface(
    face: FixedFace, z: float, outline: Outline, missed: str, aperture_z: float | None = None
) -> TracedFace:
    """Return the surface of a fixed face; for the parameters see `SagSurface`."""
    return _SHAPES[type(face)](face, z, outline, missed, aperture_z)
