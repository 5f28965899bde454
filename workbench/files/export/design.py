"""What exporters start from, and what they say of the file that they wrote."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from workbench import units
from workbench.arrays import Array
from workbench.design.snapshot import Result
from workbench.files.export.cutting import PLAIN, Cutting
from workbench.files.export.mesh_unit import MILLIMETRES
from workbench.geometry.outlines import Outline, outline_of
from workbench.geometry.surface import ControlNet, GridBasis, freeform_nets
from workbench.scene import Scene
from workbench.watch import Watch, unwatched

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan

METRES = {unit: float(metres) for unit, metres in units.METRES.items()}
"""Length of each of the scene's units."""

# Default of the chord error over the larger half-width of the lens.
_FINE = 1e-4
# Least number of steps of a lattice, and of each span between knots: with one in a span, splines
# through the points of a flame on 416 × 416 control points lean by 1° at the rim where it does not.
_STEPS, _IN_SPAN = 256, 2


@dataclass(frozen=True, eq=False)
class Design:
    """A lens that has been designed, seen at one of its freeform faces.

    Attributes
    ----------
    scene : Scene
        The design task.
    result : Result
        The lens found for it.
    chord_error : float, optional
        How far a mesh may be from the freeform faces, scene units; 1e-4 of the larger half-width
        by default.
    face : str, optional
        Name of the face that ``net`` and ``heights`` are of: "entrance" or, by default, the face
        that every task shapes.
    cutting : Cutting
        How it is cut, where that is asked for.
    mesh_unit : str
        Unit of lengths in meshes; glTF has metres.
    plan : CutPlan, optional
        The cuts, where they have been planned before.
    watch : callable
        Is told which part of a file is done, where it takes long.
    """

    scene: Scene
    result: Result
    chord_error: float | None = None
    face: str | None = None
    cutting: Cutting = PLAIN
    mesh_unit: str = MILLIMETRES
    plan: "CutPlan | None" = None
    watch: Watch = unwatched

    @property
    def unit(self) -> str:
        """The scene's unit of length."""
        return self.scene.unit

    @property
    def metres(self) -> float:
        """Length of the scene's unit."""
        return METRES[self.unit]

    @property
    def in_mesh_unit(self) -> float:
        """The scene's unit in the unit of meshes."""
        return float(units.ratio(self.unit, self.mesh_unit))

    @property
    def heights(self) -> Array:
        """Control heights of the face, shape (n_u, n_v)."""
        return self.result.state.heights[self.face or self.scene.optic.designed_face]

    @cached_property
    def net(self) -> ControlNet:
        """Control net of the face."""
        return freeform_nets(self.scene.optic)[self.face or self.scene.optic.designed_face]

    @cached_property
    def faces(self) -> tuple["Design", ...]:
        """The lens seen at each of its freeform faces; last the entrance face, if it is one."""
        names = reversed(freeform_nets(self.scene.optic))
        return tuple(replace(self, face=name) for name in names)

    @cached_property
    def outline(self) -> Outline:
        """What of the aperture is glass."""
        return outline_of(self.scene.optic)

    @property
    def outward(self) -> int:
        """1 if normals of the face that point out of the body point to +z, -1 if to -z."""
        return self.scene.optic.outwards(self.face or self.scene.optic.designed_face)

    @property
    def flat_z(self) -> float:
        """Where the flat side of the solid part is, scene units."""
        return self.scene.optic.flat_z(self.heights)

    @property
    def largest_chord_error(self) -> float:
        """How far a mesh may be from the freeform faces, scene units."""
        if self.chord_error is not None:
            return self.chord_error
        return _FINE * max(self.scene.optic.half_width)

    def basis(self, x: Array, y: Array) -> GridBasis[Array]:
        """Basis values of the face on the grid of x (m_x,) and y (m_y,), scene units.

        Beyond the edge the face goes on smoothly, as the polynomials at its rim do.
        """
        r_x, r_y = self.scene.optic.half_width
        return self.net.grid((x / r_x + 1) / 2, (y / r_y + 1) / 2)

    def surface(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height and slopes dz/dx, dz/dy on such a grid, each of shape (m_x, m_y)."""
        return self.basis(x, y).evaluate(self.heights)

    def lattice(self, margin: int = 0) -> tuple[Array, Array]:
        """Equal steps across the aperture that include its rim and all knots.

        Parameters
        ----------
        margin : int
            Steps that are added beyond the rim.

        Returns
        -------
        x : ndarray, shape (m_x,)
        y : ndarray, shape (m_y,)
            Scene units.
        """
        x, y = (
            _steps(n - p, r, margin)
            for n, p, r in zip(self.net.shape, self.net.degree, self.net.half_width, strict=True)
        )
        return x, y


class Deviation(NamedTuple):
    """How far what stands in a file is from the design, measured.

    Attributes
    ----------
    kind : str
        What has been measured.
    size : float
        The largest found.
    unit : str
        Unit of ``size``.
    note : str
        What who reads the file has to know besides.
    """

    kind: str
    size: float
    unit: str
    note: str = ""


def _steps(spans: int, half_width: float, margin: int) -> Array:
    steps = spans * max(_IN_SPAN, math.ceil(_STEPS / spans))
    return np.asarray((2 * np.arange(-margin, steps + margin + 1) - steps) * (half_width / steps))
