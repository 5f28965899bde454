"""The way of the light: the sequence of elements that a scene makes, and the walk along it.

The walk is plain torch, in any float type, on any device, differentiable forward and backward. It
is the reference: tests hold all other tracers to it, and where there is no other it does the work.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline, outline_of
from workbench.geometry.surface import ControlNet, nets_of
from workbench.optics.interfaces import Passed
from workbench.optics.rays import Arrival, RayBundle, Vector, place_seen, seen
from workbench.optics.receivers import Receiver, receiver_of
from workbench.optics.samples import Samples
from workbench.optics.sources import Emitter, emitter_of
from workbench.optics.steps import FaceStep, PathContext, changes_of, frame_of, steps_of
from workbench.optics.surfaces import Meeting
from workbench.scene import Scene

# Less light than this is none: rays that carry all of it add up to 1 but for so much.
_ROUNDING = 1e-12


class Passage(NamedTuple):
    """Rays at one face."""

    step: FaceStep
    meeting: Meeting  # where they meet it, in its frame
    passed: Passed  # what goes on


class Path:
    """Source, faces and receiver of a scene, with everything that heights do not change.

    The source is in coordinates of the first element: it fills the aperture of that, however that
    stands. The receiver is in those of the scene. Both count z from a datum. Each face has its own
    frame. Rays before the first freeform face are in the frame of that face: what samples that face
    has its coordinates.

    `steps`: faces in the order in which light meets them, each along +z of its frame; `receiver`:
    where the light is wanted; `datum`: from which the elements count z: near the face, so that
    float32 keeps the digits that make its shape; `outline`: of the element; and of the aperture
    before it, which all of its light passes; `seed`: of the source's rays; `dtype`, `device`: float
    type and device of the walk; `front_z`: z of the source where that aperture is; the datum by
    default; `source`: where coordinates of the source stand in the scene; they are those of the
    scene by default; `turn` (3, 3): unit vectors of the receiver's coordinates, as columns; those
    of the scene by default. `fixed`, `shaped`: the steps before the first freeform face, and it
    with all behind; `changes_before`, `changes`: changes of coordinates before each of the fixed
    steps and to the first freeform face; before each of the others and behind the last one, see
    `changes_of`; `draw`: number of the set of the source's rays.
    """

    def __init__(
        self,
        emitter: Emitter,
        steps: Sequence[FaceStep],
        receiver: Receiver,
        datum: float,
        outline: Outline,
        seed: int,
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
        front_z: float | None = None,
        source: Frame | None = None,
        turn: Array | None = None,
    ) -> None:
        self.emitter, self.steps, self.receiver = emitter, tuple(steps), receiver
        self.datum, self.outline = datum, outline
        self.front_z = datum if front_z is None else front_z
        self.dtype, self.device, self._seed, self.draw = dtype, device, seed, 0
        fixed = next((i for i, step in enumerate(steps) if step.surface.freeform), len(steps))
        self.fixed, self.shaped = self.steps[:fixed], self.steps[fixed:]
        frames = [step.frame for step in self.steps]
        first = frames[fixed] if self.shaped else None
        level = np.array([0.0, 0.0, datum])
        self._source = source or Frame(np.zeros(3), np.eye(3))
        self._begin = Frame(
            self._source.position + self._source.rotation @ level, self._source.rotation
        )
        self._end = Frame(level, np.eye(3) if turn is None else turn)
        self.changes_before = changes_of([None, *frames[:fixed], first], self._begin)
        self.changes = changes_of([first, *frames[fixed:], self._end], self._begin)
        self._rays: RayBundle | None = None
        self._lost: dict[str, Tensor] | None = None

    @classmethod
    def of(
        cls,
        scene: Scene,
        net: ControlNet,
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
        samples: Samples | None = None,
    ) -> "Path":
        """The path of a scene, with heights of the face that the task shapes on a net.

        ``samples`` as for `emitter_of`.
        """
        optic, (source, first) = scene.optic, scene.entrance
        # Light along the axis stays so up to the only freeform face.
        straight = source.along_axis and len(nets_of(scene)) == 1 and first.designed
        datum = optic.base.height if straight else optic.datum
        emitter, outline = emitter_of(source, first, samples), outline_of(first)
        light = emitter.by_area, source.along_axis, source.subdivisions
        nets = {optic.designed_face: net}
        steps = steps_of(scene, PathContext(nets, datum, *light, dtype, device))
        receiver = receiver_of(scene.receiver, optic, datum, scene.onwards(scene.receiver))
        walk = scene.run.seed, dtype, device, first.front_z
        frames = frame_of(scene.first, 0.0), scene.receiver.turn
        return cls(emitter, steps, receiver, datum, outline, *walk, *frames)

    @property
    def rays(self) -> RayBundle:
        """The source's rays before the first freeform face, those that get there."""
        if self._rays is None:
            self._rays = self.begin().to(self.device, self.dtype)
        return self._rays

    @property
    def lost(self) -> dict[str, Tensor]:
        """Flux lost before the first freeform face, by name; see `Arrival.lost`."""
        if self._lost is None:
            self._rays = self.begin().to(self.device, self.dtype)
        return dict(self._lost or {})

    def begin(self) -> RayBundle:
        """The source's rays before the first freeform face in float64, computed at each call."""
        rays = self.emitter.rays(self._seed, self.draw)
        if not self.emitter.by_area:  # else their flux is that of what the aperture lets through
            rays = _stopped(rays, self.outline)
        rays = rays._replace(position=_lifted(rays.position, -self.datum))
        passing = 1 - _total(rays)
        rays, lost, _ = _through(self.fixed, self.changes_before, rays, {})
        if abs(passing) > _ROUNDING:  # few samples may make more than all light
            lost = _added(lost, {self.steps[0].missed: rays.flux.new_tensor(passing)})
        self._lost = {name: flux.to(self.device) for name, flux in lost.items()}
        return _living(rays)

    def redraw(self) -> None:
        """Take another set of the source's rays."""
        self.draw += 1
        self._rays = self._lost = None

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the source's rays to the receiver.

        `heights`: control heights (n_u, n_v) of each freeform surface by name, scene units.
        """
        rays, lost, _ = _through(self.shaped, self.changes, self.rays, heights)
        return Arrival(*self.receiver.places(rays), rays, _added(self.lost, lost))

    def passages(self, heights: Mapping[str, Tensor]) -> list[Passage]:
        """What the source's rays do at the first freeform face and at all behind; see `walk`."""
        return _through(self.shaped, self.changes, self.rays, heights)[2]

    def places_at(self, passage: Passage) -> Vector:
        """Where rays meet a face, as places of the scene."""
        frame = passage.step.frame or self._begin
        return place_seen(passage.meeting.position, frame)

    def follow(
        self, rays: RayBundle, heights: Mapping[str, Tensor]
    ) -> tuple[list[Vector], Arrival]:
        """Trace other rays to the receiver, and return where they meet each face.

        `rays`: rays before the first face in the path's float type, as the source gives them;
        `heights`: see `walk`. Returns places of the scene where they begin and on each face; of
        rays that do not meet it, and at all faces behind it, where they end. Then the arrival at
        the receiver.
        """
        passages, arrival = self.passages_of(rays, heights)
        places, alive = [place_seen(rays.position, self._source)], rays.alive
        for passage in passages:
            x, y, z = (
                torch.where(alive, here, before)
                for here, before in zip(self.places_at(passage), places[-1], strict=True)
            )
            places.append((x, y, z))
            alive = passage.passed.rays.alive
        return places, arrival

    def passages_of(
        self, rays: RayBundle, heights: Mapping[str, Tensor]
    ) -> tuple[list[Passage], Arrival]:
        """What other rays do at all faces, and their arrival; for the parameters see `follow`."""
        rays = rays._replace(position=_lifted(rays.position, -self.datum))
        frames = [None, *(step.frame for step in self.steps), self._end]
        changes = changes_of(frames, self._begin)
        rays, lost, passages = _through(self.steps, changes, rays, heights)
        return passages, Arrival(*self.receiver.places(rays), rays, lost)

    def ends(self, rays: RayBundle) -> Vector:
        """Where to end rays behind the last face in a drawing; z as in the scene."""
        return _lifted(self.receiver.ends(rays), self.datum)


