"""Upper limits of the light that a train can bring to its receivers, whatever its lens is.

Rays of the source are followed through the faces that the design does not change. The faces behind
them let the most pass at normal incidence, and each deflection costs light: by Fresnel's equations,
and all of it from the critical angle on. A ray to the receiver needs at least the deflection of
`workbench.geometry.reach.least_turn` in all.

Étendue is conserved (Winston, Miñano, Benítez, *Nonimaging Optics*, 2005, chapter 2): rays of the
source fill at most the étendue between the last element and the receiver. Most light comes there if
the rays of the highest radiance, times what can be left of them, fill it.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.analysis.etendue import etendue_to, radiance, scattered_to
from workbench.analysis.tracing.elements import Crossings, TracedRays, joined
from workbench.analysis.tracing.interfaces import DielectricBoundary, reflectances
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.geometry.reach import incidence, largest_turn, least_turn
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.scene import AnyReceiver, Element, Lens, Scene, SplineFace
from workbench.scene.train import leaving

_RAYS = 1 << 16  # of all lines of the light together
# Deflections from 0 to 90 degrees at which the transmittance of faces is tabulated.
_TURNS = 2049
# Standard errors of the mean of the batches that are added to it.
_SURE = 3.0
_SAME = 5e-4  # parts of the light that are no difference in words


class LightLimit(NamedTuple):
    """Upper limits of light, as parts of the emitted flux, each on the way of the one before."""

    meets: float  # meets the first element
    passes: float  # is neither reflected nor absorbed, at best
    turned: float  # can be deflected to the receiver, or scattered there, too
    most: float  # reaches the receiver: fits into the étendue, too

    def to_data(self) -> dict[str, float]:
        """All limits by name, for JSON."""
        return self._asdict()

    @property
    def percent(self) -> str:
        """The limit in per cent, rounded up."""
        return _percent(self.most)

    def sentence(self, scene: Scene, receiver: AnyReceiver) -> Message:
        """The limit, and what makes it."""
        place, optic = Message(receiver.place), scene.first.called
        steps = (
            Message("{part} % meets the {optic}", part=_percent(self.meets), optic=optic),
            Message("{part} % passes the faces at best", part=_percent(self.passes)),
            Message("{part} % can be sent there", part=_percent(self.turned)),
            Message("{part} % fits into the étendue", part=_percent(self.most)),
        )
        reasons = None
        for before, after, step in zip((1.0, *self), self, steps, strict=False):
            if after < before - _SAME:
                both = reasons and Message("{reasons}, {reason}", reasons=reasons, reason=step)
                reasons = both or step
        if reasons is None:
            return Message("All of the light may land {place}.", place=place)
        return Message(
            "At most {most} % of the light can land {place}: {reasons}.",
            most=self.percent,
            place=place,
            reasons=reasons,
        )


def light_limits(scene: Scene) -> tuple[LightLimit, ...]:
    """Return the limits of each image of a scene.

    They hold for every lens within the bounds of the scene's faces; means over random rays are
    raised by three standard errors.

    Examples
    --------
    Both faces of a lens of index 1.5 reflect 4 % at normal incidence:

    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> (found,) = light_limits(open_design(path("examples", "flame.json")).scene)
    >>> round(found.most, 4)
    0.9216
    """
    lines = [_Line.of(line.scene, line.part) for line in scene.lines]
    return tuple(_limit(scene, lines, receiver) for receiver in scene.receivers)


class _Rays(NamedTuple):
    """Rays of a batch behind the faces that the design does not change."""

    met: float  # part of the flux that meets the first element
    flux: Array  # (m,)
    etendue: Array  # (m,), what the rays stand for; 0 if the source has no size
    place: Array  # (m, 3), in the scene
    way: Array  # (m, 3)


class _Line(NamedTuple):
    """A line of the light: its rays, and what the faces behind them can do."""

    part: float
    batches: Sequence[_Rays]
    # (_TURNS,), the most that all faces let pass of light that they deflect by so much in all, or
    # by more; None if they deflect without losses.
    passing: Array
    faces: int

    @classmethod
    def of(cls, scene: Scene, part: float) -> "_Line":
        scene = _with_small_nets(scene)
        number, shaped = _first_shaped(scene)
        before = sum(len(each.placed_faces) for each in scene.elements[:number]) + shaped
        heights = {
            face: scene.element_of(face).place_of(face, *np.zeros((2, *net.shape)))
            for face, net in nets_of(scene).items()
        }
        count = max(_RAYS // len(scene.lines), BATCHES)
        train = OpticalTrain.of(scene, heights, count, 0, Pose(), scene.receivers[:1])
        batches = [_followed(scene, train, before, batch) for batch in range(BATCHES)]
        if shaped:
            batches = [_to_lowest(scene.elements[number], rays) for rays in batches]
        passing, faces = _passing(scene.elements[number:], shaped, scene.source.wavelength)
        return cls(part, batches, passing, faces)

    def passed(self, turn: Array) -> Array:
        """The most of each ray that the faces let pass, deflected by an angle in all."""
        step = math.pi / 2 / (_TURNS - 1)
        # Each face may count as deflecting less than it does, by less than a step.
        index = np.floor(turn / step).astype(int) - (self.faces - 1)
        return np.asarray(self.passing[index.clip(0, _TURNS - 1)])


def _with_small_nets(scene: Scene) -> Scene:
    """The scene with few control points: no light is followed to faces that have some."""
    for number in scene.designed_numbers:
        element = scene.elements[number]
        for placed in element.placed_faces:
            if isinstance(placed.face, SplineFace):
                points = tuple(degree + 1 for degree in placed.face.degree)
                element = element.shaped(placed.name, control_points=points)
        scene = scene.with_element(number, element)
    return scene


def _first_shaped(scene: Scene) -> tuple[int, int]:
    """Index of the first element with a B-spline face, and of that face within it."""
    return next(
        (number, index)
        for number, element in enumerate(scene.elements)
        for index, placed in enumerate(element.placed_faces)
        if isinstance(placed.face, SplineFace)
    )


def _followed(scene: Scene, train: OpticalTrain, before: int, batch: int) -> _Rays:
    source, first = scene.entrance
    rays = joined(list(train.source.batch(batch)))
    emitted = float(rays.flux.sum()) * (1 + train.source.beside)
    inside = outline_of(first).contains(*rays.position[:, :2].T)
    rays = rays._replace(flux=np.where(inside, rays.flux, 0.0) / max(emitted, 1e-300))
    etendue = rays.flux / radiance(source, first, rays.direction)
    met = float(rays.flux.sum())
    for face, boundary in train.faces[:before]:
        rays, _ = boundary.turn(rays, face.meet(rays))
    alive = rays.flux > 0  # others are anywhere
    own = rays.position[alive] + [0.0, 0.0, first.front_z]
    way = np.broadcast_to(rays.direction, rays.position.shape)[alive]
    if not scene.first.upright:
        own, way = scene.first.in_scene(own), way @ scene.first.turn.T
    return _Rays(met, rays.flux[alive], etendue[alive], own, way)


def _to_lowest(element: Element, rays: _Rays) -> _Rays:
    """Rays within a lens where its back face can be at the earliest; others left by the side."""
    assert isinstance(element, Lens)
    low, _ = element.height_range or (-math.inf, math.inf)
    lowest = max(element.z_min, element.base.extent(element.half_width)[0] + low)
    ahead = rays.way @ element.turn[:, 2]
    length = (lowest - element.seen(rays.place)[:, 2]) / np.where(ahead > 0, ahead, math.inf)
    length = length.clip(min=0)
    place = rays.place + length[:, None] * rays.way
    inside = outline_of(element).contains(*element.seen(place)[:, :2].T)
    flux = np.where(inside, rays.flux * np.exp(-element.absorption * length), 0.0)
    return rays._replace(place=place, flux=flux)


def _passing(elements: Sequence[Element], first: int, wavelength: float) -> tuple[Array, int]:
    """The table of `_Line.passing` for the faces of elements from one of the first on."""
    lossless, faces = 1.0, []
    for number, element in enumerate(each.lit(wavelength) for each in elements):
        if isinstance(element, Lens):
            skipped = first if number == 0 else 0
            faces += _faces_of(element)[skipped:]
            if not skipped:
                lossless *= math.exp(-element.absorption * _thinnest(element))
        else:
            lossless *= 1 - element.least_loss
    table = lossless * np.eye(1, _TURNS)[0]
    for face in faces:
        table = _one_after_other(table, face)
    # What is less deflected passes more: the largest of all that are deflected by more.
    table = np.maximum.accumulate(table[::-1])[::-1]
    straight = all(isinstance(element, Lens) for element in elements)
    return (table if straight else np.full(_TURNS, table[0])), max(len(faces), 1)


def _faces_of(lens: Lens) -> list[Array]:
    """Transmittance (_TURNS,) of both faces of a lens by the deflection there; 0 beyond it."""
    turn = np.linspace(0, math.pi / 2, _TURNS)
    n, (entering, leaving_) = lens.index, reflectances(lens)
    inside = incidence(turn, n)
    possible = turn < largest_turn(n)
    boundaries = (
        (DielectricBoundary(1.0, n, "", entering), inside + turn),
        (DielectricBoundary(n, 1.0, "", leaving_), inside),
    )
    found = []
    for boundary, angle in boundaries:
        angle = np.where(possible, angle, 0.0)
        way = np.column_stack([np.sin(angle), np.zeros(_TURNS), np.cos(angle)])
        crossings = Crossings(np.zeros((_TURNS, 3)), np.array([[0.0, 0.0, 1.0]]), np.ones(_TURNS))
        passed, _ = boundary.turn(TracedRays(crossings.position, way, crossings.flux), crossings)
        part = np.where(possible, passed.flux, 0.0)
        found.append(np.maximum.accumulate(part[::-1])[::-1])
    return found


def _one_after_other(one: Array, other: Array) -> Array:
    """What two faces let pass at best that share a deflection."""
    found = np.zeros(_TURNS)
    for index in np.flatnonzero(one):
        np.maximum(found[index:], one[index] * other[: _TURNS - index], out=found[index:])
    return found


def _thinnest(lens: Lens) -> float:
    if lens.designed:
        return lens.min_thickness
    (_, front), (back, _) = (
        (placed.z + z for z in placed.face.undesigned.extent(lens.half_width))
        for placed in lens.placed_faces
    )
    return max(back - front, 0.0)


def _limit(scene: Scene, lines: Sequence[_Line], receiver: AnyReceiver) -> LightLimit:
    capacity, scattered = etendue_to(scene, receiver), scattered_to(scene, receiver)
    onwards = 1 if leaving(scene.source, scene.elements, receiver)[2] > 0 else -1
    found = np.zeros((BATCHES, len(LightLimit._fields)))
    for line in lines:
        for batch, rays in enumerate(line.batches):
            turn = least_turn(receiver, rays.place, rays.way, onwards)
            turned = scattered * rays.flux * line.passed(turn)
            passes = rays.flux.sum() * line.passing[0]
            most = _filling(turned, rays.etendue, capacity)
            found[batch] += np.multiply(line.part, (rays.met, passes, turned.sum(), most))
    error = found.std(axis=0, ddof=1) / math.sqrt(BATCHES)
    limits = np.minimum(found.mean(axis=0) + _SURE * error, 1.0)
    return LightLimit(*np.minimum.accumulate(limits).tolist())


def _filling(flux: Array, etendue: Array, capacity: float) -> float:
    """The most flux of rays that together have no more than an étendue."""
    if etendue.sum() <= capacity:
        return float(flux.sum())
    order = np.argsort(-flux / np.where(etendue > 0, etendue, 1e-300))
    filled = np.cumsum(etendue[order])
    part = ((capacity - filled) / np.where(etendue[order] > 0, etendue[order], 1.0) + 1).clip(0, 1)
    return float(flux[order] @ part)


def _percent(part: float) -> str:
    return f"{math.ceil(1000 * part - 1e-6) / 10:.1f}"
