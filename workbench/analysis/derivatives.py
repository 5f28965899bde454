"""Derivative of the whole irradiance image with respect to one control height.

One forward-mode pass (a Jacobian-vector product) gives all pixels at once; reverse mode would need
one pass per pixel. De Koning et al. (2023), section 3.1.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from threading import Lock

import numpy as np
import torch
from torch.autograd import forward_ad

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.optics.plan import Plan, tensors_of
from workbench.scene import Scene

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
