"""Checks of a task before its run, and of its net after the run."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch

from workbench.arrays import Array, Mask
from workbench.design.limits import CLOSEST, HeightLimits
from workbench.design.loss import relative_error
from workbench.design.methods import method_of
from workbench.design.net import definite
from workbench.design.snapshot import Result, has_converged
from workbench.errors import Refused
from workbench.extended.blur import Blur
from workbench.geometry.body import check_body
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.optics.plan import device_of
from workbench.optics.sources import emitter_of
from workbench.scene import AutoNet, Scene
from workbench.scene.image import pixel_side
from workbench.scene.run import refused_in_stage

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


def grazed(scene: Scene) -> Message | None:
    """What will be worse for light that grazes a receiver, and what helps; None where none does."""
    for part in scene.single:
        slant = part.receiver.slant(part.optic)
        if slant > _GRAZES:
            return Message(
                "light grazes the far side of the {receiver}, at {slant:.0f} degrees from "
                "across it, where the image is less exact; turn the {receiver} towards the "
                "{optic}, or move its middle nearer to the axis",
                receiver=part.receiver.called,
                slant=slant,
                optic=part.optic.called,
            )
    return None


def reversed_on_lit_side(scene: Scene, target: Array) -> Message | None:
    """Which picture reads the wrong way round from where its light comes; None where none does.

    A scene that says from where its pictures are viewed needs no remark, and neither do those that
    are their own mirror images.
    """
    for part, light, _ in scene.wanted(target):
        unsaid = part.target.viewed_from is None and pixel_side(part) == "back"
        if unsaid and np.abs(light - light[:, ::-1]).sum() > _SYMMETRIC * light.sum():
            return Message(
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
            Message(
                "none of its light goes to the {optic}; turn or move it", optic=part.optic.called
            ),
        )


def _check_fixed(part: Scene, start: Mapping[str, Array]) -> None:
    """Refuse a fixed face without control heights."""
    for number, element in enumerate(part.elements):
        for placed, face in element.fixed_faces:
            if face.content is None and placed.name not in start:
                raise Refused(
                    f"elements[{number}].{placed.path}.heights",
                    Message("the control heights of the fixed face are missing; a file (.npy)"),
                )


def _check_net(part: Scene, finished: Scene) -> None:
    """Refuse another net than that of the finished lens, which the locks are about."""
    if nets_of(part) != nets_of(finished):
        raise Refused(
            f"{part.face_path()}.control_points",
            Message(
                "{net} are not the control points of the finished {optic} that are locked; leave "
                "the stage's net out or unlock them",
                net=list(part.optic.net_shape),
                optic=part.optic.called,
            ),
        )


# Errors from here on are high, and a net of so many times the control points along an axis is much
# finer. With 64 × 64 in place of 480 × 480 a flame is 19 % off and not 1.6 %, a ball 3.3 % and not
# 0.4 %.
_HIGH, _FINER = 0.05, 2.0


@dataclass(frozen=True)
class CoarseNet:
    """A net that keeps a lens from its target."""

    error: float  # relative L2 error that is left
    # Control points of the lens, and as many as the program would choose.
    shape: tuple[int, int]
    finer: tuple[int, int]

    @property
    def sentence(self) -> Message:
        """What is left and why, and what helps."""
        return Message(
            "The image stays {error:.0f} % off: {n_u} × {n_v} control points are too few for the "
            "detail of this target. {finer_u} × {finer_v}, the automatic choice, can show it.",
            error=100 * self.error,
            n_u=self.shape[0],
            n_v=self.shape[1],
            finer_u=self.finer[0],
            finer_v=self.finer[1],
        )


def coarse_net(scene: Scene, target: Array, result: Result) -> CoarseNet | None:
    """The net of a lens, if it is why a run has converged with a high error.

    None where something else may be the reason: a run that was cut off, limits of the heights, lost
    or grazing light, a light source of some size, or bends that are to be gentle.

    `target` (n_y, n_x): the wanted image in any scale; `result`: of a run for them.
    """
    state = result.state
    error = relative_error(state, target)
    if error < _HIGH or not has_converged(result.ended):
        return None
    bends = scene.run.smoothness, scene.run.min_radius, scene.run.min_tool_radius
    limited = state.shortfall or state.account.advice(scene) or grazed(scene) or any(bends)
    if limited or any(any(Blur.of(image).widths) for image in scene.single):
        return None
    shape = scene.optic.net_shape
    optic = scene.optic.shaped(control_points=AutoNet())
    finer = definite(scene.with_optic(optic), target).optic.net_shape
    if max(many / few for many, few in zip(finer, shape, strict=True)) < _FINER:
        return None
    return CoarseNet(error, shape, finer)
