"""The first lens of a task: by one face, or by two where these are better."""

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import bounded
from workbench.design.transport.lines import line_start
from workbench.design.transport.start import first_error, transport_start
from workbench.design.transport.two_faces import split_start
from workbench.geometry.faces import NO_FACES
from workbench.geometry.surface import freeform_nets
from workbench.powers import written
from workbench.said import Said
from workbench.scene import PlaneFace, Scene, WantedImage

_BOTH, _ALONE = Said("both faces"), Said("the exit face alone")
_LINES = Said("both faces along lines through all images")
# Light that both faces bend meets them less steeply, and a descent improves both: worth so much.
# What one face has made good of several images is soon at its best.
_ONE_FACE = 1.8
# Where in its range an entrance face begins that is flat: in the middle, but near to a source that
# is nearer than half the lens's width, so that more of its light meets the lens.
_PLACE, _NEAR_PLACE = 0.5, 0.1
_HANDICAP: dict[str, float] = {_ALONE: _ONE_FACE}


class First(NamedTuple):
    """A first lens."""

    # (n_u, n_v), control heights of each freeform face by its name, scene units; beyond their
    # limits where these are too narrow for the task.
    heights: dict[str, Array]
    notes: tuple[str, ...] = ()  # how it was chosen, in words, for a run's log
    # (n_u, n_v), control heights of the exit face behind a flat entrance face, the best that were
    # compared with those of both faces.
    alone: Array | None = None


def first_of(scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES) -> First | None:
    """The first lens by transport; None if no light leaves any.

    A lens of two faces begins with each bending the light by half, or with a flat entrance face
    where that makes a better image. Where one of them is fixed, the other does what is left.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v): control
    heights of one of two faces that is what it is, by its name, scene units.
    """
    if scene.optic.designed_front is None:
        heights = transport_start(scene, target)
        return None if heights is None else First({scene.optic.designed_face: heights})
    if fixed:
        both = split_start(scene, target, fixed)
        return None if both is None else First(both)
    found = {
        name: (first_error(scene, target, heights), heights)
        for name, heights in (
            (_BOTH, split_start(scene, target)),
            (_ALONE, _flat_start(scene, target)),
        )
        if heights is not None
    }
    if not found:
        return None
    errors = {name: error for name, (error, _) in found.items()}
    best = min(errors, key=lambda name: errors[name] * _HANDICAP.get(name, 1.0))
    alone = found[_ALONE][1][scene.optic.designed_face] if _ALONE in found else None
    return First(found[best][1], (_chosen(errors, best),), alone)


def first_of_several(
    scene: Scene,
    target: Array,
    alone: Callable[[WantedImage], First | None],
    fixed: Mapping[str, Array] = NO_FACES,
) -> First | None:
    """The first lens for several images: the best of one for all of them and those for each.

    `scene`: the design task, with further images; `target` (n_y, n_x): the first wanted image in
    any scale, row 0 at +y; `alone`: for a lens of which one face is free, the first one for an
    image as if there were no other; `fixed` (n_u, n_v).
    """
    # The lens has the limits that all images leave it together.
    optic = bounded(scene)
    images = [image._replace(scene=image.scene.with_optic(optic)) for image in scene.wanted(target)]
    found: dict[Said, Mapping[str, Array]] = {}
    both_free = scene.optic.designed_front is not None and not fixed
    if both_free and (both := line_start(scene, target)) is not None:
        found[_LINES] = both
    for number, image in enumerate(images, start=1):
        if both_free:
            heights = _flat_start(image.scene, image.target)
        else:
            lens = alone(image)
            heights = None if lens is None else lens.heights
        if heights is not None:
            name = (
                Said("the entrance face for image {number} alone", number=number)
                if scene.optic.designed_face in fixed
                else Said("the exit face for image {number} alone", number=number)
            )
            found[name] = heights
    if not found:
        return None
    weights = [image.weight for image in images]
    errors = {
        name: math.sqrt(
            np.average(
                [first_error(each.scene, each.target, heights) ** 2 for each in images],
                weights=weights,
            )
        )
        for name, heights in found.items()
    }
    handicap: dict[str, float] = {_LINES: 1 / _ONE_FACE}
    best = min(errors, key=lambda name: errors[name] * handicap.get(name, 1.0))
    one_face = [name for name in found if name != _LINES] if both_free else []
    exit_alone = None
    if one_face:
        exit_alone = found[min(one_face, key=errors.__getitem__)][scene.optic.designed_face]
    return First(dict(found[best]), (_chosen(errors, best),), exit_alone)


def _chosen(errors: Mapping[Said, float], best: Said) -> Said:
    """What was tried, how good it is, and what was taken."""
    tried = {
        f"first_{number}": Said(
            "{error} % by {face}", error=written(100 * error, digits=2), face=face
        )
        for number, (face, error) in enumerate(errors.items())
    }
    return Said(
        "first lens: {tried}; it begins with {best}",
        tried=Said(", ".join(f"{{{name}}}" for name in tried), **tried),
        best=best,
    )


def behind_flat_entrance(scene: Scene) -> Scene:
    """The task for the exit face alone, with as much room as beside a freeform entrance face."""
    lens = bounded(scene)
    low, high = lens.entrance_range
    near = lens.front_z - scene.source.nearest_z < max(lens.half_width)
    z = low + (_NEAR_PLACE if near else _PLACE) * (high - low)
    clear = lens.floor - z
    optic = scene.optic.with_front(PlaneFace())
    x, y, _ = optic.position
    flat = {"thickness": optic.base.height - z, "min_thickness": clear}
    return scene.with_optic(optic.model_copy(update=flat | {"position": (x, y, z)}))


def _flat_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """A first lens with a flat entrance face, where it has room to become another."""
    flat = behind_flat_entrance(scene)
    heights = transport_start(flat, target)
    if heights is None:
        return None
    front, back = freeform_nets(scene.optic).items()
    return {front[0]: np.full(front[1].shape, flat.optic.front_z), back[0]: heights}
