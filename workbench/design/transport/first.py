"""The first lens of a task: by one face, or by two where these are better."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.start import first_error, transport_start
from workbench.design.transport.two_faces import split_start
from workbench.geometry.surface import freeform_nets
from workbench.scene import FlatEntrance, Scene

Array = npt.NDArray[np.float64]

_BOTH, _ALONE = "both faces", "the exit face alone"
# Light that both faces bend meets them less steeply, and a descent improves both: worth so much.
_HANDICAP = {_ALONE: 1.8}


class First(NamedTuple):
    """A first lens.

    Attributes
    ----------
    heights : dict of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units; beyond their limits where
        these are too narrow for the task.
    notes : tuple of str
        How it was chosen, in words, for a run's log.
    """

    heights: dict[str, Array]
    notes: tuple[str, ...] = ()


def first_of(scene: Scene, target: Array) -> First | None:
    """The first lens by transport; None if no light leaves any.

    A lens of two faces begins with each bending the light by half, or with a flat entrance face
    where that makes a better image.

    Parameters
    ----------
    scene : Scene
        The design task.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.
    """
    if "entrance" not in freeform_nets(scene.optic):
        heights = transport_start(scene, target)
        return None if heights is None else First({scene.optic.face: heights})
    found = {
        name: (first_error(scene, target, heights), heights)
        for name, heights in (
            (_BOTH, split_start(scene, target)),
            (_ALONE, _flat_start(scene, target)),
        )
        if heights is not None
    }
    if not found:
        return None
    errors = {name: error for name, (error, _) in found.items()}
    best = min(errors, key=lambda name: errors[name] * _HANDICAP.get(name, 1.0))
    said = " and ".join(f"{100 * error:.2g} % by {name}" for name, error in errors.items())
    return First(found[best][1], (f"first lens: {said}; it begins with {best}",))


def _flat_start(scene: Scene, target: Array) -> dict[str, Array] | None:
    """A first lens with a flat entrance face, where it has room to become another."""
    limits = HeightLimits.of_faces(bounded(scene))["entrance"]
    z = float(limits.lower.min() + limits.upper.max()) / 2
    # The exit face has as much room as beside another entrance face.
    clear = scene.optic.floor - z
    flat = {"entrance": FlatEntrance(), "entrance_z": z, "min_thickness": clear}
    lens = scene.optic.model_copy(update=flat)
    heights = transport_start(scene.with_optic(lens), target)
    return None if heights is None else {"entrance": np.full_like(limits.lower, z), "exit": heights}
