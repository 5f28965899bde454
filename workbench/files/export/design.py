"""Input of exporters, and the deviation of a written file from the design."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from workbench import units
from workbench.arrays import Array
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files.export.options import MILLIMETRES, Cutting, Tile
from workbench.geometry.outlines import Outline, outline_of
from workbench.geometry.surface import ControlNet, GridBasis, freeform_nets
from workbench.messages import Message
from workbench.option_groups import OptionGroup
from workbench.progress import Progress, no_progress
from workbench.scene import Element, Scene

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan

Group = TypeVar("Group", bound=OptionGroup)
METRES = {unit: float(metres) for unit, metres in units.METRES.items()}
"""Units of length in metres."""

# Default chord error over the larger half-width.
_FINE = 1e-4
# Least number of steps of a lattice, and of each knot span: with one step a span, splines through
# the points of a flame on 416 × 416 control points have slope errors of 1° at the rim.
_STEPS, _IN_SPAN = 256, 2
_ROUNDING = 1e-9  # relative, of a tile as large as the element


@dataclass(frozen=True, eq=False)
class Design:
    """A design, seen at one freeform face of one designed element."""

    scene: Scene
    result: Result
    # Largest distance of a mesh from the freeform faces, scene units; 1e-4 of the larger half-width
    # by default.
    chord_error: float | None = None
    # Face of ``net`` and ``heights``, by its id; by default the last one of `Scene.optic`.
    face: str | None = None
    options: tuple[OptionGroup, ...] = ()  # stated groups of options of formats
    mesh_unit: str = MILLIMETRES  # unit of lengths in meshes; glTF has metres
    verified: str | None = None  # error by the independent check, for users
    plan: "CutPlan | None" = None  # a finished plan of the cuts
    progress: Progress = no_progress  # called with the finished fraction of a slow file

    @property
    def unit(self) -> str:
        """The scene's unit of length."""
        return self.scene.unit

    @property
    def metres(self) -> float:
        """The scene's unit in metres."""
        return METRES[self.unit]

    @property
    def in_mesh_unit(self) -> float:
        """The scene's unit in the unit of meshes."""
        return float(units.ratio(self.unit, self.mesh_unit))

    @property
    def optic(self) -> Element:
        """The element of the face."""
        return self.scene.optic if self.face is None else self.scene.focused_on(self.face).optic

    def chosen(self, group: type[Group]) -> Group:
        """Return the stated options of a group, or their defaults."""
        return next((each for each in self.options if isinstance(each, group)), group())

    @property
    def cutting(self) -> Cutting:
        """Options of G-code."""
        return self.chosen(Cutting)

    @property
    def tile(self) -> tuple[float, float, float] | None:
        """Side, and x and y of the middle, of a square on a flat back; None for the whole part."""
        tile = self.chosen(Tile)
        return None if tile.tile_side is None else (tile.tile_side, tile.tile_x, tile.tile_y)

    @property
    def material(self) -> str:
        """Material of the element, or its refractive index."""
        material = getattr(self.optic, "material", "any, with a reflecting face")
        return material if isinstance(material, str) else f"n = {self.optic.index:.6g}"

    @property
    def heights(self) -> Array:
        """Control heights of the face, shape (n_u, n_v)."""
        return self.result.state.heights[self.face or self.optic.designed_face]

    @cached_property
    def net(self) -> ControlNet:
        """Control net of the face."""
        return freeform_nets(self.optic)[self.face or self.optic.designed_face]

    def at_front(self, front: bool) -> "Design":
        """The lens seen at its freeform front face, or at its last face."""
        optic = self.optic
        return replace(self, face=optic.designed_front if front else optic.designed_face)

    def of(self, element: Element) -> "Design":
        """The design seen at the last face of another designed element."""
        return replace(self, face=element.designed_face)

    @cached_property
    def faces(self) -> tuple["Design", ...]:
        """The element seen at each of its freeform faces, the entrance face last; one of a tile."""
        if self.tile is not None:
            return (self,)
        names = reversed(freeform_nets(self.optic))
        return tuple(replace(self, face=name) for name in names)

    @cached_property
    def outline(self) -> Outline:
        """Outline of the element."""
        return outline_of(self.optic)

    @property
    def outward(self) -> int:
        """1 if normals of the face that point out of the body point to +z, -1 if to -z."""
        return self.optic.outwards(self.face or self.optic.designed_face)

    @property
    def flat_z(self) -> float:
        """Z of the flat side of the solid part, scene units."""
        return self.optic.flat_z(self.heights)

    @property
    def rectangle(self) -> tuple[Array, Array] | None:
        """Least and largest x and y of a rectangular part, scene units; None for an ellipse.

        Raise Refused if a tile is not within the outline.
        """
        half_width = np.array(self.optic.half_width)
        if self.tile is None:
            return (-half_width, half_width) if self.outline.whole else None
        side, x, y = self.tile
        middle, half = np.array([x, y]), side / 2
        if not self.outline.contains(*(abs(middle) + half) / (1 + _ROUNDING)):
            raise Refused(
                "tile_side",
                Message(
                    "{side:g} {unit} about ({x:g}, {y:g}) is not within the {optic}",
                    side=side,
                    x=x,
                    y=y,
                    unit=self.unit,
                    optic=self.optic.called,
                ),
            )
        return np.maximum(middle - half, -half_width), np.minimum(middle + half, half_width)

    def check_flat_side(self) -> None:
        """Refuse a conic front face before the designed one, which solids do not have yet."""
        optic, front = self.optic, self.optic.placed_faces[0]
        if (
            self.tile is None
            and len(optic.placed_faces) > 1
            and not (front.face.designed or front.face.flat)
        ):
            raise Refused(
                self.scene.face_path(front.name),
                Message("a conic front face of the designed element is not exported; a plane one"),
            )

    @property
    def largest_chord_error(self) -> float:
        """Largest distance of a mesh from the freeform faces, scene units."""
        if self.chord_error is not None:
            return self.chord_error
        return _FINE * max(self.optic.half_width)

    def basis(self, x: Array, y: Array) -> GridBasis[Array]:
        """Basis values of the face on the grid of x (m_x,) and y (m_y,), scene units.

        Beyond the edge the polynomials at the rim continue.
        """
        r_x, r_y = self.optic.half_width
        return self.net.grid((x / r_x + 1) / 2, (y / r_y + 1) / 2)

    def surface(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height and slopes dz/dx, dz/dy on such a grid, each of shape (m_x, m_y)."""
        return self.basis(x, y).evaluate(self.heights)

    def lattice(self, margin: int = 0) -> tuple[Array, Array]:
        """Return x (m_x,) and y (m_y,) in equal steps that include the rim and all knots.

        ``margin`` steps are added beyond the rim; scene units.
        """
        x, y = (
            _steps(n - p, r, margin)
            for n, p, r in zip(self.net.shape, self.net.degree, self.net.half_width, strict=True)
        )
        return x, y


class Deviation(NamedTuple):
    """Measured deviation of a file from the design: kind, size, unit, and a note for users."""

    kind: str
    size: float
    unit: str
    note: str = ""


def _steps(spans: int, half_width: float, margin: int) -> Array:
    steps = spans * max(_IN_SPAN, math.ceil(_STEPS / spans))
    return np.asarray((2 * np.arange(-margin, steps + margin + 1) - steps) * (half_width / steps))
