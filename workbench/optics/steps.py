"""Faces on the way of the light: which ones an optic has.

A new kind of optic is its fields in `workbench.scene`, and a row in ``_STEPS``.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import torch

from workbench.arrays import Array
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline, Rectangle, outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.interfaces import Interface, Reflection, Refraction
from workbench.optics.surfaces import BSplineSurface, Plane, Surface
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import Element, Lens, Mirror


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


def steps_of(optic: Element, along: PathContext) -> tuple[FaceStep, ...]:
    """Faces of an optic, in the order in which light meets them."""
    return _STEPS[type(optic)](optic, along)


def _of_lens(lens: Lens, along: PathContext) -> tuple[FaceStep, ...]:
    outline, entrance_net = outline_of(lens), freeform_nets(lens).get("entrance")
    entering, leaving = TransmittanceLaw.of(lens)
    before = Rectangle(lens.half_width) if along.by_area else outline
    straight = along.along_axis and entrance_net is None  # up to the exit face
    entrance: Surface = Plane("entrance", lens.entrance_z - along.datum, before)
    if entrance_net is not None:
        at_face = before if along.along_axis else outline
        entrance = along.spline("entrance", entrance_net, at_face, lens.entrance_z)
    exit_face = along.spline("exit", along.net, before if straight else outline, lens.base.height)
    return (
        FaceStep(entrance, Refraction(entering, "fresnel_entrance"), "missed_lens"),
        FaceStep(exit_face, Refraction(leaving, "fresnel_exit", lens.absorption), "left_side"),
    )


def _of_mirror(mirror: Mirror, along: PathContext) -> tuple[FaceStep, ...]:
    whole = along.by_area and along.along_axis
    outline = Rectangle(mirror.half_width) if whole else outline_of(mirror)
    face = along.spline("mirror", along.net, outline, mirror.base.height)
    return (FaceStep(face, Reflection(mirror.reflectance, "absorbed_mirror"), "missed_mirror"),)


_STEPS: Mapping[type, Callable[[Any, PathContext], tuple[FaceStep, ...]]] = {
    Lens: _of_lens,
    Mirror: _of_mirror,
}
