"""How a figure of the light changes with numbers of the scene, whose control heights stay."""

from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

import torch

from workbench.arrays import Array
from workbench.design.levels import FINE, cells_of
from workbench.errors import Refused
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import tensors_of
from workbench.optics.samples import Corners
from workbench.scene import Scene
from workbench.scene.paths import value_at, with_values

Figure = Callable[[Array, Account], float]

# Of a number, or of the half-width of the lens where the number is 0.
_STEP = 1e-3


class Sensitivity(NamedTuple):
    """Derivative of a figure of the light by a number of the scene.

    Attributes
    ----------
    value : float
        Change of the figure per unit of the number.
    off : float
        How far the value may be off: the change from a step of twice the size.
    """

    value: float
    off: float


def sensitivities(
    scene: Scene, heights: ControlHeights, figure: Figure, paths: Iterable[str]
) -> Mapping[str, Sensitivity]:
    """Derivatives by central differences of the image of beams, which has no noise.

    Parameters
    ----------
    scene : Scene
        With one image.
    heights : ControlHeights
        Control heights of each freeform face; they move with their element.
    figure : callable
        A number of the irradiance (n_y, n_x) and of the account.
    paths : iterable of str
        Numbers of the scene.
    """
    scene.check_one_image("a sensitivity")
    cells = cells_of(FINE, scene)
    return {path: _by(scene, heights, figure, path, cells) for path in paths}


def _by(
    scene: Scene, heights: ControlHeights, figure: Figure, path: str, cells: Corners
) -> Sensitivity:
    number = value_at(scene, path)
    if isinstance(number, bool) or not isinstance(number, int | float):
        raise Refused(path, Message("no number; a number as in lens.thickness is needed"))
    step = _STEP * (abs(number) or max(scene.optic.half_width))

    def slope(step: float) -> float:
        ahead, behind = (
            _figure(with_values(scene, {path: number + way}), scene, heights, figure, cells)
            for way in (step, -step)
        )
        return (ahead - behind) / (2 * step)

    fine, coarse = slope(step), slope(2 * step)
    return Sensitivity((4 * fine - coarse) / 3, abs(fine - coarse))


def _figure(
    scene: Scene, before: Scene, heights: ControlHeights, figure: Figure, cells: Corners
) -> float:
    rise = scene.optic.position[2] - before.optic.position[2]
    moved = FaceArrays({face: each + rise for face, each in heights.items()})
    scene = scene.with_net(before.optic.known_shape)
    with torch.no_grad():
        light = BeamPlan(scene, cells, dtype=torch.float64).trace(tensors_of(moved, scene))
    irradiance = light.flux.cpu().numpy() / scene.receiver.pixel_measure
    return float(figure(irradiance, light.account))
