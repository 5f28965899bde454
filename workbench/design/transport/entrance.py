"""How much light a lens could send where it is wanted, by the shape of its entrance face.

Transport between the light within the lens and the target says how far the light of each cell has
to be deflected, before any face is designed. An exit face deflects light by less than 90° less the
critical angle, and reflects the more of it the nearer it comes to that; two faces share the
deflection. Behind a plane entrance face the light within the lens is at less than the critical
angle to the axis; a hollow one, a sphere about the source, leaves it as wide as it comes.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.faces import SlopeFit
from workbench.design.transport.one_face import FEW_ROUNDS, wanted_cells
from workbench.design.transport.turning import Turning, half_angle
from workbench.design.transport.two_face_light import TwoFaceLight
from workbench.design.transport.view import ReceiverView
from workbench.geometry.reach import largest_turn
from workbench.geometry.surface import freeform_nets
from workbench.messages import Message
from workbench.powers import rounded
from workbench.scene import ConicFace, Element, Face, Lens, PlaneFace, Scene, SplineFace

_CELLS, _NET = 64, 8  # cells along each axis, and control points of a plate
# Depths of a hollow entrance face that are tried, as parts of the distance of the source.
_DEPTHS = 0.25, 0.5, 0.75
_DEEPEST = 0.9  # and at most, as part of the way to the rim
# Part of the light that an exit face reflects, from which on it deflects near the critical angle;
# at normal incidence it is 0.04.
_MUCH = 0.12
# Another entrance face is proposed that sends so much more light.
_BETTER = 1.1
# Distances along u and v that differ by less than this part are the same.
_ROUND = 0.2


class EntranceReach(NamedTuple):
    """What a lens can do with an entrance face, before its design."""

    face: Face
    inside: float  # part of the light that meets the exit face
    sent: float  # part of the light that the faces can send to its place
    turn: float  # largest deflection that is needed behind the entrance face, degrees
    # Where light goes that is reflected on its way: mean distances along u and v from the middle of
    # the receiver, in half of its extents.
    place: tuple[float, float]

    @property
    def reflected(self) -> float:
        """Part of the light at the exit face that is reflected there."""
        return 1 - self.sent / self.inside if self.inside else 0.0

    @property
    def side(self) -> Message:
        """The part of the receiver that light cannot reach, within a sentence."""
        across, up = self.place
        if abs(across - up) < _ROUND * max(across, up):
            return Message("rim")
        return Message("left and right sides") if across > up else Message("top and bottom")

    @property
    def sentence(self) -> Message:
        """The face and the light that it could send, within a sentence."""
        part = 100 * self.sent
        if isinstance(self.face, ConicFace):
            return Message(
                "{part:.0f} % with a hollow one (conic of radius {radius:.3g})",
                part=part,
                radius=self.face.radius,
            )
        if isinstance(self.face, SplineFace):
            return Message("{part:.0f} % with a freeform one", part=part)
        return Message("{part:.0f} % with a plane entrance face", part=part)


def out_of_reach(scene: Scene, target: Array) -> Message | None:
    """What faces can hardly deflect as far as a target needs, where that is, and what helps.

    None where the lens reaches nearly all of it, and for scenes other than a lens and an image.
    """
    if not _asks_much(scene):
        return None
    optic, receiver = scene.optic, scene.receiver
    own = reach(scene, target, optic.entrance)
    if own.reflected < _MUCH:
        return None
    better = [
        other
        for other in (reach(scene, target, face) for face in _others(scene))
        if other.sent > _BETTER * own.sent
    ]
    better.sort(key=lambda each: -each.sent)
    most = math.degrees(largest_turn(optic.index))
    why = Message(
        "towards the {side} of the {receiver} deflections up to {turn:.0f} degrees are needed, "
        "of which the exit face makes less than {most:.0f}: it would reflect {part:.0f} % of the "
        "light",
        side=own.side,
        receiver=receiver.called,
        turn=own.turn,
        most=most,
        part=100 * own.reflected,
    )
    if not better:
        return Message(
            "{why}; a smaller or farther target needs less, and no other entrance face helps",
            why=why,
        )
    kinds = {type(each.face): each for each in reversed(better)}
    shown = [own, *sorted(kinds.values(), key=lambda each: each.sent)]
    names = {f"face_{number}": each.sentence for number, each in enumerate(shown)}
    return Message(
        "{why}. The lens can send to its place at best: {faces}. Set {field}, or use a smaller or "
        "farther target",
        why=why,
        faces=Message(", ".join(f"{{{name}}}" for name in names), **names),
        field=f"{scene.optic_path}.faces[0].shape",
    )


def is_steep(scene: Scene, target: Array) -> bool:
    """Whether an exit face behind a plane entrance face would reflect much of the light."""
    return _asks_much(scene) and reach(scene, target, PlaneFace()).reflected >= _MUCH


def _asks_much(scene: Scene) -> bool:
    """Whether some light of a lens may have to be deflected by more than a face can."""
    optic = scene.optic
    if scene.is_train or len(scene.images) > 1 or not isinstance(optic, Lens):
        return False
    if scene.run.method != "auto" or scene.fixed_faces:
        return False
    (r_x, r_y), (left, right, bottom, top) = optic.half_width, scene.receiver.bounds
    x, y = (f.ravel()[:, None] for f in np.meshgrid([-r_x, 0, r_x], [-r_y, 0, r_y]))
    u, v = (f.ravel() for f in np.meshgrid([left, right], [bottom, top]))
    place = x + 0 * u, y + 0 * v, np.full((len(x), len(u)), optic.leaving_z)
    aims = scene.receiver.towards(optic, place, u, v)
    towards = np.stack(np.broadcast_arrays(*aims, place[0])[:3])
    source = scene.source.sharp
    way = np.broadcast_to(source.heading[:, None, None], towards.shape)
    if source.place is not None:
        at = np.stack([place[0], place[1], np.full_like(place[0], optic.front_z)])
        way = at - np.asarray(source.place)[:, None, None]
    way = way / np.linalg.norm(way, axis=0) / optic.index
    along = np.sqrt(1 - way[0] ** 2 - way[1] ** 2)
    cosine = way[0] * towards[0] + way[1] * towards[1] + along * towards[2]
    return bool((cosine < 1 / optic.index).any())


def _others(scene: Scene) -> Iterator[Face]:
    """Entrance faces other than that of a scene: a plane, hollow ones, and a freeform one."""
    own, optic, place = scene.optic.entrance, scene.optic, scene.source.place
    if not own.flat:
        yield PlaneFace()
    if not isinstance(own, SplineFace):
        yield SplineFace()
    if isinstance(own, ConicFace) or place is None:
        return
    for part in _DEPTHS:
        yield hollow(optic, part * (optic.datum - place[2]))


def hollow(optic: Element, depth: float) -> ConicFace:
    """A sphere whose vertex is so far behind the rim of an element, or less far if that is deep."""
    ellipse = optic.outline == "ellipse"
    rim = max(optic.half_width) if ellipse else math.hypot(*optic.half_width)
    depth = min(depth, _DEEPEST * rim)
    return ConicFace(radius=-rounded((rim**2 + depth**2) / (2 * depth), 3))


def reach(scene: Scene, target: Array, face: Face) -> EntranceReach:
    """What a lens can do with an entrance face in place of its own.

    `scene`: a lens with its source and one image; `target` (n_y, n_x): the wanted image in any
    scale, row 0 at +y.
    """
    freeform = isinstance(face, SplineFace)
    optic = scene.optic.with_front(PlaneFace() if freeform else face)
    scene = scene.with_optic(optic.shaped(control_points=(_NET, _NET)))
    optic, receiver, view = scene.optic, scene.receiver, ReceiverView.of(scene)
    ((name, net),) = freeform_nets(optic).items()
    light = TwoFaceLight(scene, {name: SlopeFit(net, _CELLS)}, _CELLS)
    limits = HeightLimits.of_faces(bounded(scene))[name]
    traced = light.through({name: np.full(net.shape, float(limits.undesigned.mean()))})
    inside = float(traced.inside.sum())
    if not inside:
        return EntranceReach(face, 0.0, 0.0, 0.0, (0.0, 0.0))
    transport = Transport(traced.inside / inside, *wanted_cells(scene, target, _CELLS), FEW_ROUNDS)
    to = view.places(transport)
    going = receiver.towards(optic, traced.exit, *to)
    coming = light.coming if freeform else traced.glass
    cosine = sum(one * other for one, other in zip(coming, going, strict=True))
    turn = np.arccos(np.clip(cosine, -1, 1))
    spread = half_angle(scene) * light.coming[2] ** 2 / optic.index
    turning = Turning.at_exit(optic)
    passing = turning.passing(turn / 2 if freeform else turn, spread)
    lost = traced.inside * (1 - passing)
    total = float(lost.sum()) or 1.0  # where no light is lost, none lands anywhere
    across, up = (
        float((lost * abs(place - middle)).sum()) / total / half
        for place, middle, half in zip(to, receiver.middle, receiver.half_extent, strict=True)
    )
    largest = float(np.degrees(turn[traced.inside > 0].max()))
    sent = float((traced.inside * passing).sum())
    return EntranceReach(face, inside, sent, largest, (across, up))
