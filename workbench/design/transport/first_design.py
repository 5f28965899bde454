"""The first design of a task by transport: by one face, or by two where these are better.

A source of some size blurs the image. The first design then forms, with light from the middle of
the source alone, the image that comes closest to the target when it is blurred. A grid of 6 × 6
points that blurs a letter over six pixels: error 10.2 %, and 18.0 % where the target itself is
formed; 13.5 % where the closest image may lie anywhere within a pixel. Steps of descent with a
sharp source do not help (10.5 % after 40).

A source close to the lens is blurred differently by each part of it, so the target itself is used:
a letter by an LED of 2 × 2 mm, 30 mm before a lens of 30 mm, is 6.3 % off after the run; from the
closest image it is 7.4 %.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import bounded
from workbench.design.transport.entrance import hollow, is_steep
from workbench.design.transport.one_face import first_error, transport_start
from workbench.design.transport.shared import shared_start
from workbench.design.transport.two_faces import line_start, split_start
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.extended.blurring import near
from workbench.extended.deblur import spread_light
from workbench.extended.scattering import film_scene, scattering_of
from workbench.geometry.faces import NO_FACES
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.powers import written
from workbench.scene import ConicFace, PlaneFace, Scene, WantedImage

# Parts of a pixel along each axis, at most, for the closest image: light in thirds of pixels is in
# spots that a net does not form.
_PARTS = 2
# Control points along an axis, at most, of a lens that only shows where its face is.
_ROUGH = 64
_BOTH, _ALONE = Message("both faces"), Message("the exit face alone")
_LINES = Message("both faces along lines through all images")
_HOLLOW = Message("the exit face behind a hollow entrance face")
# Light that both faces bend meets them less steeply, and a descent improves both: worth so much.
# What one face has made good of several images is soon at its best.
_ONE_FACE = 2.0
_TWO_FACES = _BOTH, _LINES, _HOLLOW
# Where in its range an entrance face begins that is flat: in the middle, but near to a source that
# is nearer than half the lens's width, so that more of its light meets the lens.
_PLACE, _NEAR_PLACE = 0.5, 0.1


class First(NamedTuple):
    """A first design."""

    # (n_u, n_v), control heights of each freeform face by its name, scene units; beyond their
    # limits where these are too narrow for the task.
    heights: dict[str, Array]
    notes: tuple[str, ...] = ()  # how it was chosen, in words, for a run's log
    # (n_u, n_v), control heights of the exit face behind a flat entrance face, the best that were
    # compared with those of both faces.
    alone: Array | None = None


def first_of(
    scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES, quick: bool = False
) -> First | None:
    """The first design by transport; None if no light leaves any.

    A lens of two faces begins with each bending the light by half, or with a flat entrance face
    where that makes a better image, or with a hollow one, where a flat one would ask too much of
    the exit face. Where one of them is fixed, the other does the rest.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v): control
    heights of one of two faces that is what it is, by its name, scene units; `quick`: whether
    transport to one face on grids of half as many cells is enough, as under a blur.
    """
    if isinstance(scene.optic.entrance, ConicFace):
        behind = split_start(scene, target)
        return None if behind is None else First(behind)
    if scene.optic.designed_front is None:
        heights = transport_start(scene, target, quick)
        return None if heights is None else First({scene.optic.designed_face: heights})
    if fixed:
        both = split_start(scene, target, fixed)
        return None if both is None else First(both)
    found = {_BOTH: split_start(scene, target), _ALONE: _flat_start(scene, target)}
    if is_steep(scene, target):
        found[_HOLLOW] = split_start(scene, target, _hollow(scene))
    return _best([WantedImage(scene, target, 1.0)], found)


def _hollow(scene: Scene) -> dict[str, Array]:
    """Control heights of an entrance face as hollow towards the source as its range allows."""
    optic = bounded(scene)
    (name, net), _ = freeform_nets(scene.optic).items()
    low, high = optic.entrance_range
    x, y = net.positions
    sag = hollow(optic, high - low).sag(x[:, None], y)
    return {name: (high + sag).clip(low, high)}


def first_of_several(
    scene: Scene,
    target: Array,
    alone: Callable[[WantedImage], First | None],
    fixed: Mapping[str, Array] = NO_FACES,
) -> First | None:
    """The first design for several images: the best of one for all of them and those for each.

    `scene`: the design task, with further images; `target` (n_y, n_x): the first wanted image in
    any scale, row 0 at +y; `alone`: for a lens of which one face is free, the first one for an
    image as if there were no other; `fixed` (n_u, n_v).
    """
    # The lens has the limits that all images leave it together.
    optic = bounded(scene)
    images = [image._replace(scene=image.scene.with_optic(optic)) for image in scene.wanted(target)]
    found: dict[Message, Mapping[str, Array] | None] = {}
    both_free = scene.optic.designed_front is not None and not fixed
    if both_free:
        found[_LINES] = line_start(scene, target)
    for number, image in enumerate(images, start=1):
        if both_free:
            heights = _flat_start(image.scene, image.target)
        else:
            lens = alone(image)
            heights = None if lens is None else lens.heights
        name = (
            Message("the entrance face for image {number} alone", number=number)
            if scene.optic.designed_face in fixed
            else Message("the exit face for image {number} alone", number=number)
        )
        found[name] = heights
    return _best(images, found)


def _best(
    images: Sequence[WantedImage], lenses: Mapping[Message, Mapping[str, Array] | None]
) -> First | None:
    """The best of some lenses for images together, in the image by which a descent begins."""
    found = {name: lens for name, lens in lenses.items() if lens is not None}
    if not found:
        return None
    weights = [image.weight for image in images]

    def error(lens: Mapping[str, Array]) -> float:
        squares = [first_error(each.scene, each.target, lens) ** 2 for each in images]
        return math.sqrt(np.average(squares, weights=weights))

    errors = {name: error(lens) for name, lens in found.items()}
    best = min(errors, key=lambda name: errors[name] * (1 if name in _TWO_FACES else _ONE_FACE))
    one_face = [name for name in found if name not in _TWO_FACES]
    exit_alone = None
    if one_face:
        exit_face = images[0].scene.optic.designed_face
        exit_alone = found[min(one_face, key=errors.__getitem__)][exit_face]
    return First(dict(found[best]), (_chosen(errors, best),), exit_alone)


def _chosen(errors: Mapping[Message, float], best: Message) -> Message:
    tried = {
        f"first_{number}": Message(
            "{error} % by {face}", error=written(100 * error, digits=2), face=face
        )
        for number, (face, error) in enumerate(errors.items())
    }
    return Message(
        "first design: {tried}; it begins with {best}",
        tried=Message(", ".join(f"{{{name}}}" for name in tried), **tried),
        best=best,
    )


def behind_flat_entrance(scene: Scene) -> Scene:
    """The task for the exit face alone, as thick as beside a freeform entrance face."""
    lens = bounded(scene)
    low, high = lens.entrance_range
    near = lens.front_z - scene.source.nearest_z < max(lens.half_width)
    z = low + (_NEAR_PLACE if near else _PLACE) * (high - low)
    clear = lens.z_min - z
    optic = scene.optic.with_front(PlaneFace())
    x, y, _ = optic.position
    flat = {"thickness": optic.base.height - z, "min_thickness": clear}
    return scene.with_optic(optic.model_copy(update=flat | {"position": (x, y, z)}))


def _flat_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """A first design with a flat entrance face, placed so that it can become another."""
    flat = behind_flat_entrance(scene)
    heights = transport_start(flat, target)
    if heights is None:
        return None
    front, back = freeform_nets(scene.optic).items()
    return {front[0]: np.full(front[1].shape, flat.optic.front_z), back[0]: heights}


def first_design(
    scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES
) -> First | None:
    """A first design by transport; see `first_of`, and for several images `first_of_several`.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v).
    """
    scattering = scattering_of(scene) if len(scene.images) == 1 else None
    scene = film_scene(scene)
    several = len(scene.designed_numbers) > 1
    scene = scene if several else scene.alone
    if scattering is not None:
        scene, target = _sharpened(scene, target, near(scattering.kernels[0], target.shape))
    if several:
        heights = shared_start(scene, target, fixed)
        return None if heights is None else First(heights)
    if len(scene.images) > 1:
        return first_of_several(
            scene, target, lambda image: first_design(image.scene, image.target, fixed), fixed
        )
    if Blur.of(scene).within_a_pixel or not one_over_the_lens(scene):
        return first_of(scene, target, fixed)
    # How far the designed face is from the receiver determines how wide the blur is.
    face_z = _face_z(scene, target, fixed)
    if face_z is None:
        return None
    blur = Blur.of(scene, face_z).seen_in(scene.receiver.pixels)
    scene, target = _sharpened(scene, target, blur.spread(min(blur.parts, _PARTS)))
    sharp = scene.model_copy(update={"source": scene.source.sharp})
    return first_of(sharp, target, fixed, quick=True)


def _face_z(scene: Scene, target: Array, fixed: Mapping[str, Array]) -> float | None:
    """Mean height of the designed face; of one that is not fixed, on a net of few points."""
    face = scene.optic.designed_face
    if face in fixed:
        return float(fixed[face].mean())
    rough = first_of(_roughly(scene), target, fixed, quick=True)
    return None if rough is None else float(rough.heights[face].mean())


def _roughly(scene: Scene) -> Scene:
    n_u, n_v = (min(count, _ROUGH) for count in scene.optic.net_shape)
    return scene.with_optic(scene.optic.shaped(control_points=(n_u, n_v)))


def _sharpened(scene: Scene, target: Array, kernels: Array) -> tuple[Scene, Array]:
    """The task for the light that, blurred, comes closest to a target, in parts of pixels.

    `kernels` (parts parts, 2 m_y + 1, 2 m_x + 1): of uniform light in these parts. The receiver
    grows by the margin of the blur, as far as there is light.
    """
    receiver, parts = scene.receiver, math.isqrt(len(kernels))
    light = spread_light(target, kernels)
    blur_margin = kernels.shape[2] // 2, kernels.shape[1] // 2
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
