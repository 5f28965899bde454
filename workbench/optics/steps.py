"""Faces in the order in which light meets them: those of the elements of a train.

A new kind of element is its fields in `workbench.scene`, and a row in ``_FACES``; a new shape of
a fixed face is a case of `_fixed`.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import torch

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline, Rectangle, outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.interfaces import Interface, Reflection, Refraction
from workbench.optics.surfaces import BSplineSurface, Conic, Plane, Surface
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import ConicFace, Lens, Mirror, PlacedFace, PlaneFace, Scene


class FaceStep(NamedTuple):
    """A face on the way of the light.

    Attributes
    ----------
    surface : Surface
        Where rays meet it.
    interface : Interface
        What it does to them.
    missed : str
        Name in the light account of light that does not meet it.
    frame : Frame, optional
        Where the coordinates of the surface stand in the scene: light comes to the face along +z of
        them. None for those of the scene with z counted from the datum of the path.
    """

    surface: Surface
    interface: Interface
    missed: str
    frame: Frame | None = None

    def from_behind(self, datum: float = 0.0) -> "FaceStep":
        """The step for light that comes to the face along −z of its frame.

        Parameters
        ----------
        datum : float
            Of the path, for a step without a frame.
        """
        frame = standing(self.frame, datum).turned()
        return self._replace(surface=self.surface.from_behind(), frame=frame)

    def facing(self, place: Array) -> "FaceStep":
        """The step for light from a place of the scene, shape (3,); of a face with a frame."""
        if self.frame is None:
            raise ValueError("a step without a frame faces along +z of the scene")
        way = self.frame.position - place
        return self if way @ self.frame.rotation[:, 2] >= 0 else self.from_behind()


def standing(frame: Frame | None, datum: float) -> Frame:
    """The frame of a step; of one without, that of the scene with z counted from a datum."""
    return Frame(np.array([0.0, 0.0, datum]), np.eye(3)) if frame is None else frame


def changes_of(frames: Sequence[Frame | None], datum: float) -> list[Frame]:
    """Where the coordinates of each frame stand in those of the next one."""
    stand = [standing(frame, datum) for frame in frames]
    return [one.seen_from(other) for one, other in pairwise(stand)]


class PathContext(NamedTuple):
    """What is known of the light and of the trace before there are faces.

    Attributes
    ----------
    net : ControlNet
        Where control heights sit.
    datum : float
        z of the scene from which elements count z.
    by_area : bool
        Whether what is outside the outline is out of the flux before the first face.
    along_axis : bool
        Whether all rays go along +z.
    subdivisions : tuple[int, int], optional
        See `BSplineSurface`.
    dtype, device
        Float type and device of the walk.
    """

    net: ControlNet
    datum: float
    by_area: bool
    along_axis: bool
    subdivisions: tuple[int, int] | None
    dtype: torch.dtype
    device: torch.device | str

    def spline(self, name: str, net: ControlNet, outline: Outline, level: float) -> BSplineSurface:
        """A B-spline on a net, about a level."""
        how = self.dtype, self.device, self.subdivisions
        return BSplineSurface(name, net, self.datum, *how, outline, level)


def steps_of(scene: Scene, along: PathContext) -> tuple[FaceStep, ...]:
    """Faces of all elements of a scene, in the order in which light meets them."""
    steps: list[FaceStep] = []
    for number, element in enumerate(scene.elements):
        if number or scene.designed_number:  # light comes through an aperture, or other faces
            along = along._replace(by_area=False, along_axis=False)
        lit = element.lit(scene.source.wavelength)
        steps += _FACES[type(lit)](lit, along)
    return tuple(steps)


def _of_lens(lens: Lens, along: PathContext) -> Iterator[FaceStep]:
    upright = not any(lens.tilt) and not any(lens.position[:2])
    frame = None if upright else Frame.at(lens.position, lens.tilt)
    origin = along.datum if upright else lens.position[2]
    outline, straight = outline_of(lens), along.along_axis
    before = Rectangle(lens.half_width) if along.by_area else outline
    nets = freeform_nets(lens)
    if nets:
        nets |= {lens.designed_face: along.net}
    names = ("fresnel_entrance", "missed_lens"), ("fresnel_exit", "left_side")
    media = zip(TransmittanceLaw.of(lens), (0.0, lens.absorption), names, strict=True)
    for placed, (law, absorption, (reflected, missed)) in zip(
        lens.placed_faces, media, strict=True
    ):
        net = nets.get(placed.name)
        if net is None:
            surface = _fixed(placed, placed.z - origin, before)
        else:
            surface = along.spline(placed.name, net, before if straight else outline, placed.z)
            straight = False
        yield FaceStep(surface, Refraction(law, reflected, absorption), missed, frame)


def _fixed(placed: PlacedFace, z: float, outline: Outline) -> Surface:
    match placed.face:
        case PlaneFace():
            return Plane(placed.name, z, outline)
        case ConicFace(radius=radius, conic=conic, coefficients=coefficients):
            return Conic(placed.name, z, 1 / radius, conic, outline, coefficients)
    raise TypeError(f"a fixed face of shape {placed.face.shape} is not traced")


def _of_mirror(mirror: Mirror, along: PathContext) -> tuple[FaceStep, ...]:
    whole = along.by_area and along.along_axis
    outline = Rectangle(mirror.half_width) if whole else outline_of(mirror)
    face = along.spline(mirror.designed_face, along.net, outline, mirror.base.height)
    return (FaceStep(face, Reflection(mirror.reflectance, "absorbed_mirror"), "missed_mirror"),)


_FACES: Mapping[type, Callable[[Any, PathContext], Iterable[FaceStep]]] = {
    Lens: _of_lens,
    Mirror: _of_mirror,
}
