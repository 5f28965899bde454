"""What all optics have in common: one face that the task shapes, a B-spline over a base."""

import math
from abc import abstractmethod
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.said import Said
from workbench.scene import limits
from workbench.scene.auto_net import AutoNet
from workbench.scene.base import Base
from workbench.scene.entrance import Entrance
from workbench.scene.losses import Loss, TakesLight
from workbench.scene.net import check_net
from workbench.scene.part import Part


class Optic(Part):
    """What each kind of optic says of itself, so that nobody has to ask for its kind."""

    called: ClassVar[str]
    """What it is called within a sentence, and the scene's field that holds it."""
    face: ClassVar[str]
    """Name of the face that the task shapes, as heights have it."""
    most_faces: ClassVar[int]
    """How many of its faces can be freeform."""
    face_called: ClassVar[str]
    """What that face is called within a sentence."""
    body_called: ClassVar[str]
    """What a solid part of this kind is called within a sentence."""
    front_called: ClassVar[str]
    """What light meets first, within a sentence."""
    onwards: ClassVar[int]
    """1 if light goes on to +z behind it, -1 if it goes back to -z."""
    losses: ClassVar[Mapping[str, Loss]]
    """How light is lost at any of its kind, by the names that elements have for that."""

    if TYPE_CHECKING:  # each kind has these fields, at their places in the file
        half_width: tuple[float, float]
        outline: Literal["rectangle", "ellipse"]
        degree: tuple[int, int]
        control_points: tuple[int, int] | AutoNet
        base: Base
        height_range: tuple[float, float] | None

        @property
        def entrance(self) -> Entrance:
            """The face before the one that the task shapes; flat where there is none."""

    @property
    @abstractmethod
    def front_z(self) -> float:
        """The plane of the aperture: light that passes the outline there reaches the optic."""

    @property
    @abstractmethod
    def datum(self) -> float:
        """The z from which paths of slanted light count: near the faces."""

    @property
    @abstractmethod
    def entrance_range(self) -> tuple[float, float]:
        """The lowest and the highest z that the entrance face can come to."""

    @property
    @abstractmethod
    def entrance_offsets(self) -> tuple[float, float]:
        """The same from its place on the axis."""

    @property
    @abstractmethod
    def leaving_z(self) -> float:
        """About where light leaves it, as far as that is known before a design."""

    @property
    @abstractmethod
    def lowest(self) -> float:
        """The z that no point of it can be below: sources stand before that."""

    @property
    @abstractmethod
    def highest(self) -> float:
        """The z that no point of its face can be above, as far as it is known before a run."""

    @property
    def edge_z(self) -> float:
        """The z that its face cannot be beyond, on the side to which light goes."""
        return self.highest if self.onwards > 0 else self.lowest

    @property
    @abstractmethod
    def floor(self) -> float:
        """The z that its face is kept above whatever the height range is."""

    @property
    @abstractmethod
    def ceiling(self) -> float:
        """The z that its face is kept below whatever the height range is; infinite without one."""

    @property
    @abstractmethod
    def index(self) -> float:
        """Refractive index of what is before its face."""

    @property
    @abstractmethod
    def steepest(self) -> float:
        """Tangent of the largest angle to the axis at which light may come to its face, about."""

    @property
    @abstractmethod
    def least_thickness(self) -> float:
        """The least that the solid part may be thick, by itself."""

    @property
    @abstractmethod
    def deflection(self) -> float:
        """By how many radians a small slope of the face turns light, over the slope."""

    @property
    @abstractmethod
    def held_by(self) -> Literal["height_range", "max_thickness", "screen"]:
        """What keeps its face below, if no height range does."""

    @abstractmethod
    def bounded(
        self, source_z: float, receiver_z: float, several: bool = False, part: float = 1.0
    ) -> Self:
        """The optic with all that limits its heights.

        Parameters
        ----------
        source_z, receiver_z : float
            Where its source and its receiver are nearest to it; infinite if they are.
        several : bool
            Whether it makes several images.
        part : float
            Of the distance to the receiver, that the optic may rise where neither a height range
            nor a maximal thickness is given.
        """

    def ranged(self, low: float, high: float) -> Self:
        """The optic with another height range; nothing else of it moves."""
        return self.model_copy(update={"height_range": (low, high)})

    @abstractmethod
    def flat_z(self, heights: Array) -> float:
        """Where the flat side of the solid part is, if the face has these control heights."""

    def face_in_words(self, face: str) -> str:
        """What one of its freeform faces is called within a sentence."""
        return self.face_called if face == self.face else "entrance face"

    def outwards(self, face: str) -> int:
        """1 if one of its freeform faces is seen from +z, -1 if from -z."""
        return self.onwards if face == self.face else -1

    def place_of(self, face: str, x: npt.ArrayLike, y: npt.ArrayLike) -> Array:
        """Where one of its freeform faces stands before the design, z at (x, y)."""
        if face == self.face:
            return self.base.height_at(x, y)
        return np.full(np.broadcast(x, y).shape, self.datum)

    def range_of(self, face: str) -> tuple[float, float] | None:
        """How far one of its freeform faces may be from its place; None if nobody says so."""
        return self.height_range if face == self.face else self.entrance_offsets

    @property
    def net_shape(self) -> tuple[int, int]:
        """Numbers of control points along x and y: as given, or as the program has chosen.

        Raises
        ------
        Refused
            If it has yet to choose; a `Session`, which has a target, is a task where it has.
        """
        if self.known_shape is None:
            path = f"{self.called}.control_points"
            raise Refused(path, Said("'auto' needs a target to choose for; numbers"))
        return self.known_shape

    @property
    def known_shape(self) -> tuple[int, int] | None:
        """As `net_shape`; None where the program has yet to choose."""
        points = self.control_points
        return points.shape if isinstance(points, AutoNet) else points

    def with_net(self, shape: tuple[int, int] | None) -> Self:
        """The same for whose ``"auto"`` the program has chosen a net; None takes a choice back."""
        if not isinstance(self.control_points, AutoNet):
            return self
        return self.altered(control_points=AutoNet(shape))

    def limits_at(self, x: npt.ArrayLike, y: npt.ArrayLike) -> tuple[Array, Array]:
        """Lowest and highest z that control points at (x, y) may have; x and y broadcast.

        The highest is infinite where nothing says how high the face may rise.
        """
        low, high = self.height_range or (-math.inf, math.inf)
        base = self.base.height_at(x, y)
        return np.maximum(base + low, self.floor), np.minimum(base + high, self.ceiling)

    @classmethod
    def all_losses(cls) -> dict[str, Loss]:
        """Its losses, and those that its fields bring, by name."""
        losses = dict(cls.losses)
        for field in cls.fields():
            if mark := field.mark(TakesLight):
                losses[mark.name] = mark.loss
        return losses

    def check_face(self, heights: list[tuple[str, float]]) -> None:
        """Refuse a face that cannot be computed with.

        Parameters
        ----------
        heights : list of tuple[str, float]
            Names and values of further fields that are heights of the optic.
        """
        limits.check_width(self.called, self.half_width)
        own = [
            ("base.height", self.base.height),
            *((f"height_range[{end}]", z) for end, z in enumerate(self.height_range or ())),
        ]
        lengths = [(f"{self.called}.{name}", length) for name, length in (*heights, *own)]
        limits.check_lengths(lengths, self.half_width, limits.HEIGHT)
        if self.known_shape is not None:
            check_net(f"{self.called}.control_points", self.known_shape, self.degree)
        self.base.check_within(self.called, self.half_width)
        if self.height_range is not None:
            low, high = self.height_range
            if not low < high:
                raise Refused(
                    f"{self.called}.height_range",
                    Said("[{low:g}, {high:g}] is empty; low before high", low=low, high=high),
                )

    def net_remarks(self) -> dict[str, str]:
        """The control points that the program has chosen; see `Part.remarks`."""
        if isinstance(self.control_points, AutoNet) and self.control_points.shape is not None:
            return {"control_points": "{} × {}".format(*self.control_points.shape)}
        return {}


def relative(factor: float) -> Callable[[dict[str, Any]], float]:
    """Default length: a multiple of the larger half-width (0 where that was refused)."""
    return lambda data: factor * max(data.get("half_width", (0.0,)))
