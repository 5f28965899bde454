"""The example scenes, ready to be measured."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

import resources
from workbench.design.limits import HeightLimits
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene
from workbench.targets import load_target

Array = npt.NDArray[np.float64]
Notify = Callable[[str, str], None]
"""Called now and then with what is measured, and how far that is."""


@dataclass(frozen=True, eq=False)
class Example:
    """A scene and its target.

    Attributes
    ----------
    name, group : str
        As in `resources.EXAMPLES`.
    scene : Scene
        The design task.
    target : ndarray, shape (n_y, n_x)
        The target image.
    """

    name: str
    group: str
    scene: Scene
    target: Array

    @classmethod
    def of(cls, name: str, **changes: Any) -> "Example":
        """Read a shipped example.

        Parameters
        ----------
        name : str
            As in `resources.EXAMPLES`.
        **changes
            Parts of the scene file to be changed: a dictionary is merged into its part, anything
            else takes its place. A source of another kind and another method replace theirs.
        """
        shipped = next(each for each in resources.EXAMPLES if each.name == name)
        data = Scene.from_json(shipped.file.read_bytes()).to_data()
        for part, change in changes.items():
            data[part] = _merged(data[part], change)
        scene = Scene.from_data(data)
        return cls(name, shipped.group, scene, load_target(scene, shipped.file.parent))


def wavy(scene: Scene) -> Array:
    """Control heights of a lens that bends light everywhere, some ten per cent of the screen far.

    Returns
    -------
    ndarray, shape (n_u, n_v)
        Scene units, within the scene's height range.
    """
    x, y = ControlNet.of(scene.lens).positions
    r_x, r_y = scene.lens.half_width
    rise = np.cos(np.pi * x / r_x)[:, None] * np.cos(1.5 * np.pi * y / r_y + 0.5)[None, :]
    distance = scene.screen.z - scene.lens.base.height
    # A slope s bends light by (n − 1) s, which moves it on the screen by that times the distance.
    slope = 0.1 * min(scene.screen.half_width) / distance / (scene.lens.index - 1)
    height = slope * min(r_x, r_y) / (1.5 * np.pi)
    limits = HeightLimits.of(scene.lens, ControlNet.of(scene.lens))
    height = min(height, 0.4 * float((limits.upper - limits.lower).min()))
    return np.asarray(limits.undesigned + height * rise)


def _merged(part: Any, change: Any) -> Any:
    if not (isinstance(part, dict) and isinstance(change, dict)):
        return change
    for told_by in ("kind", "method"):
        if change.get(told_by, part.get(told_by)) != part.get(told_by):
            return change
    return part | change
