"""Whether a lens is a body: glass everywhere between both faces, and clear of the screen.

A run never leaves anything else, but heights also come from files.
"""

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from workbench.errors import Refused
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
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
    screen = scene.receiver.nearest_z if screen_z is None else screen_z
    gap, lens = _TOUCH * max(scene.lens.half_width), scene.lens
    exit_face, entrance = heights["exit"], heights.get("entrance")
    top = lens.entrance_z if entrance is None else float(entrance.max())
    # A face lies in the convex hull of its control points: nearly always they alone tell.
    if top + gap < exit_face.min() and exit_face.max() < screen - gap:
        return
    nets = freeform_nets(lens)
    u, v = (
        np.linspace(0, 1, (n - p) * math.ceil(_PLACES / (n - p)) + 1)
        for n, p in zip(nets["exit"].shape, nets["exit"].degree, strict=True)
    )
    x, y = ((2 * t - 1) * r for t, r in zip((u, v), lens.half_width, strict=True))
    height, below = (
        np.full((len(u), len(v)), lens.entrance_z)
        if each is None
        else nets[face].grid(u, v).evaluate(each)[0]
        for face, each in (("exit", exit_face), ("entrance", entrance))
    )
    # Places beside the lens count as its middle.
    middle = len(u) // 2, len(v) // 2
    inside = outline_of(lens).contains(x[:, None], y)
    height, below = (np.where(inside, z, z[middle]) for z in (height, below))
    for room, limit in (
        (height - below, "above the entrance face at z = {:g}"),
        (screen - height, f"before the screen at z = {screen:g}"),
    ):
        if room.min() <= gap:
            i, j = np.unravel_index(room.argmin(), room.shape)
            raise Refused(
                "lens",
                f"its exit face is at z = {height[i, j]:.5g} {scene.unit} at x = {x[i]:.4g}, "
                f"y = {y[j]:.4g}, not {limit.format(below[i, j])}: that is no body of glass",
            )
