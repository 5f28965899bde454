"""What is not known exactly of a set-up that is built, and the cases that stand for it."""

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Annotated, NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.scene.fields import ANGLE, LENGTH, Measure, about
from workbench.scene.making.process import Process
from workbench.scene.part import NonNegative, Part
from workbench.scene.receiver import AnyReceiver
from workbench.scene.turning import turned

if TYPE_CHECKING:
    from workbench.scene.task import Scene


SHARES = (0.0, 0.25, 0.5, 1.0)
"""Parts of an uncertainty that compromises are designed for, unless stated."""


class Case(NamedTuple):
    """A set-up that may be, and how likely."""

    scene: "Scene"
    probability: float


class _Layer(Process):
    thickness: float

    @property
    def removed(self) -> float:
        return -self.thickness


class Uncertainty(Part):
    """Standard deviations of what a built set-up has else than the scene says; 0 where known.

    Runs then lower the mean square of the error over cases: the scene, and for each deviation two
    points at √(d + 1) times it, with d deviations (the unscented transform of Julier and Uhlmann,
    1997, with the weight 1 / (d + 1) of the middle). Means and variances are those of the
    deviations, and the error need not be linear in them.
    """

    distance: Annotated[
        NonNegative,
        LENGTH,
        about("Distance", "Of the receiver, along the light that comes to its middle."),
    ] = 0.0
    source_shift: Annotated[
        NonNegative,
        LENGTH,
        about("Source shift", "Of a source at a place, along x and along y."),
    ] = 0.0
    source_tilt: Annotated[
        NonNegative,
        ANGLE,
        about("Source tilt", "Of collimated light, about x and about y.", le=10),
    ] = 0.0
    source_size: Annotated[
        NonNegative,
        Measure("%", "percent"),
        about(
            "Source size",
            "Of an extended source, in percent of its size.",
            le=20,
        ),
    ] = 0.0
    index: Annotated[
        NonNegative,
        about(
            "Index",
            "Of the refractive index of designed lenses.",
            le=0.05,
        ),
    ] = 0.0
    thickness: Annotated[
        NonNegative,
        LENGTH,
        about(
            "Thickness",
            "Of the material of designed lenses at each freeform face.",
        ),
    ] = 0.0

    def known(self, share: float) -> Self:
        """Return the part of the uncertainty that is this share of its deviations."""
        return type(self)(**{name: share * each for name, each in self.model_dump().items()})

    def cases(self, scene: "Scene") -> tuple[Case, ...]:
        """Return the scene itself and those at the deviations, all of them without uncertainty."""
        scene = scene.model_copy(update={"uncertainty": Uncertainty()})
        ways = self._ways(scene)
        share, far = 1 / (len(ways) + 1), math.sqrt(len(ways) + 1)
        both = (way(scene, sign * far) for way in ways for sign in (1, -1))
        return (Case(scene, share), *(Case(each, share / 2) for each in both))

    def _ways(self, scene: "Scene") -> list[Callable[["Scene", float], "Scene"]]:
        """Steps by a number of deviations, for each deviation that the scene has."""
        ways: list[Callable[[Scene, float], Scene]] = []
        if self.distance:
            ways.append(self._farther)
        placed = scene.source.place is not None
        if self.source_size and scene.source.continuous:
            ways.append(self._larger)
        if scene.optic.index > 1:  # else there is no glass
            ways += [self._denser] if self.index else []
            ways += [self._thicker] if self.thickness else []
        if self.source_shift and placed:
            ways += [partial(self._shifted, axis) for axis in (0, 1)]
        if self.source_tilt and not placed:
            ways += [partial(self._tilted, axis) for axis in (0, 1)]
        return ways

    def _farther(self, scene: "Scene", deviations: float) -> "Scene":
        return farther(scene, deviations * self.distance)

    def _larger(self, scene: "Scene", deviations: float) -> "Scene":
        return with_source_size(scene, deviations * self.source_size / 100)

    def _denser(self, scene: "Scene", deviations: float) -> "Scene":
        for number in scene.designed_numbers:
            element = scene.elements[number].lit(scene.source.wavelength)
            scene = scene.with_element(number, element.denser(deviations * self.index))
        return scene

    def _thicker(self, scene: "Scene", deviations: float) -> "Scene":
        layer = _Layer(thickness=deviations * self.thickness)
        return scene.model_copy(update={"processes": (*scene.processes, layer)})

    def _shifted(self, axis: int, scene: "Scene", deviations: float) -> "Scene":
        place = np.array(scene.source.place)
        place[axis] += deviations * self.source_shift
        return scene.model_copy(update={"source": scene.source.standing(place, np.eye(3))})

    def _tilted(self, axis: int, scene: "Scene", deviations: float) -> "Scene":
        angles = [0.0, 0.0]
        angles[axis] = deviations * self.source_tilt
        turn = turned((angles[0], angles[1]))
        return scene.model_copy(update={"source": scene.source.standing(None, turn)})


def with_source_size(scene: "Scene", more: float) -> "Scene":
    """Return the scene with a source that is larger by a part of its size."""
    return scene.model_copy(update={"source": scene.source.resized(1 + more)})


def way_to(scene: "Scene", receiver: AnyReceiver) -> Array:
    """From where light leaves the designed element to the middle of a receiver, scene units."""
    leaves = scene.optic.in_scene(np.array([0.0, 0.0, scene.optic.leaving_z]))
    return np.asarray(receiver.middle_in_scene - leaves)


def farther(scene: "Scene", by: float) -> "Scene":
    """Return the scene with planes farther along the light that comes to their middles."""
    images = []
    for image in scene.images:
        receiver = image.receiver
        if receiver.stands_at is not None:  # a far field is as far from everywhere
            way = way_to(scene, receiver)
            x, y, z = (receiver.position + by * way / np.linalg.norm(way)).tolist()
            receiver = receiver.model_copy(update={"position": (x, y, z)})
        images.append(image.model_copy(update={"receiver": receiver}))
    return scene.with_images(images)
