"""What a person should know of a task before its run, and of its net after the run."""

from dataclasses import dataclass

import numpy as np

from workbench.arrays import Array
from workbench.design.loss import relative_error
from workbench.design.net import definite
from workbench.design.snapshot import Result, has_converged
from workbench.design.transport.entrance import out_of_reach
from workbench.extended.blur import Blur
from workbench.messages import Message
from workbench.scene import AutoNet, Scene
from workbench.scene.image import pixel_side

# Degrees from across the receiver beyond which light grazes it. A photograph on a wall that is met
# at 55 to 78 degrees is 1.5 to 1.9 % off, one at 86 degrees 4.4 %.
_GRAZES = 80.0
# Part of its light by which a picture may differ from its mirror image for being drawn in pixels.
_SYMMETRIC = 0.02


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
        unstated = part.target.viewed_from is None and pixel_side(part) == "back"
        if unstated and np.abs(light - light[:, ::-1]).sum() > _SYMMETRIC * light.sum():
            return Message(
                "the picture is mirror-inverted for viewers on the side of the light, and reads "
                'right from behind the {receiver}; target.viewed_from "front" turns it around',
                receiver=part.receiver.called,
            )
    return None


# Errors from here on are high, and a net of so many times the control points along an axis is much
# finer. With 64 × 64 in place of 480 × 480 a flame is 19 % off and not 1.6 %, a ball 3.3 % and not
# 0.4 %.
HIGH, _FINER = 0.05, 2.0


@dataclass(frozen=True)
class CoarseNet:
    """A net that keeps a lens from its target."""

    error: float  # relative L2 error that remains
    # Control points of the lens, and as many as the program would choose.
    shape: tuple[int, int]
    finer: tuple[int, int]

    @property
    def sentence(self) -> Message:
        """The error that remains, why, and what helps."""
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
    if error < HIGH or not has_converged(result.ended):
        return None
    limited = state.shortfall or state.account.advice(scene) or grazed(scene) or scene.bends
    if (
        limited
        or out_of_reach(scene, target)
        or any(any(Blur.of(image).widths) for image in scene.single)
    ):
        return None
    shape = scene.optic.net_shape
    optic = scene.optic.shaped(control_points=AutoNet())
    finer = definite(scene.with_optic(optic), target).optic.net_shape
    if max(many / few for many, few in zip(finer, shape, strict=True)) < _FINER:
        return None
    return CoarseNet(error, shape, finer)
