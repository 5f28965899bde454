"""Faces in the order in which light meets them: those of the elements of a train.

A new kind of element is its fields in `workbench.scene`, and a row in ``_FACES``.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import torch

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline, Rectangle, outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.interfaces import Interface, Reflection, Refraction, TransmittanceLaw, laws_of
from workbench.optics.surfaces import BSplineSurface, Surface, fixed_surface
from workbench.scene import (
    Diffuser,
    Element,
    Lens,
    Mirror,
    PlacedFace,
    Scene,
)
from workbench.scene.losses import key_of


class FaceStep(NamedTuple):
    """A face on the way of the light."""

    surface: Surface  # where rays meet it
    interface: Interface  # what it does to them
    missed: str  # key in the light account of light that does not meet it
    # Where the coordinates of the surface stand in the scene: light comes to the face along +z of
    # them. None for those of the source with z counted from the datum of the path.
    frame: Frame | None = None

    def from_behind(self) -> "FaceStep":
        """The step for light that comes to a face with a frame along −z of it."""
        if self.frame is None:
            raise ValueError("a step without a frame faces along +z of the source")
        return self._replace(surface=self.surface.from_behind(), frame=self.frame.turned())

    def facing(self, way: Array) -> "FaceStep":
        """The step for light that comes to a face with a frame along a vector of the scene."""
        if self.frame is None or way @ self.frame.rotation[:, 2] >= 0:
            return self
        return self.from_behind()


def frame_of(element: Element, datum: float) -> Frame:
    """Where coordinates of an element stand that count z from a datum; see `Element.origin`."""
    turn = element.turn
    return Frame(element.origin + datum * turn[:, 2], turn)


def changes_of(frames: Sequence[Frame | None], source: Frame) -> list[Frame]:
    """Where the coordinates of each frame stand in those of the next one; None is the source's."""
    stand = [source if frame is None else frame for frame in frames]
    return [one.seen_from(other) for one, other in pairwise(stand)]


class PathContext(NamedTuple):
    """What is known of the light and of the trace before there are faces."""

    # Where control heights of each freeform face of an element sit, by its id.
    nets: Mapping[str, ControlNet]
    datum: float  # z of the scene from which elements count z
    by_area: bool  # whether what is outside the outline is out of the flux before the first face
    along_axis: bool  # whether all rays go along +z
    subdivisions: tuple[int, int] | None  # see `BSplineSurface`
    # Float type and device of the walk.
    dtype: torch.dtype
    device: torch.device | str
    element: str = ""  # name of the element of the faces, in a train of several elements

    def key(self, kind: str) -> str:
        """Key of a loss at the faces in the light account."""
        return key_of(kind, self.element)

    def spline(self, name: str, net: ControlNet, outline: Outline, level: float) -> BSplineSurface:
        """A B-spline on a net, about a level."""
        how = self.dtype, self.device, self.subdivisions
        return BSplineSurface(name, net, self.datum, *how, outline, level)


def steps_of(scene: Scene, along: PathContext) -> tuple[FaceStep, ...]:
    """Faces of all elements of a scene, in the order in which light meets them."""
    steps: list[FaceStep] = []
    source, ways = frame_of(scene.first, 0.0), scene.ways
    for number, (element, way) in enumerate(zip(scene.elements, ways, strict=True)):
        if number or not element.designed:  # light comes through an aperture, or other faces
            along = along._replace(by_area=False, along_axis=False)
        lit = element.lit(scene.source.wavelength)
        nets = {face: along.nets.get(face, net) for face, net in freeform_nets(lit).items()}
        name = element.name if len(scene.elements) > 1 else ""
        own, frame = along._replace(nets=nets, element=name), None
        if not frame_of(lit, 0.0).seen_from(source).is_identity:
            # Fixed faces count z from their own element: where the source does is far from them.
            own = own if element.designed else own._replace(datum=lit.position[2])
            frame = frame_of(lit, own.datum)
        for step in _FACES[type(lit)](lit, own):
            steps.append(step._replace(frame=frame).facing(way))
    return tuple(steps)


def _of_lens(lens: Lens, along: PathContext) -> Iterator[FaceStep]:
    outline, straight = outline_of(lens), along.along_axis
    before = Rectangle(lens.half_width) if along.by_area else outline
    kinds = ("fresnel_entrance", "missed_lens"), ("fresnel_exit", "left_side")
    inside = along.key("total_reflection"), along.key("absorbed")
    media = zip(laws_of(lens), (0.0, lens.absorption), kinds, strict=True)
    for placed, (law, absorption, (reflected, missed)) in zip(
        lens.placed_faces, media, strict=True
    ):
        net = along.nets.get(placed.name)
        if net is None:
            surface = _fixed(placed, placed.z - along.datum, before)
        else:
            surface = along.spline(placed.name, net, before if straight else outline, placed.z)
            straight = False
        refraction = Refraction(law, along.key(reflected), absorption, *inside)
        yield FaceStep(surface, refraction, along.key(missed))


def _fixed(placed: PlacedFace, z: float, outline: Outline) -> Surface:
    return fixed_surface(placed.face.undesigned, placed.name, z, outline)


def _of_mirror(mirror: Mirror, along: PathContext) -> tuple[FaceStep, ...]:
    (placed,), outline = mirror.placed_faces, outline_of(mirror)
    whole, net = Rectangle(mirror.half_width), along.nets.get(placed.name)
    if net is not None:
        lit = whole if along.by_area and along.along_axis else outline
        face: Surface = along.spline(placed.name, net, lit, placed.z)
    else:
        face = _fixed(placed, placed.z - along.datum, whole if along.by_area else outline)
    reflection = Reflection(mirror.reflectance, along.key("absorbed_mirror"))
    return (FaceStep(face, reflection, along.key("missed_mirror")),)


def _of_diffuser(diffuser: Diffuser, along: PathContext) -> tuple[FaceStep, ...]:
    """Where it takes light; what scattering does to the image is done to the image."""
    (placed,), outline = diffuser.placed_faces, outline_of(diffuser)
    law = TransmittanceLaw.constant(1.0, 1 - diffuser.transmittance)
    plane = _fixed(placed, placed.z - along.datum, outline)
    interface = Refraction(law, along.key("absorbed_diffuser"), total=None)
    return (FaceStep(plane, interface, along.key("missed_diffuser")),)


_FACES: Mapping[type, Callable[[Any, PathContext], Iterable[FaceStep]]] = {
    Lens: _of_lens,
    Mirror: _of_mirror,
    Diffuser: _of_diffuser,
}
