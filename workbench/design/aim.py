"""What a first lens aims at where its source has a size that blurs the image.

It is to make, with light from the middle of the source alone, the light that comes closest to the
target when it is blurred: not the target itself. Errors of first lenses of 128 × 128 pixels, by the
independent check, where a grid of 6 × 6 points blurs over six pixels:

| what the first lens aims at | letter | photograph |
|---|---|---|
| the target | 18.0 % | 11.7 % |
| the closest light, at any places in a pixel | 13.5 % | – |
| the closest light, spread over each pixel | 10.2 % | 3.8 % |
| the same, after 40 steps of descent with light from the middle alone | 10.5 % | – |
| what no lens is below | 7.7 % | 2.8 % |

With the sun, a plate of 100 mm, an image of 200 mm at 500 mm and 256 × 256 pixels, a first lens of
384 × 384 control points for a letter is 6.6 % off where light is spread over whole pixels, 6.3 %
over halves of them, and 6.1 % over thirds (`Blur.parts`); the light itself 6.0, 5.3 and 5.1 %. No
lens is below 4.8 %. The sharp target leaves 11.8 %.

So light is spread over parts of pixels, and a descent without the size of the source is left out.

A source close by is seen under many angles by the lens, and blurred by each part of it otherwise:
the closest light is then that of no lens, and what waves it makes in the face stay there. A letter
of 64 × 64 pixels, made by an LED of 2 × 2 mm that is 30 mm before a lens of 30 mm on 64 × 64
control points, and a rectangle of 40 × 40 pixels by one of 1 × 1 mm 15 mm before it:

| what the first lens aims at | letter | verified after a run | rectangle |
|---|---|---|---|
| the target | 15.9 % | 6.3 % | 8.9 % |
| the closest light, spread over each pixel | 12.5 % | 7.4 % | 11.7 % |
| the same over thirds of pixels | 12.5 % | 8.0 % | – |
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.transport import First, first_of, first_of_several, shared_start
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.extended.deblur import spread_light
from workbench.extended.scattering import Scattering, film_scene
from workbench.geometry.faces import NO_FACES
from workbench.scene import Scene

# Control points along an axis, at most, of a lens that only tells where its face is.
_ROUGH = 64


class _Aim(NamedTuple):
    """A task for light that nothing blurs."""

    scene: Scene
    target: Array


def first_lens(scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES) -> First | None:
    """A first lens by transport; see `first_of`, and for several images `first_of_several`.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v).
    """
    scattering = Scattering.of(scene) if len(scene.images) == 1 else None
    scene = film_scene(scene)
    several = len(scene.designed_numbers) > 1
    scene = scene if several else scene.alone
    if scattering is not None:
        scene, target = _grown(scene, *scattering.unscattered(target))
    if several:
        heights = shared_start(scene, target, fixed)
        return None if heights is None else First(heights)
    if len(scene.images) > 1:
        return first_of_several(
            scene, target, lambda image: first_lens(image.scene, image.target, fixed), fixed
        )
    if Blur.of(scene).within_a_pixel or not one_over_the_lens(scene):
        return first_of(scene, target, fixed)
    # How far the designed face is from the receiver tells how wide the blur is.
    face_z = _face_z(scene, target, fixed)
    return None if face_z is None else first_of(*_aim(scene, target, face_z), fixed)


def _face_z(scene: Scene, target: Array, fixed: Mapping[str, Array]) -> float | None:
    """Mean height of the designed face; of one that is not fixed, on a net of few points."""
    face = scene.optic.designed_face
    if face in fixed:
        return float(fixed[face].mean())
    rough = first_of(_roughly(scene), target, fixed)
    return None if rough is None else float(rough.heights[face].mean())


def _roughly(scene: Scene) -> Scene:
    """The scene on a net that is quickly fitted."""
    n_u, n_v = (min(count, _ROUGH) for count in scene.optic.net_shape)
    return scene.with_optic(scene.optic.shaped(control_points=(n_u, n_v)))


def _aim(scene: Scene, target: Array, exit_z: float) -> _Aim:
    """The task whose light, blurred from an exit face at ``exit_z``, comes closest to a target."""
    receiver = scene.receiver
    blur = Blur.of(scene, exit_z).seen_in(receiver.pixels)
    parts = blur.parts
    light = spread_light(target, blur, parts)
    wide, light = _grown(scene, light, blur.margin, parts)
    return _Aim(wide.model_copy(update={"source": scene.source.sharp}), light)


def _grown(
    scene: Scene, light: Array, blur_margin: tuple[int, int], parts: int = 1
) -> tuple[Scene, Array]:
    """The task for light in parts of pixels that has the margin of a blur."""
    receiver = scene.receiver
    # Some of it may be beside the receiver, as far as there is light.
    margin = [
        m if np.isinf(most) else min(m, int((most / r - 1) / 2 * n))
        for m, most, r, n in zip(
            blur_margin, receiver.farthest, receiver.half_extent, receiver.pixels, strict=True
        )
    ]
    cut_x, cut_y = (parts * (m - kept) for m, kept in zip(blur_margin, margin, strict=True))
    light = light[cut_y : light.shape[0] - cut_y, cut_x : light.shape[1] - cut_x]
    grown = receiver.grown((margin[0], margin[1]))
    n_x, n_y = (parts * n for n in grown.pixels)
    return scene.with_receiver(grown.model_copy(update={"pixels": (n_x, n_y)})), light
