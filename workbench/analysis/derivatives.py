"""Derivatives of the image by a control height, and of figures of the light by scene numbers.

One forward-mode pass (a Jacobian-vector product) gives all pixels at once; reverse mode would need
one pass per pixel. De Koning et al. (2023), section 3.1.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from threading import Lock
from typing import NamedTuple

import numpy as np
import torch
from torch.autograd import forward_ad

from workbench.arrays import Array
from workbench.design.levels import FINE, cells_of
from workbench.errors import Refused
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan, tensors_of
from workbench.optics.samples import Corners
from workbench.scene import Scene
from workbench.scene.paths import value_at, with_values

# Torch has one level of dual numbers for all threads.
_DUAL_NUMBERS = Lock()


@dataclass(frozen=True, eq=False)
class DerivativeMap:
    """Derivative of the image with respect to one control height."""

    index: tuple[int, int]  # of the control point, along x and along y
    position: tuple[float, float]  # its x and y, scene units
    map: Array  # (n_y, n_x), flux per area per scene unit of height, row 0 at +y
    sum: float  # change of the flux on the receiver; 0 where no light crosses the image's border
    flux: float  # on the receiver


def irradiance_derivative(
    scene: Scene,
    heights: Mapping[str, Array],
    index: tuple[int, int],
    dtype: torch.dtype = torch.float64,
    face: str = "",
) -> DerivativeMap:
    """Return the derivative of the image with respect to one control height.

    ``face`` is by default the designed face. Raises `Refused` if there is no such control point, or
    the filter is not smooth.

    Examples
    --------
    A control point moves light, so the sum is 0:

    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> scene = open_design(path("examples", "derivative-degree3-filter3.json")).scene
    >>> plate = {"lens.back": np.full(scene.optic.net_shape, scene.optic.base.height)}
    >>> found = irradiance_derivative(scene, plate, (4, 4))
    >>> abs(found.sum) < 1e-12 < found.map.max().item()
    True
    """
    face = face or scene.optic.designed_face
    net = nets_of(scene)[face]
    _check(scene, net, index)
    plan = Plan(scene, dtype=dtype)
    tensors = tensors_of(heights, scene)
    rise = torch.zeros_like(tensors[face])
    rise[index] = 1.0
    # Not `torch.func.jvp`: its wrapped tensors have no values for the search for intersections.
    with _DUAL_NUMBERS, torch.no_grad(), forward_ad.dual_level():
        moved = forward_ad.make_dual(tensors[face], rise)  # type: ignore[no-untyped-call]
        dual = plan.flux({**tensors, face: moved})
        flux, change = forward_ad.unpack_dual(dual)  # type: ignore[no-untyped-call]
    assert change is not None  # every image depends on every height
    change = change.to(torch.float64)
    x, y = net.positions
    return DerivativeMap(
        index=index,
        position=(float(x[index[0]]), float(y[index[1]])),
        map=np.asarray(change.cpu().numpy() / scene.receiver.pixel_measure),
        sum=change.sum().item(),
        flux=flux.sum(dtype=torch.float64).item(),
    )


def _check(scene: Scene, net: ControlNet, index: tuple[int, int]) -> None:
    scene.check_one_image("derivative maps")
    scene.check_no_diffuser("derivative maps")
    for axis, (i, count) in enumerate(zip(index, net.shape, strict=True)):
        if not 0 <= i < count:
            raise Refused(
                f"index[{axis}]",
                Message("{i} is no control point; 0 to {last}", i=i, last=count - 1),
            )
    if not scene.filter.smooth:
        raise Refused(
            "filter.kind",
            Message(
                "'{kind}' counts rays by pixel, which has no derivative; 'gaussian'",
                kind=scene.filter.kind,
            ),
        )
    for axis, size in enumerate(scene.filter.size):
        if size == 1:
            raise Refused(
                f"filter.size[{axis}]",
                Message("1 counts rays by pixel, which has no derivative; 3 or more"),
            )


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
