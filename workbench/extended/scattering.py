"""What a diffuser makes of an image: a convolution of that of undeflected rays.

A Lambertian diffuser does not mind the directions of rays: the receiver of undeflected ones is the
diffuser itself, and on a plane parallel to it at the distance d, all have the same kernel,
d² / π (d² + r²)². That is exact. About a ray, the kernel depends on its direction: kernels of some
places are computed for the mean direction there, and between them polynomials tell how they change.
Where rays from several parts of a lens land at one place, all have the kernel of the mean.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.extended.deblur import spread_light
from workbench.extended.scatter_kernels import ScatteredRays, across, directions_in_far_field
from workbench.scene import Scene, Screen

# Places along each axis that kernels are computed for, between which polynomials tell how they
# change, and how far from the middle of the receiver these reach in its half-extents.
_PLACES, _OUTER = 5, 1.2
# Changes of the kernel that are smaller than this part of it are left out, and most of the others:
# kernels of 6° along rays of up to 37° are off by 3 % then, and smooth images by less than 1 %.
_NEGLIGIBLE, _MOST_CHANGES = 1e-3, 10
# A pixel has so many parts for a kernel of one pixel, and at most.
_PARTS, _MOST_PARTS = 3.0, 4
# A uniform disc so many standard deviations wide, or so many distances of a Lambertian diffuser,
# damps the same waves to one half.
_DISC = 3.6
# Pixels between a Lambertian diffuser and the receiver of undeflected light.
_GAP = 0.01

Directions = Callable[[Array, Array], Array]
"""Unit vectors (k, 3) of undeflected light at k places (u, v) of a receiver."""


@dataclass(frozen=True, eq=False)
class Scattering:
    """What a diffuser makes of the image of undeflected rays."""

    # (1 + k, 2 m_y + 1, 2 m_x + 1), the mean kernel of light that is uniform in a part of a pixel,
    # and its changes, by such parts. Light that is scattered farther is missing.
    kernels: Array
    # (k, powers), of the powers of x and y that changes are multiplied by where light lands.
    factors: Array
    # Full widths along x and y of a disc that blurs about as much, pixels.
    widths: tuple[float, float]
    parts: int = 1  # of a pixel along each axis

    @classmethod
    def of(cls, scene: Scene, directions: Directions | None = None) -> "Scattering | None":
        """Return the scattering of a scene's diffuser; None without one.

        `scene`: the design task, with one image; `directions`: of light that comes to a plane
        behind a Gaussian diffuser; by default all of it comes from the middle of the element before
        it.
        """
        diffuser, receiver = scene.diffuser, scene.receiver
        if diffuser is None:
            return None
        onwards = scene.onwards(receiver)
        about_ray = diffuser.scatter.about_ray
        count = _PLACES if about_ray else 1
        steps = np.cos(math.pi * (np.arange(count) + 0.5) / count)  # as of Chebyshev
        x, y = (each.ravel() for each in np.meshgrid(steps, steps))
        u, v = (
            middle + _OUTER * half * steps
            for middle, half, steps in zip(
                receiver.middle, receiver.half_extent, (x, y), strict=True
            )
        )
        if not about_ray:
            straight = across(diffuser, receiver)
            ways = straight[None] / np.linalg.norm(straight)
        elif isinstance(receiver, Screen):
            ways = (directions or _from_middle(scene))(u, v)
        else:
            ways = directions_in_far_field(u, v, onwards)
        rays = ScatteredRays(diffuser, receiver, onwards, u, v, ways)
        widths = rays.widths()
        parts = min(math.ceil(_PARTS / min(widths)), _MOST_PARTS)
        n_x, n_y = (parts * n for n in receiver.pixels)
        finer = receiver.model_copy(update={"pixels": (n_x, n_y)})
        found = rays._replace(receiver=finer).kernels()
        mean = found.mean(axis=0)
        left, sizes, changes = np.linalg.svd(
            (found - mean).reshape(len(found), -1), full_matrices=False
        )
        size = float(np.linalg.norm(mean)) * math.sqrt(len(found))
        some = min(int(np.count_nonzero(sizes > _NEGLIGIBLE * size)), _MOST_CHANGES)
        weights = left[:, :some] * sizes[:some]
        factors = np.linalg.solve(_powers(x, y, count).T, weights).T
        kernels = np.concatenate([mean[None], changes[:some].reshape(some, *mean.shape)])
        return cls(kernels, factors, (_DISC * widths[0], _DISC * widths[1]), parts)

    def factors_at(self, pixels: tuple[int, int], margin: tuple[int, int]) -> Array:
        """Factors of the changes (k, n_y + 2 m_y, n_x + 2 m_x) in the middles of parts of pixels.

        Both numbers are of such parts; the margin is beyond the receiver on each side.
        """
        x, y = (
            ((2 * np.arange(n + 2 * m) - (n + 2 * m - 1)) / (_OUTER * n)).clip(-1, 1)
            for n, m in zip(pixels, margin, strict=True)
        )
        terms = _powers(x[None, :], -y[:, None], math.isqrt(self.factors.shape[1]))  # rows go down
        return np.asarray(np.tensordot(self.factors, terms, 1))

    @cached_property
    def _whole(self) -> Array:
        """The mean kernel by pixels, for light that is uniform in one."""
        kernel, parts = self.kernels[0], self.parts
        weights = np.convolve(np.ones(parts), np.ones(parts)) / parts
        for axis in (0, 1):
            reach = kernel.shape[axis] // 2
            margin = -(-(reach + parts - 1) // parts)
            more = (margin + 1) * parts - 1 - reach
            ends = [(0, 0), (0, 0)]
            ends[axis] = more, more
            kernel = np.moveaxis(np.pad(kernel, ends), axis, -1)
            count = 2 * margin + 1
            kernel = sum(
                weight * kernel[:, start::parts][:, :count] for start, weight in enumerate(weights)
            )
            kernel = np.moveaxis(kernel, -1, axis)
        return np.asarray(kernel)

    def unscattered(self, target: Array) -> tuple[Array, tuple[int, int]]:
        """Light that, scattered, is closest to a target (n_y, n_x), and its margin (m_x, m_y)."""
        kernel = _near(self._whole, target)
        rows, columns = kernel.shape
        return _closest_light(target, kernel), (columns // 2, rows // 2)

    def wanted(self, target: Array, margin: tuple[int, int], source: Array | None) -> Array:
        """Light wanted on a receiver and around it, (n_y + 2 m_y, n_x + 2 m_x).

        Of 1 that comes to the plane of the receiver: what falls farther away is missing. On the
        receiver it is the target (n_y, n_x). ``source`` is the kernel of the source's size, if that
        blurs it too.
        """
        from scipy.signal import fftconvolve  # late: it takes long to import

        kernel = self._whole if source is None else fftconvolve(self._whole, source)
        light = _closest_light(target, _near(kernel, target))
        wide = fftconvolve(light, kernel).clip(min=0) / light.sum()
        (n_y, n_x), (m_x, m_y) = target.shape, margin
        top, left = ((w - n) // 2 for w, n in zip(wide.shape, target.shape, strict=True))
        wide = np.pad(wide, ((m_y, m_y), (m_x, m_x)))
        cut = wide[top : top + n_y + 2 * m_y, left : left + n_x + 2 * m_x]
        seen = slice(m_y, m_y + n_y), slice(m_x, m_x + n_x)
        cut[seen] = target / target.sum() * cut[seen].sum()
        return cut


class _Kernel(NamedTuple):
    """A blur of one kernel; see `workbench.extended.deblur.Spreading`."""

    kernel: Array

    def spread(self, parts: int = 1) -> Array:
        if parts != 1:
            raise ValueError("the kernel is that of whole pixels")
        return self.kernel[None]


def _near(kernel: Array, target: Array) -> Array:
    """A kernel as far as half an image reaches, with all of its light."""
    middles = [size // 2 for size in kernel.shape]
    reach = [min(m, n // 2) for m, n in zip(middles, target.shape, strict=True)]
    rows, columns = (slice(m - k, m + k + 1) for m, k in zip(middles, reach, strict=True))
    near = kernel[rows, columns]
    return np.asarray(near / near.sum())


def _closest_light(target: Array, kernel: Array) -> Array:
    share = target / target.sum()
    return _kept_light(share.tobytes(), share.shape, kernel.tobytes(), kernel.shape).copy()


@lru_cache(maxsize=4)  # a first design and both images of a run need the same one
def _kept_light(
    target: bytes, shape: tuple[int, ...], kernel: bytes, size: tuple[int, ...]
) -> Array:
    blur = _Kernel(np.frombuffer(kernel).reshape(size))
    return spread_light(np.frombuffer(target).reshape(shape), blur)


def film_scene(scene: Scene) -> Scene:
    """Return the scene with receivers where undeflected light has to be known.

    Those of a Lambertian diffuser are right behind it, straight before where they are.
    """
    diffuser = scene.diffuser
    if diffuser is None or diffuser.scatter.about_ray:
        return scene
    images = []
    for image in scene.images:
        screen = image.receiver
        assert isinstance(screen, Screen)  # the scene refuses others
        way = across(diffuser, screen)
        side = min(2 * r / n for r, n in zip(screen.half_width, screen.pixels, strict=True))
        # Not on it: light comes to a receiver from before.
        gap = _GAP * side / float(np.linalg.norm(way))
        x, y, z = np.subtract(screen.position, (1 - gap) * way).tolist()
        moved = screen.model_copy(update={"position": (x, y, z)})
        images.append(image.model_copy(update={"receiver": moved}))
    return scene.with_images(images)


def _powers(x: Array, y: Array, count: int) -> Array:
    """So many powers of x times so many of y, along the first axis; x and y broadcast."""
    each = range(count)
    return np.stack(np.broadcast_arrays(*(x**i * y**j for i in each for j in each)))


def _from_middle(scene: Scene) -> Directions:
    before, receiver = scene.elements[-2], scene.receiver
    middle = before.in_scene(np.array([0.0, 0.0, before.leaving_z]))

    def directions(u: Array, v: Array) -> Array:
        return np.stack(receiver.towards(before, tuple(middle[:, None]), u, v), axis=-1)

    return directions
