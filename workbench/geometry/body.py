"""Check that an element is a solid body clear of receiver and source.

A run only produces such bodies, but heights also come from files.
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.scene import AnyReceiver, Scene

# Relative distance of faces that touch: meshes and solids cannot separate them.
_CONTACT = 1e-9
# Least number of samples along each axis.
_SAMPLES = 512


def check_body(
    scene: Scene, heights: Mapping[str, Array], receivers: Sequence[AnyReceiver] = ()
) -> None:
    """Refuse a lens whose faces touch or cross, or an element that meets what is next to it.

    ``heights`` (n_u, n_v) by face are in scene units; ``receivers`` replace those of the scene.
    Raise Refused with the place and the height there.
    """
    for focused in scene.focused:
        _check_element(focused, heights, receivers)


def _check_element(
    scene: Scene, heights: Mapping[str, Array], receivers: Sequence[AnyReceiver]
) -> None:
    """Check the only designed element of a scene."""
    optic = scene.optic
    gap = _CONTACT * max(optic.half_width)
    front = optic.designed_front or ""
    face, entrance = heights[optic.designed_face], heights.get(front)
    low, high, below, above = _free_range(scene, receivers or scene.receivers)
    top = low if entrance is None else float(entrance.max())
    # A face lies in the convex hull of its control points: usually these decide.
    if top + gap < face.min() and face.max() < high - gap:
        return
    nets = freeform_nets(optic)
    u, v = (
        np.linspace(0, 1, (n - p) * math.ceil(_SAMPLES / (n - p)) + 1)
        for n, p in zip(
            nets[optic.designed_face].shape, nets[optic.designed_face].degree, strict=True
        )
    )
    x, y = ((2 * t - 1) * r for t, r in zip((u, v), optic.half_width, strict=True))
    height, lower = (
        np.full((len(u), len(v)), low) if each is None else nets[name].grid(u, v).evaluate(each)[0]
        for name, each in ((optic.designed_face, face), (front, entrance))
    )
    # Samples outside the outline take the value of the middle.
    middle = len(u) // 2, len(v) // 2
    inside = outline_of(optic).contains(x[:, None], y)
    height, lower = (np.where(inside, z, z[middle]) for z in (height, lower))
    for clearance, limit, end in (
        (height - lower, below, lower),
        (high - height, above, np.full_like(lower, high)),
    ):
        if clearance.min() <= gap:
            i, j = np.unravel_index(clearance.argmin(), clearance.shape)
            raise Refused(
                optic.called,
                Message(
                    "its {face} is at z = {z:.5g} {unit} at x = {x:.4g}, y = {y:.4g}, not {limit} "
                    "at z = {end:g}: that is no {body}",
                    face=Message(optic.face_called),
                    z=height[i, j],
                    unit=scene.unit,
                    x=x[i],
                    y=y[j],
                    limit=limit,
                    end=end[i, j],
                    body=Message(optic.body_called),
                ),
            )


def _free_range(
    scene: Scene, receivers: Sequence[AnyReceiver]
) -> tuple[float, float, Message, Message]:
    behind = [each.nearest_to(scene.optic) for each in scene.behind[:1]]
    first = scene.images[0]
    images = (first.model_copy(update={"receiver": receiver}) for receiver in receivers)
    scene = scene.with_images(images).alone
    optic = scene.optic
    ends = [receiver.nearest_to(optic) for receiver in scene.receivers] + behind
    if optic.onwards > 0:
        place = optic.entrance_range[0] - optic.entrance_offsets[0]
        above = Message("above {front}", front=optic.front_called)
        return place, min(ends), above, Message("before the screen")
    low = max(*ends, scene.source.nearest_z)
    return low, math.inf, Message("above the screen and the source"), Message("below all")
