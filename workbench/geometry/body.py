"""Whether a lens is a body: glass everywhere between both faces, and clear of the screen.

A run never leaves anything else, but heights also come from files.
"""

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from workbench.errors import Refused
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

Array = npt.NDArray[np.float64]

# Faces that are so near, over the half-width, touch: meshes and solids cannot tell them apart.
_TOUCH = 1e-9
# Least number of places along each axis that are looked at.
_PLACES = 512


def check_body(scene: Scene, heights: Mapping[str, Array], screen_z: float | None = None) -> None:
    """Refuse a lens whose faces touch or cross, or that meets the screen.

    Parameters
    ----------
    scene : Scene
        The design task.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.
    screen_z : float, optional
        Where the screen comes closest to the lens, in place of the scene's.

    Raises
    ------
    Refused
        With the place and the height there.
    """
    entrance = scene.lens.entrance_z
    screen = scene.receiver.nearest_z if screen_z is None else screen_z
    gap, outline = _TOUCH * max(scene.lens.half_width), outline_of(scene.lens)
    exit_face = heights["exit"]
    # The face lies in the convex hull of its control points: nearly always they alone tell.
    if entrance + gap < exit_face.min() and exit_face.max() < screen - gap:
        return
    net = ControlNet.of(scene.lens)
    u, v = (
        np.linspace(0, 1, (n - p) * math.ceil(_PLACES / (n - p)) + 1)
        for n, p in zip(net.shape, net.degree, strict=True)
    )
    x, y = ((2 * t - 1) * r for t, r in zip((u, v), net.half_width, strict=True))
    height, _, _ = net.grid(u, v).evaluate(exit_face)
    # Places beside the lens count as high as its middle.
    middle = height[len(u) // 2, len(v) // 2]
    height = np.where(outline.contains(x[:, None], y), height, middle)
    for worst, room, limit in (
        (height.argmin(), height.min() - entrance, f"above the entrance face at z = {entrance:g}"),
        (height.argmax(), screen - height.max(), f"before the screen at z = {screen:g}"),
    ):
        if room <= gap:
            i, j = np.unravel_index(worst, height.shape)
            raise Refused(
                "lens",
                f"its exit face is at z = {height[i, j]:.5g} {scene.unit} at x = {x[i]:.4g}, "
                f"y = {y[j]:.4g}, not {limit}: that is no body of glass",
            )
