"""What a diffuser makes of an image: a convolution of that of undeflected rays.

A Lambertian diffuser does not mind the directions of rays: the receiver of undeflected ones is the
diffuser itself, and on a plane parallel to it at the distance d, all have the same kernel,
d² / π (d² + r²)². That is exact. About a ray, the kernel depends on its direction: kernels of some
places are computed for the mean direction there, and polynomials describe the changes between them.
Where rays from several parts of a lens land at one place, all have the kernel of the mean.
"""

import math
from collections.abc import Callable

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.extended.blurring import ImageBlur, powers
from workbench.extended.scatter_kernels import ScatteredRays, across, directions_in_far_field
from workbench.messages import Message
from workbench.scene import FarField, Scene, Screen

# The degree of polynomials that describe changes of kernels; they are computed for as many places
# along each axis and one more, as far from the middle of the receiver as this in its half-extents.
_DEGREE, _OUTER = 4, 1.2
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


def scattering_of(scene: Scene, directions: Directions | None = None) -> ImageBlur | None:
    """Return the blur of a scene's diffuser; None without one.

    `scene`: the design task, with one image; `directions`: of light that comes to a plane behind a
    Gaussian diffuser; by default all of it comes from the middle of the element before it. Raises
    `Refused` on a receiver of another kind than a plane or a far field.
    """
    diffuser, receiver = scene.diffuser, scene.receiver
    if diffuser is None:
        return None
    if not isinstance(receiver, Screen | FarField):
        unknown = Message(
            "light of a diffuser on {kind} cannot be computed; use a plane or a far field",
            kind=receiver.kind,
        )
        raise Refused("images[0].receiver.kind", unknown)
    onwards = scene.onwards(receiver)
    about_ray = diffuser.scatter.about_ray
    degree = _DEGREE if about_ray else 0
    steps = np.cos(math.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))  # as of Chebyshev
    x, y = (each.ravel() for each in np.meshgrid(steps, steps))
    u, v = (
        middle + _OUTER * half * each
        for middle, half, each in zip(receiver.middle, receiver.half_extent, (x, -y), strict=True)
    )
    if not about_ray:
        straight = across(diffuser, receiver)
        ways = straight[None] / np.linalg.norm(straight)
    elif isinstance(receiver, Screen):
        ways = (directions or _from_middle(scene))(u, v)
    else:
        ways = directions_in_far_field(u, v, onwards)
    rays = ScatteredRays(diffuser, receiver, onwards, u, v, ways)
    x_width, y_width = rays.widths()
    parts = min(math.ceil(_PARTS / min(x_width, y_width)), _MOST_PARTS)
    n_x, n_y = receiver.pixels
    finer = receiver.model_copy(update={"pixels": (parts * n_x, parts * n_y)})
    found = rays._replace(receiver=finer).kernels()
    mean = found.mean(axis=0)
    left, sizes, changes = np.linalg.svd(
        (found - mean).reshape(len(found), -1), full_matrices=False
    )
    size = float(np.linalg.norm(mean)) * math.sqrt(len(found))
    some = min(int(np.count_nonzero(sizes > _NEGLIGIBLE * size)), _MOST_CHANGES)
    factors = np.linalg.solve(powers(x, y, degree), left[:, :some] * sizes[:some]).T
    kernels = np.concatenate([mean[None], changes[:some].reshape(some, *mean.shape)])
    note = Message(
        "the diffuser blurs it over {x:.3g} × {y:.3g} pixels", x=_DISC * x_width, y=_DISC * y_width
    )
    return ImageBlur(
        _by_pixels(kernels, parts),
        factors.reshape(some, degree + 1, degree + 1),
        (_OUTER * n_x / 2, _OUTER * n_y / 2),
        (_DISC * x_width, _DISC * y_width),
        note,
    )


def _by_pixels(kernels: Array, parts: int) -> Array:
    """Kernels (k, parts parts, rows, columns) by pixels, from those (k, ...) by parts of them."""
    for axis in (1, 3):  # becomes two: the part where light is, and pixels from there
        kernels = np.moveaxis(kernels, axis, -1)
        reach = kernels.shape[-1] // 2
        margin = (reach + parts - 1) // parts
        wide = np.zeros((*kernels.shape[:-1], parts, (2 * margin + 1) * parts))
        for part in range(parts):
            begin = margin * parts + part - reach
            wide[..., part, begin : begin + 2 * reach + 1] = kernels
        summed = wide.reshape(*wide.shape[:-1], 2 * margin + 1, parts).sum(axis=-1)
        kernels = np.moveaxis(summed, (-2, -1), (axis, axis + 1))
    count, _, rows, _, columns = kernels.shape
    return np.ascontiguousarray(kernels.swapaxes(2, 3)).reshape(count, -1, rows, columns)


def film_scene(scene: Scene) -> Scene:
    """Return the scene with receivers where undeflected light has to be known.

    Those of a Lambertian diffuser are right behind it, straight before where they are.
    """
    diffuser = scene.diffuser
    if diffuser is None or diffuser.scatter.about_ray:
        return scene
    images = []
    for image in scene.images:
        screen = image.receiver  # a plane: the scene refuses others
        way = across(diffuser, screen)
        side = min(2 * r / n for r, n in zip(screen.half_extent, screen.pixels, strict=True))
        # Not on it: light comes to a receiver from before.
        gap = _GAP * side / float(np.linalg.norm(way))
        x, y, z = (screen.middle_in_scene - (1 - gap) * way).tolist()
        moved = screen.model_copy(update={"position": (x, y, z)})
        images.append(image.model_copy(update={"receiver": moved}))
    return scene.with_images(images)


def _from_middle(scene: Scene) -> Directions:
    before, receiver = scene.elements[-2], scene.receiver
    middle = before.in_scene(np.array([0.0, 0.0, before.leaving_z]))

    def directions(u: Array, v: Array) -> Array:
        return np.stack(receiver.towards(before, tuple(middle[:, None]), u, v), axis=-1)

    return directions
