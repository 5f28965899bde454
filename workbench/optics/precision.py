"""Which float type a scene needs.

Rounding moves the light of a trace, and what matters is by how much of a pixel. A thousand traces
of scenes with extremes in every field differed in float32 and float64 by this much, in the image
(L1 over all light) and in the gradient of the paper's loss (relative L2), for `shift_of` in pixels:

==============  ======  =============  ==============  ================  ===============
shift           traces  image, median  image, largest  gradient, median  gradient, most
==============  ======  =============  ==============  ================  ===============
below 1e-4      726     1e-7           3e-5 (2e-3)     1e-6              5e-2 (9e-1)
1e-4 to 1e-3    232     1e-6           5e-4            5e-6              6e-2
1e-3 to 1e-2    34      6e-6           6e-4 (1e-2)     3e-6              4e-4
1e-2 to 1e-1    11      3e-5           1e-4            4e-2              5e-1
above 1e-1      2       1              2               9                 9
==============  ======  =============  ==============  ================  ===============

In brackets: with faces of degree 1, where a ray may fall on the other side of a crease. Gradients
are counted where no ray is near the critical angle, at which they have no bounds, and where a
change of the heights by all of their range changes the loss by more than 1e-5 of itself.

Of a source right before a lens, places on the entrance face are small differences of those in the
glass: with the thickness t and the distance d, the account of a rough lens was off by a tenth of
ε t / d and more, with ε the rounding of float32: by 7e-6 at d = 2e-3 t, by 7e-4 at 2e-5 t.
"""

import torch

from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Element, Scene

# In pixels: the image is good to 1e-3 of its light up to here, the gradient to a few per cent.
_TOLERABLE = 0.01
# Of ε t / d: the light of samples is good to 1e-4 up to here.
_NEAR = 1e-3
# Where the lens does not say how far its heights go: that part of its half-width, as in most lenses
# that bend their light over the whole screen.
_RISE = 0.3


def precision_of(scene: Scene, net: ControlNet | None = None) -> torch.dtype:
    """The float type in which a scene is traced: float32 unless that moves light too far.

    `scene`: what is traced; `net`: control net of the heights to come; the scene's own by default.
    """
    scene = scene.alone
    fine = shift_of(scene, net) > _TOLERABLE or nearly_touches(scene)
    return torch.float64 if fine else torch.float32


def nearly_touches(scene: Scene) -> bool:
    """Whether a source is so near before the optic that float32 does not know its light there."""
    optic = scene.optic
    _, high = _extent(optic)
    distance = optic.front_z - scene.source.nearest_z
    return torch.finfo(torch.float32).eps * (high - optic.front_z) > _NEAR * distance


def shift_of(scene: Scene, net: ControlNet | None = None) -> float:
    """About how far float32 moves hits, in pixels.

    Heights are rounded to a part ε of the largest, so slopes to that over the distance of control
    points; light is bent by n − 1 times the slope. Directions of rays from points are rounded, too,
    and so is the way to a screen, which moves light along one that leans.
    """
    optic, receiver = scene.optic, scene.receiver
    net = net or ControlNet.of(optic)
    low, high = _extent(optic)
    level, steepest = optic.base.height, 0.0
    nets = [each for face, each in freeform_nets(optic).items() if face != optic.designed_face]
    if not scene.source.along_axis or nets:
        steepest = optic.steepest
    if not scene.source.along_axis and not nets:
        level = min(level, optic.front_z)  # rays that search for the face count from there
    largest = max(abs(low - level), abs(high - level))
    density = max(
        count / r
        for each in (net, *nets)
        for count, r in zip(each.shape, each.half_width, strict=True)
    )
    deflection = optic.deflection * largest * density
    # From the lowest point of the lens, the farthest from the receiver.
    pixels = max(
        (far * (deflection + steepest) + along) * m / (2 * r)
        for far, along, m, r in zip(
            receiver.per_radian(low),
            receiver.lean(low),
            receiver.pixels,
            receiver.half_extent,
            strict=True,
        )
    )
    return torch.finfo(torch.float32).eps * pixels


def _extent(optic: Element) -> tuple[float, float]:
    """The lowest and the highest z of its face, or about that."""
    rise = _RISE * max(optic.half_width)
    low, high = optic.base.extent(optic.half_width)
    below, above = optic.height_range or (-rise, rise)
    return low + below, high + above