def _stopped(rays: RayBundle, outline: Outline) -> RayBundle:
    """Rays that are in the plane of the aperture; those beside it end there."""
    x, y, _ = rays.position
    alive = rays.alive & outline.contains(x, y)
    return rays._replace(flux=torch.where(alive, rays.flux, 0.0), alive=alive)


def _through(
    steps: Sequence[FaceStep],
    changes: Sequence[Frame],
    rays: RayBundle,
    heights: Mapping[str, Tensor],
) -> tuple[RayBundle, dict[str, Tensor], list[Passage]]:
    """Rays behind some faces, light lost there by name, and what they do at each face.

    ``changes`` of coordinates are before each face, and behind the last one.
    """
    account: dict[str, Tensor] = {}
    passages = []
    for step, change in zip(steps, changes[:-1], strict=True):
        rays = seen(rays, change)
        meeting = step.surface.meet(rays, heights)
        passed = step.interface.turn(rays, meeting)
        with torch.no_grad():
            lost = {step.missed: torch.where(meeting.met, 0.0, rays.flux), **passed.lost}
            sums = {name: flux.sum(dtype=torch.float64) for name, flux in lost.items()}
        account = _added(account, sums)
        passages.append(Passage(step, meeting, passed))
        rays = passed.rays
    return seen(rays, changes[-1]), account, passages


def _total(rays: RayBundle) -> float:
    """Flux of all rays; what is missing to 1 passes the first face by."""
    x, y, _ = rays.position
    return float((rays.flux + torch.zeros_like(x + y)).sum())


def _added(account: Mapping[str, Tensor], more: Mapping[str, Tensor]) -> dict[str, Tensor]:
    return dict(account) | {name: account.get(name, 0.0) + flux for name, flux in more.items()}


def _lifted(place: Vector, by: float) -> Vector:
    x, y, z = place
    return x, y, z + by


def _living(rays: RayBundle) -> RayBundle:
    """The bundle without rays that are lost whatever the heights: left out once, not in a walk."""
    if rays.alive.all():
        return rays
    alive = rays.alive

    def some(part: Tensor) -> Tensor:
        return part.expand(alive.shape)[alive]

    def vector(parts: Vector) -> Vector:
        x, y, z = map(some, parts)
        return x, y, z

    return RayBundle(vector(rays.position), vector(rays.direction), some(rays.flux), some(alive))
