"""Light that a diffuser makes of single rays, in pixels of a receiver.

With the unit vectors d of a ray, w from its place on the diffuser to a place on the receiver at the
distance r, n across the diffuser and m across the receiver, and θ the angle between w and d, the
irradiance of a flux of 1 is

I(w) |m · w| / r²,  with I = f(θ) / N, f(θ) = exp(−θ²/2σ²) of a Gaussian diffuser.

N is the integral over all directions onwards, n · w > 0: flux is conserved. Of light that is
scattered about the normal, θ is the angle between w and n: f(θ) = cos θ of a Lambertian diffuser.
In the far field, light per solid angle is I itself. A new law is a row in ``_LAWS``.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.scene import AnyReceiver, Diffuser, GaussianScatter, LambertianScatter, Screen

# Light at more times sigma is left out: 4e-5 of all; the integral N goes so many times as far.
_REACH, _BEYOND = 4.5, 8 / 3
# Samples within the width of a kernel, and most of them in a pixel along an axis: a kernel that is
# narrower than ten of these is off by 1e-3.
_SAMPLES, _FINEST = 3.0, 32
_SMALL = 1e-4  # radians
_FAR = 1.0  # any length


class _Law(NamedTuple):
    """A law of scatter by the angle θ to the ray, or to the normal."""

    intensity: Callable[[Any, Array], Array]  # by θ, in any unit
    # Standard deviation of θ along each axis, and beyond which θ light is left out, radians; used
    # of light that is scattered about the ray.
    width: Callable[[Any], float]
    reach: Callable[[Any], float]


_LAWS: Mapping[type, _Law] = {
    GaussianScatter: _Law(
        lambda scatter, angle: np.exp(-np.square(angle / math.radians(scatter.sigma)) / 2),
        lambda scatter: math.radians(scatter.sigma),
        lambda scatter: _REACH * math.radians(scatter.sigma),
    ),
    LambertianScatter: _Law(lambda _, angle: np.cos(angle), lambda _: math.inf, lambda _: math.inf),
}


class ScatteredRays(NamedTuple):
    """Rays that come to k places of a receiver through a diffuser, undeflected."""

    # What they pass and where they come to.
    diffuser: Diffuser
    receiver: AnyReceiver
    onwards: int  # 1 for light to +z, -1 for light to -z
    # (k,), their places on the receiver.
    u: Array
    v: Array
    # (k, 3), their directions; straight across a diffuser that scatters about its normal.
    ways: Array

    def kernels(self) -> Array:
        """Kernels (k, 2 m_y + 1, 2 m_x + 1) of light that is uniform in a pixel.

        Rows go down, as in an image; light that is farther away is missing.
        """
        sides, pixels = self._pixel_sides, self.receiver.pixels
        offsets, parts = [], []
        for reach, side, width, count in zip(
            self._reach(), sides, self.widths(), pixels, strict=True
        ):
            margin = count if not reach < count * side else math.ceil(reach / side) + 1
            finer = min(max(math.ceil(_SAMPLES / width), 1), _FINEST)
            # Offsets between any two places in pixels that are so far apart.
            steps = np.arange(-(margin + 1) * finer, (margin + 1) * finer + 1)
            offsets.append(side * steps / finer)
            parts.append(finer)
        flux = self._shares(offsets[0], -offsets[1]) * math.prod(sides)
        for axis, finer in ((2, parts[0]), (1, parts[1])):
            flux = _between_pixels(flux, axis, finer)
        return flux

    def widths(self) -> tuple[float, float]:
        """Standard deviations along x and y in pixels.

        Of light that is scattered about the normal, the distance of the diffuser.
        """
        scatter, (side_x, side_y) = self.diffuser.scatter, self._pixel_sides
        if scatter.about_ray:
            x, y = self._moved(_SMALL)
            by = self._law.width(scatter) / _SMALL
            return by * x / side_x, by * y / side_y
        away = float(np.linalg.norm(across(self.diffuser, self.receiver)))
        return away / side_x, away / side_y

    @property
    def _pixel_sides(self) -> tuple[float, float]:
        half, pixels = self.receiver.half_extent, self.receiver.pixels
        x, y = (2 * r / n for r, n in zip(half, pixels, strict=True))
        return x, y

    @property
    def _law(self) -> _Law:
        return _LAWS[type(self.diffuser.scatter)]

    def _reach(self) -> tuple[float, float]:
        scatter = self.diffuser.scatter
        if not scatter.about_ray:
            return math.inf, math.inf
        return self._moved(self._law.reach(scatter))

    def _moved(self, angle: float) -> tuple[float, float]:
        """How far along u and v rays move at most that are turned; infinite if they leave."""
        if angle >= math.pi / 2:
            return math.inf, math.inf
        turns = np.arange(16) * (math.pi / 8)
        one, other = _sides(self.ways)
        sideways = np.cos(turns)[:, None, None] * one + np.sin(turns)[:, None, None] * other
        u, v = self._hits(math.cos(angle) * self.ways + math.sin(angle) * sideways)
        far_u, far_v = np.abs(u - self.u).max(), np.abs(v - self.v).max()
        return (float(far_u), float(far_v)) if far_u + far_v < math.inf else (math.inf, math.inf)

    def _shares(self, right: Array, up: Array) -> Array:
        """Flux of each ray (k, n_v, n_u) for a unit of u and v at offsets (n_u,), (n_v,)."""
        scatter, normal = self.diffuser.scatter, self._normal
        u, v = (each[:, None, None] for each in (self.u, self.v))
        to, solid_angle = self._towards(u + right, v + up[:, None])
        axes = self.ways if scatter.about_ray else np.broadcast_to(normal, self.ways.shape)
        chord = np.linalg.norm(to - axes[:, None, None], axis=-1)
        angle = 2 * np.arcsin((chord / 2).clip(max=1))
        light = self._law.intensity(scatter, angle) / self._integral(axes @ normal)[:, None, None]
        return np.asarray(np.where(to @ normal > 0, light * solid_angle, 0.0))

    def _integral(self, cosine: Array) -> Array:
        """Integral of the law about axes at an angle to the normal, over directions onwards.

        On the circle at θ, the part of the azimuths φ with cos θ cos i + sin θ sin i cos φ > 0
        counts.
        """
        scatter = self.diffuser.scatter
        nodes, weights = np.polynomial.legendre.leggauss(200)
        widest = math.pi if scatter.about_ray else math.pi / 2
        most = min(widest, _BEYOND * self._law.reach(scatter))
        theta, weights = most * (nodes + 1) / 2, most * weights / 2
        sine = np.sqrt((1 - np.square(cosine)).clip(min=1e-300))
        edge = (-cosine / sine)[:, None] / np.tan(theta)
        onwards = np.arccos(edge.clip(-1, 1)) / math.pi
        rings = 2 * math.pi * np.sin(theta) * self._law.intensity(scatter, theta) * weights
        return np.asarray(onwards @ rings)

    @property
    def _normal(self) -> Array:
        """The unit vector across the diffuser, the way that light goes."""
        normal = self.diffuser.turn[:, 2]
        return np.asarray(normal * np.sign((self.ways @ normal).sum()))

    def _origins(self, screen: Screen) -> Array:
        """Places of the rays on the diffuser, shape (k, 3), from those on a plane receiver."""
        places = _places(screen, self.u, self.v)
        normal = self._normal
        far = (places - np.array(self.diffuser.position)) @ normal / (self.ways @ normal)
        return np.asarray(places - far[:, None] * self.ways)

    def _towards(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Directions to places (k, n_v, n_u), and the solid angle of a unit of u and v there."""
        if isinstance(self.receiver, Screen):
            way = _places(self.receiver, u, v) - self._origins(self.receiver)[:, None, None]
            far = np.linalg.norm(way, axis=-1)
            to = way / far[..., None]
            return to, np.abs(to @ self.receiver.sides[2]) / np.square(far)
        return directions_in_far_field(u, v, self.onwards), np.cos(np.radians(v)) * _SQUARE_DEGREE

    def _hits(self, ways: Array) -> tuple[Array, Array]:
        """Where rays come to that go other ways (n, k, 3); not finite for some."""
        if isinstance(self.receiver, Screen):
            right, up, normal = self.receiver.sides
            origins = self._origins(self.receiver)
            middle = np.array(self.receiver.position)
            far = (middle - origins) @ normal / (ways @ normal)
            hit = origins + np.where(far > 0, far, _FAR)[..., None] * ways - middle
            return np.where(far > 0, hit @ right, np.inf), hit @ up
        x, y, z = np.moveaxis(ways, -1, 0)
        h = np.degrees(np.arctan2(x, self.onwards * z))
        return np.where(self.onwards * z > 0, h, np.inf), np.degrees(np.arcsin(y.clip(-1, 1)))


