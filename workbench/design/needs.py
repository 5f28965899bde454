"""What a run needs, all of it known before the first stage begins: nothing is designed in vain."""

from collections.abc import Mapping, Sequence

import numpy as np
import torch

from workbench.arrays import Array, Mask
from workbench.design.limits import CLOSEST, HeightLimits
from workbench.design.methods import method_of
from workbench.errors import Refused
from workbench.geometry.body import check_body
from workbench.geometry.surface import nets_of
from workbench.optics.plan import device_of
from workbench.optics.sources import emitter_of
from workbench.said import Said
from workbench.scene import Scene
from workbench.scene.stages import refused_in_stage
from workbench.scene.viewing import pixel_side

# Places of the optic along each axis at which its source has to shine somewhere.
_LOOKED_AT = 65
# Degrees from across the receiver beyond which light grazes it. A photograph on a wall that is met
# at 55 to 78 degrees is 1.5 to 1.9 % off, one at 86 degrees 4.4 %.
_GRAZES = 80.0
# Part of its light by which a picture may differ from its mirror image for being drawn in pixels.
_SYMMETRIC = 0.02


def check_stages(
    scenes: Sequence[Scene],
    first: int,
    start: Mapping[str, Array] | None,
    locked: Mapping[str, Mask],
) -> None:
    """Refuse a run that could not be carried to its end.

    `scenes`: as `Scene.stage_scenes` gives them; the last is the scene itself; `first`: number of
    the stage that the run begins with. Raises `Refused` with the path of the field, in its stage if
    it is one.
    """
    finished = scenes[-1]
    for stage, part in enumerate(scenes[first:], first):
        with refused_in_stage(stage, len(scenes) - 1, part):
            device_of(part)
            method_of(part).check(part)
            _check_lit(part)
            _check_fixed(part, start or {})
            if locked:
                _check_net(part, finished)
    if locked and start is not None:
        limits = HeightLimits.of_scene(finished, CLOSEST)
        kept = {face: limits[face].kept(each, locked.get(face)) for face, each in start.items()}
        check_body(finished, kept)


def grazed(scene: Scene) -> Said | None:
    """What will be worse for light that grazes a receiver, and what helps; None where none does."""
    for part in scene.single:
        slant = part.receiver.slant(part.optic)
        if slant > _GRAZES:
            return Said(
                "light grazes the far side of the {receiver}, at {slant:.0f} degrees from "
                "across it, where the image is less exact; turn the {receiver} towards the "
                "{optic}, or move its middle nearer to the axis",
                receiver=part.receiver.called,
                slant=slant,
                optic=part.optic.called,
            )
    return None


def reversed_on_lit_side(scene: Scene, target: Array) -> Said | None:
    """Which picture reads the wrong way round from where its light comes; None where none does.

    A scene that says from where its pictures are viewed needs no remark, and neither do those that
    are their own mirror images.
    """
    for part, light, _ in scene.wanted(target):
        unsaid = part.target.viewed_from is None and pixel_side(part) == "back"
        if unsaid and np.abs(light - light[:, ::-1]).sum() > _SYMMETRIC * light.sum():
            return Said(
                "the picture is mirror-inverted for viewers on the side of the light, and reads "
                'right from behind the {receiver}; target.viewed_from "front" turns it around',
                receiver=part.receiver.called,
            )
    return None


def _check_lit(part: Scene) -> None:
    """Refuse a source that shines away from the optic, as a lamp that is turned around."""
    places = torch.linspace(-1, 1, _LOOKED_AT, dtype=torch.float64)
    source, first = part.entrance
    r_x, r_y = first.half_width
    x, y = torch.cartesian_prod(r_x * places, r_y * places).T
    if not emitter_of(source, first).towards(x, y).flux.any():
        raise Refused(
            "source",
            Said("none of its light goes to the {optic}; turn or move it", optic=part.optic.called),
        )


def _check_fixed(part: Scene, start: Mapping[str, Array]) -> None:
    """Refuse a fixed face without control heights."""
    for number, element in enumerate(part.elements):
        for placed, face in element.fixed_faces:
            if face.content is None and placed.name not in start:
                raise Refused(
                    f"elements[{number}].{placed.path}.heights",
                    Said("the control heights of the fixed face are missing; a file (.npy)"),
                )


def _check_net(part: Scene, finished: Scene) -> None:
    """Refuse another net than that of the finished lens, which the locks are about."""
    if nets_of(part) != nets_of(finished):
        raise Refused(
            f"{part.face_path()}.control_points",
            Said(
                "{net} are not the control points of the finished {optic} that are locked; leave "
                "the stage's net out or unlock them",
                net=list(part.optic.net_shape),
                optic=part.optic.called,
            ),
        )
