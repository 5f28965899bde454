"""Arrays of a design in a session: of the open design, and of each kept run in its own folder."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.lens_state import FurtherLight, LensState, frozen
from workbench.design.snapshot import Result
from workbench.design.task import LARGEST_PICTURE
from workbench.errors import Refused, shown
from workbench.files.entries import Entries
from workbench.files.figures import Figures, Ledger
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.scene import DrawnTarget, PlacedFace, Scene

_LOSS = "loss.npy"
_SECONDS = "seconds.npy"  # missing in sessions of earlier programs

_FARTHEST = 1000  # largest height, in distances to the receiver; a damaged file may have more
_BRIGHTEST = 1000  # largest flux of a pixel, in parts of all light: units of flux may differ

_ENDING = re.compile(r"\.[a-z0-9]{1,8}")

_TINY, _HUGE = 1e-100, 1e100  # range of the largest value in which a target is not rescaled


class Names(NamedTuple):
    """Names of the entries of a design in a session of some version."""

    version: int  # up to 2 control heights are in scene coordinates, from 3 in those of the element

    def target(self, number: int) -> str:
        """Name of the target of an image."""
        if self.version >= 3:
            return f"images/{number}/target.npy"
        return f"further_target_{number}.npy" if number else "target.npy"

    def irradiance(self, number: int) -> str:
        """Name of the irradiance of an image."""
        if self.version >= 3:
            return f"images/{number}/irradiance.npy"
        return f"further_irradiance_{number}.npy" if number else "irradiance.npy"

    def picture(self, number: int) -> str:
        """Name of the image file of a target, without its ending."""
        if self.version >= 3:
            return f"images/{number}/target_image"
        return f"further_target_{number}_image" if number else "target_image"

    def face(self, placed: PlacedFace, what: str = "") -> str:
        """Name of the control heights of a face, of its "start" heights or "locked" mask."""
        if self.version >= 3:
            return f"faces/{placed.name}{what and '.'}{what}.npy"
        if placed.name.endswith(".front"):
            return f"entrance_{what or 'points'}.npy"
        return f"{what or 'control_points'}.npy"

    def lift(self, scene: Scene, face: str) -> float:
        """Return z of the scene for a height of 0 in an entry of a face."""
        return scene.element_of(face).position[2] if self.version >= 3 else 0.0


NEWEST = Names(3)
"""Names in sessions that are written."""


def face_entries(scene: Scene, heights: Mapping[str, Array], what: str = "") -> dict[str, Array]:
    """Control heights of faces by the names of their entries; see `Names.face`."""
    placed = {each.name: each for each in designed_faces(scene)}
    return {
        NEWEST.face(placed[face], what): z - NEWEST.lift(scene, face) for face, z in heights.items()
    }


def entries_of(folder: str, scene: Scene, target: Array, result: Result | None) -> dict[str, Array]:
    """The arrays of a design, by the names of their entries."""
    arrays = {
        folder + NEWEST.target(number): image.target
        for number, image in enumerate(scene.wanted(target))
    }
    if result is not None:
        state = result.state
        arrays |= {folder + name: z for name, z in face_entries(scene, state.heights).items()}
        lights = (state.irradiance, *(light.irradiance for light in state.further))
        arrays |= {folder + NEWEST.irradiance(k): light for k, light in enumerate(lights)}
        arrays[folder + _LOSS] = result.losses
        if result.seconds_at is not None:
            arrays[folder + _SECONDS] = result.seconds_at
    return arrays


def names_of(
    entries: Entries, names: Names, folder: str, scene: Scene, figures: Figures | None
) -> set[str]:
    """Names of all entries of a design, with those of the result if it has figures."""
    numbers = range(len(scene.images))
    found = [names.target(number) for number in numbers]
    if figures is not None:
        found += [names.irradiance(number) for number in numbers]
        found += [names.face(placed) for placed in designed_faces(scene)]
        found.append(_LOSS)
        if folder + _SECONDS in entries:
            found.append(_SECONDS)
    return {folder + name for name in found}


def designed_faces(scene: Scene) -> list[PlacedFace]:
    """The faces of a scene that have control heights."""
    return [
        placed
        for element in scene.elements
        for placed in element.placed_faces
        if placed.face.designed
    ]


def read_target(entries: Entries, names: Names, folder: str, scene: Scene) -> Array:
    """Read the target image; raise Refused if it does not fit the scene or is dark.

    A target with a sum of squares of 0 or beyond float64 is scaled to a largest value of 1.
    """
    return _read_target(entries, folder + names.target(0), scene)


def with_read_targets(entries: Entries, names: Names, folder: str, scene: Scene) -> Scene:
    """Return the scene with the targets of its further images; see `read_target`."""
    if len(scene.images) == 1:
        return scene
    pictures = picture_entries(scene, names, folder)
    images = [scene.images[0]]
    for number, (alone, image) in enumerate(
        zip(scene.single[1:], scene.images[1:], strict=True), start=1
    ):
        light = _read_target(entries, folder + names.target(number), alone)
        images.append(image.drawn_as(DrawnTarget(light, _read_picture(entries, pictures[number]))))
    return scene.with_images(images)


def picture_entries(scene: Scene, names: Names = NEWEST, folder: str = "") -> list[str | None]:
    """Names of the entries of the targets' image files, None for a built-in shape."""
    return [
        None
        if alone.image is None
        else f"{folder}{names.picture(number)}{kept_ending(alone.image)}"
        for number, alone in enumerate(scene.single)
    ]