_SQUARE_DEGREE = math.radians(1) ** 2  # steradians


def across(diffuser: Diffuser, receiver: AnyReceiver) -> Array:
    """The vector from a diffuser straight to a plane parallel to it."""
    normal = diffuser.turn[:, 2]
    return np.asarray(normal @ (receiver.middle_in_scene - diffuser.position) * normal)


def directions_in_far_field(h: Array, v: Array, onwards: int) -> Array:
    """Unit vectors (..., 3) of directions in degrees."""
    h, v = np.radians(h), np.radians(v)
    parts = np.cos(v) * np.sin(h), np.sin(v), onwards * np.cos(v) * np.cos(h)
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def _places(screen: Screen, u: Array, v: Array) -> Array:
    """Places of the scene (..., 3)."""
    right, up, _ = screen.sides
    return np.asarray(np.array(screen.position) + u[..., None] * right + v[..., None] * up)


def _sides(ways: Array) -> tuple[Array, Array]:
    """Two unit vectors across each direction (k, 3), and across each other."""
    least = np.eye(3)[np.abs(ways).argmin(axis=1)]
    one = np.cross(ways, least)
    one /= np.linalg.norm(one, axis=1, keepdims=True)
    return one, np.cross(ways, one)


def _between_pixels(values: Array, axis: int, finer: int) -> Array:
    """Integrals over pixels of light that is uniform in one, from samples of so many in each."""
    values = np.moveaxis(values, axis, -1)
    triangle = (finer - np.abs(np.arange(1 - finer, finer))) / finer**2
    weights = np.convolve(triangle, [1 / 12, 10 / 12, 1 / 12])  # with the variance of 1/6 pixel
    count = (values.shape[-1] - 1) // finer - 1
    found = sum(
        weight * values[..., start::finer][..., :count] for start, weight in enumerate(weights)
    )
    return np.moveaxis(np.asarray(found), -1, axis)
