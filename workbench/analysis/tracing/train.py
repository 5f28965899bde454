"""The optical train of a scene, the sequence of elements that its light passes, and the walk."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from workbench.analysis.tracing.elements import (
    Boundary,
    Detector,
    LightSource,
    TracedFace,
    TracedRays,
)
from workbench.analysis.tracing.interfaces import DielectricBoundary, MirrorBoundary, reflectances
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.receivers import detector_of
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.surfaces import FlatFace, FrontFace, MovedFace, SplineFace
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.scene import AnyReceiver, Lens, Mirror, Scene

# Rays followed together: what is made of them on the way stays within the cache.
_AT_ONCE = 1 << 13


class Tally:
    """Where the light of some rays went, in any unit.

    Parameters
    ----------
    images, pixels : int
        How many images there are, and the pixels of each.

    Attributes
    ----------
    flux : ndarray, shape (images, pixels)
        Flux in the pixels, along the rows.
    beside : ndarray, shape (images,)
        Flux that went beside each image.
    emitted : float
        Flux of the source.
    lost : dict[str, float]
        Flux that was lost on the way, by its names in the light account.
    """

    def __init__(self, images: int, pixels: int) -> None:
        self.flux, self.beside = np.zeros((images, pixels)), np.zeros(images)
        self.emitted = 0.0
        self.lost: dict[str, float] = {}

    def add(self, other: "Tally") -> None:
        """Take in the light of other rays."""
        self.flux += other.flux
        self.beside += other.beside
        self.emitted += other.emitted
        for name, flux in other.lost.items():
            self.lose(name, flux)

    def lose(self, name: str, flux: float) -> None:
        """Add to a loss."""
        self.lost[name] = self.lost.get(name, 0.0) + flux


class OpticalTrain:
    """Source, faces and receiver in the order in which light meets them.

    Parameters
    ----------
    source : LightSource
        The source.
    faces : sequence of (TracedFace, Boundary)
        Faces, and what each does to light.
    detector : Detector
        Where light is counted.
    """

    def __init__(
        self,
        source: LightSource,
        faces: Sequence[tuple[TracedFace, Boundary]],
        detector: Detector,
    ) -> None:
        self.source, self.faces, self.detector = source, faces, detector

    @classmethod
    def of(
        cls,
        scene: Scene,
        heights: Mapping[str, Array],
        rays: int,
        seed: int,
        pose: Pose,
        receivers: Sequence[AnyReceiver],
    ) -> "OpticalTrain":
        """The train of a scene with receivers of one kind; for the parameters see `Trace`."""
        optic = scene.optic
        middle = scene.source.place or (0.0, 0.0, optic.front_z)
        return cls(
            light_source(scene.source, optic, pose.of_source(middle), rays, seed),
            _FACES[type(optic)](optic, heights, pose),
            detector_of(receivers, optic, pose),
        )

    def lit_by(self, source: LightSource) -> "OpticalTrain":
        """The same elements with another source."""
        return OpticalTrain(source, self.faces, self.detector)

    def lit(self, origin: int, x: Array, y: Array) -> TracedRays:
        """Rays of one origin to places of the first face; see `TracedFace.lit`."""
        return self.faces[0][0].lit(self.source, origin, x, y)

    def walk(self, rays: TracedRays, tally: Tally) -> None:
        """Follow rays from the source to the receiver, and add their light to a tally."""
        flux = float(rays.flux.sum())
        tally.emitted += flux * (1 + self.source.beside)
        if self.source.beside:
            tally.lose(self.faces[0][0].missed, flux * self.source.beside)
        for some in rays.split(_AT_ONCE):
            self._follow(some, tally)

    def hits(self, rays: TracedRays, places: Array, flux: Array) -> None:
        """Follow rays to the first of the screens.

        Parameters
        ----------
        rays : TracedRays
            The rays.
        places, flux : ndarray, shapes (m, 2), (m,)
            Get column and row in pixels where they meet the screen, which is not finite for those
            that never do, and their flux there. A ray that is lost has no flux and any place.
        """
        first = 0
        for some in rays.split(_AT_ONCE):
            arrived = self.leaving(some)
            last = first + len(some.flux)
            self.detector.hits(arrived, places[first:last])
            flux[first:last] = arrived.flux
            first = last

    def _follow(self, rays: TracedRays, tally: Tally) -> None:
        self.detector.count(self.leaving(rays, tally), tally.flux, tally.beside)

    def leaving(self, rays: TracedRays, tally: Tally | None = None) -> TracedRays:
        """The rays behind all faces; a tally gets what is lost."""
        for face, boundary in self.faces:
            crossings = face.meet(rays)
            rays, lost = boundary.turn(rays, crossings)
            if tally is not None:
                tally.lose(face.missed, crossings.missed)
                for name, flux in lost.items():
                    tally.lose(name, flux)
        return rays


def _of_lens(
    lens: Lens, heights: Mapping[str, Array], pose: Pose
) -> Sequence[tuple[TracedFace, Boundary]]:
    n, (entering, leaving) = lens.index, reflectances(lens)
    entrance: TracedFace = FlatFace(0.0, outline_of(lens), "missed_lens")
    if "entrance" in heights:
        net = freeform_nets(lens)["entrance"]
        entrance = FrontFace(lens, heights["entrance"], "missed_lens", net)
    exit_face = SplineFace(lens, heights["exit"], "left_side")
    if any((*pose.exit_tilt, *pose.exit_decentre)):
        exit_face = MovedFace(lens, heights["exit"], "left_side", pose)
    return (
        (entrance, DielectricBoundary(1.0, n, "fresnel_entrance", entering)),
        (exit_face, DielectricBoundary(n, 1.0, "fresnel_exit", leaving, lens.absorption)),
    )


def _of_mirror(
    mirror: Mirror, heights: Mapping[str, Array], pose: Pose
) -> Sequence[tuple[TracedFace, Boundary]]:
    face = FrontFace(mirror, heights["mirror"], "missed_mirror")
    return ((face, MirrorBoundary(mirror.reflectance)),)


_FACES: Mapping[
    type, Callable[[Any, Mapping[str, Array], Pose], Sequence[tuple[TracedFace, Boundary]]]
] = {
    Lens: _of_lens,
    Mirror: _of_mirror,
}
