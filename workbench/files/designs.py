"""The arrays of a design in a session: of the open one, and of each run kept beside it.

A kept run's entries are named like those of the open design, in a folder of their own.
"""

from collections.abc import Mapping

import numpy as np

from workbench.design.lens_state import LensState, frozen
from workbench.design.snapshot import Result
from workbench.errors import Refused, shown
from workbench.files.entries import Entries
from workbench.files.figures import Figures
from workbench.files.npy import Array
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

_TARGET = "target.npy"
# By the name of the face.
_CONTROL_POINTS = {
    "entrance": "entrance_points.npy",
    "exit": "control_points.npy",
    "mirror": "control_points.npy",
}
_IRRADIANCE = "irradiance.npy"
_LOSS = "loss.npy"
_SECONDS = "seconds.npy"  # sessions of earlier programs have none

# Heights of a damaged file may be anything. Those of a lens are a part of the way to the screen; an
# optic is still drawn, and its curvature found, with so many times as much.
_FARTHEST = 1000
# No pixel has more than all light; so many times as much leaves room for other units of flux.
_BRIGHTEST = 1000

_TINY, _HUGE = 1e-100, 1e100  # largest values that are left as they are


def entries_of(folder: str, target: Array, result: Result | None) -> dict[str, Array]:
    """The arrays of a design, by the names of their entries."""
    arrays = {folder + _TARGET: target}
    if result is not None:
        arrays |= {folder + _CONTROL_POINTS[face]: z for face, z in result.state.heights.items()}
        arrays[folder + _IRRADIANCE] = result.state.irradiance
        arrays[folder + _LOSS] = result.losses
        if result.seconds_at is not None:
            arrays[folder + _SECONDS] = result.seconds_at
    return arrays


def names_of(entries: Entries, folder: str, scene: Scene, figures: Figures | None) -> set[str]:
    """Names of the entries of a design that has, or has not, a result."""
    names = [_TARGET]
    if figures is not None:
        names += [_CONTROL_POINTS[face] for face in freeform_nets(scene.optic)]
        names += [_IRRADIANCE, _LOSS]
        if folder + _SECONDS in entries:
            names.append(_SECONDS)
    return {folder + name for name in names}


def read_target(entries: Entries, folder: str, scene: Scene) -> Array:
    """The target image of a design.

    One whose sum of squares would be beyond float64, or 0, is scaled to a largest value of 1: only
    ratios count.

    Raises
    ------
    Refused
        If it is not as the scene implies, or it is dark.
    """
    n_x, n_y = scene.receiver.pixels
    target = entries.array(folder + _TARGET, (n_y, n_x))
    if target.min() < 0 or not target.any():
        raise Refused(
            entries.where(folder + _TARGET), "is dark or has negative values; some light is needed"
        )
    peak = float(target.max())
    return target if _TINY < peak < _HUGE else frozen(target / peak)


def read_heights(
    entries: Entries, scene: Scene, names: Mapping[str, str], folder: str = ""
) -> ControlHeights:
    """Control heights of a lens; one that is no body can be looked at, and mended.

    Parameters
    ----------
    entries : Entries
        Of the session.
    scene : Scene
        The task of the lens.
    names : mapping of str to str
        Names of the entries in the folder, by the names of the faces.
    folder : str
        What the names of the entries begin with.

    Raises
    ------
    Refused
        If they are not as the scene implies, or so far away that the file must be damaged.
    """
    nets = freeform_nets(scene.optic)
    return FaceArrays(
        {face: _read_face(entries, folder + names[face], scene, nets[face].shape) for face in nets}
    )


def _read_face(entries: Entries, name: str, scene: Scene, shape: tuple[int, int]) -> Array:
    heights = entries.array(name, shape)
    optic = scene.optic
    entrance = optic.front_z
    farthest = _FARTHEST * abs(scene.receiver.nearest_to(optic) - entrance)
    away = np.abs(heights - entrance)
    if away.max() > farthest:
        i, j = np.unravel_index(away.argmax(), away.shape)
        raise Refused(
            f"{entries.where(name)}[{i}, {j}]",
            f"{heights[i, j]:.5g} is no height of this {optic.called}; at most {farthest:g} "
            f"{scene.unit} from {optic.front_called} are possible",
        )
    return heights


def _read_irradiance(entries: Entries, name: str, scene: Scene, figures: Figures) -> Array:
    n_x, n_y = scene.receiver.pixels
    irradiance = entries.array(name, (n_y, n_x))
    most = figures.ledger.emitted / np.broadcast_to(scene.receiver.pixel_measure, irradiance.shape)
    brightness = np.abs(irradiance) / most
    if brightness.max() > _BRIGHTEST:
        row, column = np.unravel_index(brightness.argmax(), irradiance.shape)
        raise Refused(
            f"{entries.where(name)}[{row}, {column}]",
            f"{irradiance[row, column]:.5g} is more than all light of the source in this pixel; "
            f"{most[row, column]:.5g} would be all of it",
        )
    return irradiance


def read_result(entries: Entries, folder: str, scene: Scene, figures: Figures) -> Result:
    """The lens of a design.

    Raises
    ------
    Refused
        If an array is not as scene and figures imply.
    """
    seconds, count = folder + _SECONDS, (figures.iterations,)
    starts = figures.stage_starts or ()
    if list(starts) != sorted(starts) or not all(0 <= at <= figures.iterations for at in starts):
        raise Refused(
            entries.where(folder + _LOSS),
            f"has {figures.iterations} losses; stages cannot have begun after {shown(starts)}",
        )
    state = LensState(
        heights=read_heights(entries, scene, _CONTROL_POINTS, folder),
        irradiance=_read_irradiance(entries, folder + _IRRADIANCE, scene, figures),
        loss=figures.loss,
        account=figures.ledger.to_account(),
        shortfall=None if figures.shortfall is None else figures.shortfall.to_shortfall(),
    )
    return Result(
        state,
        losses=entries.array(folder + _LOSS, count),
        seconds=figures.seconds,
        stage_starts=starts,
        stages_left=figures.stages_left or 0,
        seconds_at=entries.array(seconds, count) if seconds in entries else None,
        ended=figures.ended or "",
    )
