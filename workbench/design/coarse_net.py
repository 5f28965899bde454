"""Whether a converged lens is held back by a net too coarse for its target."""

from dataclasses import dataclass

from workbench.arrays import Array
from workbench.design.endings import has_converged
from workbench.design.loss import relative_error
from workbench.design.needs import grazed
from workbench.design.net import definite
from workbench.design.snapshot import Result
from workbench.extended.blur import Blur
from workbench.said import Said
from workbench.scene import AutoNet, Scene

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
    def sentence(self) -> Said:
        """What is left and why, and what helps."""
        return Said(
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
