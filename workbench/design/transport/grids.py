"""Cells of a lens and of a receiver, as many of both, on which faces are found."""

from collections.abc import Iterator
from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.face_light import FaceLight
from workbench.design.transport.faces import Faces
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

# Cells for each control point along an axis, at least.
PER_CONTROL_POINT = 1.62


class Grids(NamedTuple):
    """Cells of a lens and of a receiver, and what is known of their light."""

    view: ReceiverView  # of the receiver
    # (cells, cells), the light that is wanted in each cell of the view; all together 1.
    wanted: Array
    light: FaceLight  # light on the face
    faces: Faces  # finds faces
    limits: HeightLimits  # what the lens allows

    @classmethod
    def of(cls, scene: Scene, net: ControlNet, wanted: Array) -> Self:
        """The grids of a task, with as many cells as light is wanted in.

        `scene`: the design task; an extended source counts as a point at its centre; `net`: of the
        face, with fewer control points than cells along each axis; `wanted` (cells, cells).
        """
        cells = len(wanted)
        fit = SlopeFit(net, cells)
        light = FaceLight(scene, net, fit, cells)
        limits = HeightLimits.of(bounded(scene), net)
        faces = Faces(scene, light, fit, limits)
        return cls(ReceiverView.of(scene), wanted, light, faces, limits)

    def begin(self) -> tuple[Array, Array] | None:
        """Heights of a lens that light leaves, and its flux in each cell; None if there is none."""
        for heights in _candidates(self.limits):
            flux = self.light.flux(heights)
            if flux is not None:
                return heights, flux
        return None


def _candidates(limits: HeightLimits) -> Iterator[Array]:
    """Lenses that light may leave: the undesigned one; plates, that reflect none of it totally."""
    yield limits.undesigned
    yield np.full_like(limits.undesigned, limits.undesigned.mean())
    yield np.full_like(limits.undesigned, limits.lower.min())
