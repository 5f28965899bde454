"""The optical train of a scene, the sequence of elements that its light passes, and the walk."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from workbench.analysis.tracing.elements import (
    Boundary,
    Detector,
    LightSource,
    TracedFace,
    TracedRays,
)
from workbench.analysis.tracing.interfaces import (
    DielectricBoundary,
    MirrorBoundary,
    ScatterBoundary,
    reflectances,
)
from workbench.analysis.tracing.pose import ElementPose, Pose
from workbench.analysis.tracing.receivers import detector_of
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.surfaces.fixed import FlatFace, fixed_surface
from workbench.analysis.tracing.surfaces.placed import MovedFace, PlacedSurface, ReliefFace
from workbench.analysis.tracing.surfaces.spline import FrontFace, LaterFace, SplineFace
from workbench.arrays import Array
from workbench.geometry.as_made import AsMade
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.scene import AnyReceiver, Diffuser, Element, Lens, Mirror, Scene
from workbench.scene.losses import key_of
from workbench.scene.train import check_receivers

# Rays followed together: what is made of them on the way stays within the cache.
_AT_ONCE = 1 << 13


class Tally:
    """Where the light of some rays went, in any unit.

    `images`, `pixels`: how many images there are, and the pixels of each. `flux` (images, pixels):
    flux in the pixels, along the rows; `beside` (images,): flux that went beside each image;
    `emitted`: flux of the source; `lost`: flux that was lost on the way, by its keys in the light
    account.
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

    `faces`: faces, and what each does to light; `detector`: where light is counted; `names`: of the
    element of each face, empty if there is only one element.
    """

    def __init__(
        self,
        source: LightSource,
        faces: Sequence[tuple[TracedFace, Boundary]],
        detector: Detector,
        names: Sequence[str],
    ) -> None:
        self.source, self.faces, self.detector, self.names = source, faces, detector, names

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
        """Make the train of a scene with receivers of one kind; for the parameters see `Trace`.

        Designed elements are as their processes leave them.
        Raises `Refused` if one of several elements is out of its place, or a receiver may touch the
        last one.
        """
        if pose != Pose():
            scene.check_one_element("a check of an element out of its place")
        check_receivers(scene, receivers)
        made = AsMade.of(scene)
        scene, heights = made.scene, made.heights(heights)
        elements = [element.lit(scene.source.wavelength) for element in scene.elements]
        first = elements[0]  # all light passes its aperture, in whose coordinates it is followed
        turn, aperture = _turn(first), _place(first, first.front_z)
        faces: list[tuple[TracedFace, Boundary]] = []
        names: list[str] = []
        for number, (element, way) in enumerate(zip(elements, scene.ways, strict=True)):
            designed = element.designed
            stands, own_turn = _Stands(number == 0, False), _turn(element)
            if isinstance(element, Mirror | Diffuser) and way @ own_turn[:, 2] < 0:
                stands, own_turn = _Stands(False, True), own_turn * [1.0, -1.0, -1.0]
            if designed:
                own = _DESIGNED[type(element)](element, heights, pose, stands)
            else:
                own = _FIXED[type(element)](element, stands)
            if designed and made.reliefs:
                own = _with_reliefs(element, own, made)
            place = _place(element, element.front_z if designed else element.position[2])
            relative = np.eye(3) if number == 0 else turn.T @ own_turn
            faces += _placed(own, relative, (place - aperture) @ turn, max(element.half_width))
            names += [element.name if len(elements) > 1 else ""] * len(own)
        if not first.upright:
            pose = ElementPose(decentre=tuple(aperture[:2]), turn=turn)
            lift = aperture[2] - first.front_z
            first = first.straightened
            first = first.model_copy(update={"position": (0.0, 0.0, first.position[2] + lift)})
        middle = scene.source.place or (0.0, 0.0, first.front_z)
        return cls(
            light_source(scene.source, first, pose.of_source(middle), rays, seed),
            faces,
            detector_of(receivers, first.front_z, scene.onwards(receivers[0]), pose),
            names,
        )

    @property
    def missed(self) -> str:
        """Key in the light account of light that does not come to the aperture."""
        return key_of(self.faces[0][0].missed, self.names[0])

    def lit_by(self, source: LightSource) -> "OpticalTrain":
        """The same elements with another source."""
        return OpticalTrain(source, self.faces, self.detector, self.names)

    def walk(self, rays: TracedRays, tally: Tally) -> None:
        """Follow rays from the source to the receiver, and add their light to a tally."""
        flux = float(rays.flux.sum())
        tally.emitted += flux * (1 + self.source.beside)
        if self.source.beside:
            tally.lose(self.missed, flux * self.source.beside)
        self.follow(rays, tally)

    def hits(
        self, rays: TracedRays, places: Array, flux: Array, lost: dict[str, Array] | None = None
    ) -> None:
        """Follow rays to the first of the screens.

        `places`, `flux`: get column and row in pixels where they meet the screen, which is not
        finite for those that never do, and their flux there. A ray that is lost has no flux and any
        place. `lost` gets the flux that each ray loses, by keys of the light account.
        """
        first = 0
        for some in rays.split(_AT_ONCE):
            arrived, losses = self.leaving(some)
            last = first + len(some.flux)
            self.detector.hits(arrived, places[first:last])
            flux[first:last] = arrived.flux
            if lost is not None:
                for name, each in losses.items():
                    lost.setdefault(name, np.zeros(len(rays.flux)))[first:last] = each
            first = last

    def follow(self, rays: TracedRays, tally: Tally) -> None:
        """Follow rays from the aperture to the receiver; a tally gets where they go."""
        for some in rays.split(_AT_ONCE):
            arrived, losses = self.leaving(some)
            for name, flux in losses.items():
                tally.lose(name, float(flux.sum()))
            self.detector.count(arrived, tally.flux, tally.beside)

    def leaving(self, rays: TracedRays) -> tuple[TracedRays, dict[str, Array]]:
        """The rays behind all faces, and the flux (m,) that each loses, by key of the loss."""
        losses: dict[str, Array] = {}
        for (face, boundary), name in zip(self.faces, self.names, strict=True):
            crossings = face.meet(rays)
            missed = {face.missed: rays.flux - crossings.flux}
            rays, lost = boundary.turn(rays, crossings)
            for kind, flux in (*missed.items(), *lost.items()):
                key = key_of(kind, name)
                losses[key] = losses[key] + flux if key in losses else flux
        return rays, losses


class _Stands(NamedTuple):
    """How an element stands: whether light of the source comes to it, and whether to its back."""

    first: bool
    turned: bool


def _with_reliefs(
    element: Element, faces: Sequence[tuple[TracedFace, Boundary]], made: AsMade
) -> Sequence[tuple[TracedFace, Boundary]]:
    """Faces of a designed element with the relief of manufacture on its freeform faces."""
    freeform = freeform_nets(element)
    return [
        (ReliefFace(face, made.reliefs, element.outwards(placed.name)), boundary)
        if placed.name in freeform
        else (face, boundary)
        for placed, (face, boundary) in zip(element.placed_faces, faces, strict=True)
    ]


def _turn(element: Element) -> Array:
    """Unit vectors of an element in the scene, as columns (3, 3)."""
    if not any(element.tilt):
        return np.eye(3)
    return np.asarray(Rotation.from_euler("XYZ", element.tilt, degrees=True).as_matrix())


def _place(element: Element, z: float) -> Array:
    """Where a z of an element is on its own axis, shape (3,), in the scene."""
    return element.position + (z - element.position[2]) * _turn(element)[:, 2]


def _designed_lens(
    lens: Lens, heights: Mapping[str, Array], pose: Pose, stands: _Stands
) -> Sequence[tuple[TracedFace, Boundary]]:
    """Faces of the designed lens, z from its aperture."""
    front, back = lens.designed_front, heights[lens.designed_face]
    if front is not None:
        kind = FrontFace if stands.first else LaterFace
        net = freeform_nets(lens)[front]
        entrance: TracedFace = kind(lens, heights[front], "missed_lens", net)
    else:
        entrance = _fixed_face(lens, 0, lens.entrance_z - lens.front_z, 0.0)
    exit_face = SplineFace(lens, back, "left_side")
    if any((*pose.exit_tilt, *pose.exit_decentre)):
        exit_face = MovedFace(lens, back, "left_side", pose)
    return _refracting(lens, entrance, exit_face)


def _fixed_lens(lens: Lens, stands: _Stands) -> Sequence[tuple[TracedFace, Boundary]]:
    """Faces of a lens that is not designed, z from its front vertex."""
    aperture_z = lens.front_z - lens.entrance_z if stands.first else None
    front = _fixed_face(lens, 0, 0.0, aperture_z)
    return _refracting(lens, front, _fixed_face(lens, 1, lens.thickness, None))


def _fixed_face(lens: Lens, number: int, z: float, aperture_z: float | None) -> TracedFace:
    """The front face (0) or the back face (1) of a lens, its vertex at z."""
    missed = ("missed_lens", "left_side")[number]
    face = lens.faces[number].undesigned
    return fixed_surface(face, z, outline_of(lens), missed, aperture_z)


def _refracting(
    lens: Lens, front: TracedFace, back: TracedFace
) -> Sequence[tuple[TracedFace, Boundary]]:
    n, (entering, leaving) = lens.index, reflectances(lens)
    return (
        (front, DielectricBoundary(1.0, n, "fresnel_entrance", entering)),
        (back, DielectricBoundary(n, 1.0, "fresnel_exit", leaving, lens.absorption)),
    )


def _designed_mirror(
    mirror: Mirror, heights: Mapping[str, Array], pose: Pose, stands: _Stands
) -> Sequence[tuple[TracedFace, Boundary]]:
    kind = FrontFace if stands.first else LaterFace
    face = kind(mirror, heights[mirror.designed_face], "missed_mirror")
    return ((face, MirrorBoundary(mirror.reflectance)),)


def _fixed_mirror(mirror: Mirror, stands: _Stands) -> Sequence[tuple[TracedFace, Boundary]]:
    """The face of a mirror that is not designed, z from its vertex."""
    face = mirror.face.undesigned
    aperture_z = mirror.front_z - mirror.position[2] if stands.first else None
    face = face.turned() if stands.turned else face
    surface = fixed_surface(face, 0.0, outline_of(mirror), "missed_mirror", aperture_z)
    return ((surface, MirrorBoundary(mirror.reflectance)),)


def _diffuser(diffuser: Diffuser, stands: _Stands) -> Sequence[tuple[TracedFace, Boundary]]:
    plane = FlatFace(0.0, outline_of(diffuser), "missed_diffuser")
    return ((plane, ScatterBoundary(diffuser)),)


def _placed(
    faces: Sequence[tuple[TracedFace, Boundary]], turn: Array, shift: Array, size: float
) -> Sequence[tuple[TracedFace, Boundary]]:
    """Faces of an element in the coordinates of the walk, in which its origin is shifted."""
    if not shift.any() and np.array_equal(turn, np.eye(3)):
        return faces
    return [(PlacedSurface(face, turn, shift, size), boundary) for face, boundary in faces]


_DESIGNED: Mapping[
    type, Callable[[Any, Mapping[str, Array], Pose, _Stands], Sequence[tuple[TracedFace, Boundary]]]
] = {Lens: _designed_lens, Mirror: _designed_mirror}
_FIXED: Mapping[type, Callable[[Any, _Stands], Sequence[tuple[TracedFace, Boundary]]]] = {
    Lens: _fixed_lens,
    Mirror: _fixed_mirror,
    Diffuser: _diffuser,
}