def names_of_pictures(entries: Entries, names: Names, scene: Scene) -> set[str]:
    """Names of the existing entries of image files."""
    found = picture_entries(scene, names)
    return {name for name in found if name is not None and name in entries}


def read_picture(entries: Entries, names: Names, scene: Scene) -> bytes | None:
    """Read the image file of the first target, if the session has it."""
    return _read_picture(entries, picture_entries(scene, names)[0])


def _read_picture(entries: Entries, name: str | None) -> bytes | None:
    if name is None or name not in entries:
        return None
    return entries.content(name, LARGEST_PICTURE)


def kept_ending(file: str) -> str:
    """Return the ending that an entry takes from the name of its file; empty if unusual."""
    ending = Path(file).suffix.lower()
    return ending if _ENDING.fullmatch(ending) else ""


def _read_target(entries: Entries, name: str, scene: Scene) -> Array:
    n_x, n_y = scene.receiver.pixels
    target = entries.array(name, (n_y, n_x))
    if target.min() < 0 or not target.any():
        raise Refused(
            entries.where(name), Message("is dark or has negative values; some light is needed")
        )
    peak = float(target.max())
    return target if _TINY < peak < _HUGE else frozen(target / peak)


def read_heights(
    entries: Entries, names: Names, scene: Scene, folder: str = "", what: str = ""
) -> ControlHeights:
    """Read the control heights of a lens, which may be no solid body.

    Raises `Refused` if they do not fit the scene or are so large that the file is damaged.
    """
    nets = nets_of(scene)
    return FaceArrays(
        {
            placed.name: _read_face(
                entries,
                folder + names.face(placed, what),
                scene,
                nets[placed.name].shape,
                names.lift(scene, placed.name),
            )
            for placed in designed_faces(scene)
        }
    )


def _read_face(
    entries: Entries, name: str, scene: Scene, shape: tuple[int, int], lift: float
) -> Array:
    heights = entries.array(name, shape)
    if lift:
        heights = frozen(heights + lift)
    optic = scene.optic
    entrance = optic.front_z
    farthest = _FARTHEST * abs(scene.receiver.nearest_to(optic) - entrance)
    away = np.abs(heights - entrance)
    if away.max() > farthest:
        i, j = np.unravel_index(away.argmax(), away.shape)
        raise Refused(
            f"{entries.where(name)}[{i}, {j}]",
            Message(
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


def _read_irradiance(entries: Entries, name: str, scene: Scene, ledger: Ledger) -> Array:
    n_x, n_y = scene.receiver.pixels
    irradiance = entries.array(name, (n_y, n_x))
    most = ledger["emitted"] / np.broadcast_to(scene.receiver.pixel_measure, irradiance.shape)
    with np.errstate(over="ignore"):  # infinite is too much as well
        brightness = np.abs(irradiance) / most
    if brightness.max() > _BRIGHTEST:
        row, column = np.unravel_index(brightness.argmax(), irradiance.shape)
        raise Refused(
            f"{entries.where(name)}[{row}, {column}]",
            Message(
                "{value:.5g} is more than all light of the source in this pixel; "
                "{most:.5g} would be all of it",
                value=irradiance[row, column],
                most=most[row, column],
            ),
        )
    return irradiance


def _read_further(
    entries: Entries, names: Names, folder: str, scene: Scene, figures: Figures
) -> tuple[FurtherLight, ...]:
    given, _, *others = figures.further_images or (), *scene.single
    if len(given) != len(others):
        raise Refused(
            entries.where("session.json"),
            Message(
                "has figures of {given} further images; the scene has {others}",
                given=len(given),
                others=len(others),
            ),
        )
    return tuple(
        FurtherLight(
            _read_irradiance(entries, folder + names.irradiance(number), alone, each.ledger),
            each.loss,
            Account.from_data(each.ledger),
        )
        for number, (alone, each) in enumerate(zip(others, given, strict=True), start=1)
    )


def read_result(
    entries: Entries, names: Names, folder: str, scene: Scene, figures: Figures
) -> Result:
    """Read the result of a design; raise Refused if an array does not fit scene and figures."""
    seconds, count = folder + _SECONDS, (figures.iterations,)
    starts = figures.stage_starts or ()
    if list(starts) != sorted(starts) or not all(0 <= at <= figures.iterations for at in starts):
        raise Refused(
            entries.where(folder + _LOSS),
            Message(
                "has {count} losses; stages cannot have begun after {starts}",
                count=figures.iterations,
                starts=shown(starts),
            ),
        )
    state = LensState(
        heights=read_heights(entries, names, scene, folder),
        irradiance=_read_irradiance(entries, folder + names.irradiance(0), scene, figures.ledger),
        loss=figures.loss,
        account=Account.from_data(figures.ledger),
        shortfall=None if figures.shortfall is None else figures.shortfall.to_shortfall(),
        further=_read_further(entries, names, folder, scene, figures),
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
