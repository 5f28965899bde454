"""The arrays of a design in a session: of the open one, and of each run kept beside it.

A kept run's entries are named like those of the open design, in a folder of their own.
"""

import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from workbench.arrays import Array
from workbench.design.lens_state import FurtherLight, LensState, frozen
from workbench.design.picture import LARGEST_PICTURE
from workbench.design.snapshot import Result
from workbench.errors import Refused, shown
from workbench.files.entries import Entries
from workbench.files.figures import AccountFigures, Figures
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import freeform_nets
from workbench.said import Said
from workbench.scene import DrawnTarget, Scene

_TARGET = "target.npy"
# Of further images, by their numbers from 1.
_FURTHER_TARGET, _FURTHER_IRRADIANCE = "further_target_{}.npy", "further_irradiance_{}.npy"
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

_ENDING = re.compile(r"\.[a-z0-9]{1,8}")

_TINY, _HUGE = 1e-100, 1e100  # largest values that are left as they are


def entries_of(folder: str, scene: Scene, target: Array, result: Result | None) -> dict[str, Array]:
    """The arrays of a design, by the names of their entries."""
    _, *others = scene.images(target)
    arrays = {folder + _TARGET: target}
    arrays |= {
        folder + _FURTHER_TARGET.format(number): image.target
        for number, image in enumerate(others, start=1)
    }
    if result is not None:
        arrays |= {folder + _CONTROL_POINTS[face]: z for face, z in result.state.heights.items()}
        arrays[folder + _IRRADIANCE] = result.state.irradiance
        arrays |= {
            folder + _FURTHER_IRRADIANCE.format(number): light.irradiance
            for number, light in enumerate(result.state.further, start=1)
        }
        arrays[folder + _LOSS] = result.losses
        if result.seconds_at is not None:
            arrays[folder + _SECONDS] = result.seconds_at
    return arrays


def names_of(entries: Entries, folder: str, scene: Scene, figures: Figures | None) -> set[str]:
    """Names of the entries of a design that has, or has not, a result."""
    numbers = range(1, len(scene.further_images) + 1)
    names = [_TARGET, *(_FURTHER_TARGET.format(number) for number in numbers)]
    if figures is not None:
        names += [_FURTHER_IRRADIANCE.format(number) for number in numbers]
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
    return _read_target(entries, folder + _TARGET, scene)


def with_read_targets(entries: Entries, folder: str, scene: Scene) -> Scene:
    """The scene of a design with the targets of its further images; see `read_target`."""
    if not scene.further_images:
        return scene
    pictures = picture_entries(scene, folder)
    images = []
    for number, (alone, image) in enumerate(
        zip(scene.single[1:], scene.further_images, strict=True), start=1
    ):
        light = _read_target(entries, folder + _FURTHER_TARGET.format(number), alone)
        images.append(image.drawn_as(DrawnTarget(light, _read_picture(entries, pictures[number]))))
    return scene.model_copy(update={"further_images": tuple(images)})


def picture_entries(scene: Scene, folder: str = "") -> list[str | None]:
    """Names of the entries of the targets' image files, None for a built-in shape.

    Any program can open them there.
    """
    stems = ["target", *(f"further_target_{k}" for k in range(1, len(scene.further_images) + 1))]
    return [
        None if alone.image is None else f"{folder}{stem}_image{_ending(alone.image)}"
        for stem, alone in zip(stems, scene.single, strict=True)
    ]


def names_of_pictures(entries: Entries, scene: Scene) -> set[str]:
    """Those entries of image files that are there."""
    return {name for name in picture_entries(scene) if name is not None and name in entries}


def read_picture(entries: Entries, scene: Scene) -> bytes | None:
    """The image file of the first target, where it is kept."""
    return _read_picture(entries, picture_entries(scene)[0])


def _read_picture(entries: Entries, name: str | None) -> bytes | None:
    if name is None or name not in entries:
        return None
    return entries.content(name, LARGEST_PICTURE)


def _ending(image: str) -> str:
    ending = Path(image).suffix.lower()
    return ending if _ENDING.fullmatch(ending) else ""


def _read_target(entries: Entries, name: str, scene: Scene) -> Array:
    n_x, n_y = scene.receiver.pixels
    target = entries.array(name, (n_y, n_x))
    if target.min() < 0 or not target.any():
        raise Refused(
            entries.where(name), Said("is dark or has negative values; some light is needed")
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
            Said(
                "{height:.5g} is no height of this {optic}; at most {farthest:g} "
                "{unit} from {front} are possible",
                height=heights[i, j],
                optic=optic.called,
                farthest=farthest,
                unit=scene.unit,
                front=optic.front_called,
            ),
        )
    return heights


def _read_irradiance(entries: Entries, name: str, scene: Scene, ledger: AccountFigures) -> Array:
    n_x, n_y = scene.receiver.pixels
    irradiance = entries.array(name, (n_y, n_x))
    most = ledger.emitted / np.broadcast_to(scene.receiver.pixel_measure, irradiance.shape)
    brightness = np.abs(irradiance) / most
    if brightness.max() > _BRIGHTEST:
        row, column = np.unravel_index(brightness.argmax(), irradiance.shape)
        raise Refused(
            f"{entries.where(name)}[{row}, {column}]",
            Said(
                "{value:.5g} is more than all light of the source in this pixel; "
                "{most:.5g} would be all of it",
                value=irradiance[row, column],
                most=most[row, column],
            ),
        )
    return irradiance


def _read_further(
    entries: Entries, folder: str, scene: Scene, figures: Figures
) -> tuple[FurtherLight, ...]:
    """The light of a lens at the receivers of further images."""
    given, _, *others = figures.further_images or (), *scene.single
    if len(given) != len(others):
        raise Refused(
            entries.where("session.json"),
            Said(
                "has figures of {given} further images; the scene has {others}",
                given=len(given),
                others=len(others),
            ),
        )
    return tuple(
        FurtherLight(
            _read_irradiance(
                entries, folder + _FURTHER_IRRADIANCE.format(number), alone, each.ledger
            ),
            each.loss,
            each.ledger.to_account(),
        )
        for number, (alone, each) in enumerate(zip(others, given, strict=True), start=1)
    )


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
            Said(
                "has {count} losses; stages cannot have begun after {starts}",
                count=figures.iterations,
                starts=shown(starts),
            ),
        )
    state = LensState(
        heights=read_heights(entries, scene, _CONTROL_POINTS, folder),
        irradiance=_read_irradiance(entries, folder + _IRRADIANCE, scene, figures.ledger),
        loss=figures.loss,
        account=figures.ledger.to_account(),
        shortfall=None if figures.shortfall is None else figures.shortfall.to_shortfall(),
        further=_read_further(entries, folder, scene, figures),
    )
    return Result(
        state,
        losses=entries.array(folder + _LOSS, count),
        seconds=figures.seconds,
        stage_starts=starts,
        stages_left=figures.stages_left or 0,
        seconds_at=entries.array(seconds, count) if seconds in entries else None,
        ended=figures.to_ended(),
    )
