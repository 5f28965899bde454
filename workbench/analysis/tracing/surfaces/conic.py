"""A conic about the axis of an element, with aspheric coefficients, as its front or back face."""

import numpy as np

from workbench.analysis.tracing.elements import Crossings, FaceLight, TracedRays
from workbench.arrays import Array, Mask
from workbench.geometry.outlines import Outline
from workbench.scene import ConicFace

# Places on the rim over the half-width, and steps back along a ray over the same, by rounding.
_RIM, _BACK = 1 + 1e-9, 1e-9
# Places along a ray between which the first crossing with an asphere is bracketed, samples of its
# sag, and how far the bracket goes beyond them, over their range.
_PLACES, _SAGS, _BEYOND = 16, 257, 1e-2
# Steps of Newton's method or of bisection, and the last of them over the path and the rim.
_MOST_STEPS, _ROUNDING = 60, 1e-14


class ConicSurface:
    """Surface of revolution that light crosses towards +z; a `TracedFace`.

    Rays meet a conic in closed form (ISO 10110-12 without coefficients), and an asphere by Newton's
    method within a bracket.

    `face`: its shape; `z`: where its vertex is; `outline`: what of it belongs to the element;
    `missed`: see `TracedFace`; `aperture_z`: plane whose outline light passes first; other rays
    miss the face.
    """

    def __init__(
        self,
        face: ConicFace,
        z: float,
        outline: Outline,
        missed: str,
        aperture_z: float | None = None,
    ) -> None:
        self.missed = missed
        self._z, self._vertex, self._aperture_z = z, np.array([0.0, 0.0, z]), aperture_z
        self._curvature, self._form = 1 / face.radius, 1 + face.conic
        self._coefficients = face.coefficients
        self._half_width, self._curved = np.array(outline.half_width), not outline.whole
        rim = self._half_width.max() if self._curved else np.hypot(*self._half_width)
        self._rim2 = float(rim) ** 2
        sags = self._shape(np.linspace(0, self._rim2, _SAGS))[0]
        margin = _BEYOND * float(np.ptp(sags)) + _BACK * float(rim)
        self._lowest, self._highest = float(sags.min()) - margin, float(sags.max()) + margin
        self._back = _BACK * float(rim)

    def meet(self, rays: TracedRays) -> Crossings:
        """Where rays first meet it, from the side of -z; see `TracedFace.meet`."""
        start = rays.position - self._vertex
        way = np.broadcast_to(rays.direction, start.shape)
        with np.errstate(all="ignore"):  # rays without flux have any direction
            path = (self._along_asphere if any(self._coefficients) else self._along_conic)(
                start, way
            )
            place = start + path[:, None] * way
            normal = self._normal(place)
            hit = (rays.flux > 0) & self._inside(place) & ((normal * way).sum(axis=1) > 0)
            if self._aperture_z is not None:
                hit &= self._through_aperture(rays)
        flux = np.where(hit, rays.flux, 0.0)
        # Rays that do not meet it get the origin.
        place = np.where(hit[:, None], place + self._vertex, 0.0)
        normal = np.where(hit[:, None], normal, 0.0)
        return Crossings(place, normal, flux, float((rays.flux - flux).sum()))

    def met_again(self, rays: TracedRays, onwards: int) -> Array:
        """Nowhere: only the designed face is searched; see `TracedFace.met_again`."""
        return np.full((len(rays.flux), 2), np.nan)

    def lit(self, source: FaceLight, origin: int, x: Array, y: Array) -> TracedRays:
        """See `TracedFace.lit`."""
        sag, by_square = self._shape(x**2 + y**2)
        rays = source.through(origin, x, y, self._z + sag)
        d_x, d_y, d_z = rays.direction.T
        lean = 1 - 2 * by_square * (d_x * x + d_y * y) / d_z
        flux = rays.flux * lean.clip(min=0)
        if self._aperture_z is not None:
            flux = np.where(self._through_aperture(rays), flux, 0.0)
        return rays._replace(flux=flux)

    def _shape(self, square: Array) -> tuple[Array, Array]:
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
        _, by_square = self._shape((place[:, :2] ** 2).sum(axis=1))
        lean = np.column_stack([-2 * by_square[:, None] * place[:, :2], np.ones(len(place))])
        rim = np.isinf(by_square)  # a hemisphere stands upright at its rim
        outwards = -np.sign(by_square)[:, None] * place * [1.0, 1.0, 0.0]
        lean = np.where(rim[:, None], outwards, lean)
        return np.asarray(lean / np.linalg.norm(lean, axis=1, keepdims=True))

    def _inside(self, place: Array) -> Mask:
        across, up = (np.abs(place[:, :2]) / self._half_width).T
        radius = across**2 + up**2 if self._curved else np.maximum(across, up)
        inside: Mask = radius <= _RIM
        return inside

    def _through_aperture(self, rays: TracedRays) -> Mask:
        assert self._aperture_z is not None
        way = rays.direction / rays.direction[:, 2:]
        crossing = rays.position + (self._aperture_z - rays.position[:, 2:]) * way
        through: Mask = self._inside(crossing) & (rays.direction[:, 2] > 0)
        return through

    def _along_conic(self, start: Array, way: Array) -> Array:
        """Path of each ray to its first crossing within the outline; NaN where there is none.

        Of c (r² + (1 + k) z²) = 2 z, both roots are on the surface where 1 − (1 + k) c z ≥ 0.
        """
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

    def _along_asphere(self, start: Array, way: Array) -> Array:
        """Path of each ray to its first crossing; NaN where there is none."""
        begin = ((self._lowest - start[:, 2]) / way[:, 2]).clip(min=-self._back)
        end = (self._highest - start[:, 2]) / way[:, 2]
        low = high = np.full(len(start), np.nan)
        for part in np.linspace(1, 0, _PLACES, endpoint=False):  # the first bracket is kept last
            ends = [begin + (end - begin) * each for each in (part - 1 / _PLACES, part)]
            below, above = (self._above(start + each[:, None] * way)[0] for each in ends)
            first = (below <= 0) & (above > 0)
            low, high = (
                np.where(first, each, kept) for each, kept in zip(ends, (low, high), strict=True)
            )
        path = (low + high) / 2
        for _ in range(_MOST_STEPS):
            height, slope = self._above(start + path[:, None] * way, way)
            low, high = np.where(height <= 0, path, low), np.where(height > 0, path, high)
            newton = path - height / slope
            within = (newton >= low) & (newton <= high)
            following = np.where(within, newton, (low + high) / 2)
            moved = np.abs(following - path) > _ROUNDING * (np.abs(path) + self._back / _BACK)
            path = following
            if not moved.any():
                break
        return np.asarray(path)

    def _above(self, place: Array, way: Array | None = None) -> tuple[Array, Array]:
        """How far places are above the surface, and how fast that changes along the rays."""
        square = (place[:, :2] ** 2).sum(axis=1)
        sag, by_square = self._shape(square)
        if way is None:
            return place[:, 2] - sag, sag
        by_square = np.where(square <= self._rim2, by_square, 0.0)
        outwards = 2 * (place[:, :2] * way[:, :2]).sum(axis=1)
        return place[:, 2] - sag, way[:, 2] - by_square * outwards
