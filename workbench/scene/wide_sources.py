"""Sources of some size: grids of points and area emitters."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.levels import EXPERT, full_size
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.fields import LENGTH, PLACE, Measure, about
from workbench.scene.part import NonNegative, Positive
from workbench.scene.points import Emission, LightOfPoints, PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.source import MOST_RAYS, PlacedSource, Rays, disc, in_front
from workbench.scene.turning import Place

if TYPE_CHECKING:
    from workbench.scene.points import Emission
    from workbench.scene.task import Scene


class WideSource(PlacedSource):
    """A source that covers a place of some size, at one z."""

    if TYPE_CHECKING:  # each kind has these fields, at their places in the file
        half_width: tuple[float, float]
        emission: Emission

    def places(self, x: Array, y: Array) -> Array:
        """Places (..., 3) at distances from its middle along its own x and y, which broadcast."""
        aside = np.stack(np.broadcast_arrays(x, y, 0.0), axis=-1)
        return np.asarray((aside if self.turn is None else aside @ self.turn.T) + self.position)

    @property
    def nearest_z(self) -> float:
        """Where its rim comes closest to the lens; see `AnySource.nearest_z`."""
        rise = 0.0 if self.turn is None else float(np.abs(self.turn[2, :2]) @ self.half_width)
        return self.position[2] + rise

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where its middle is on the axis, and it is turned about an axis across it."""
        turn = np.eye(3) if self.turn is None else self.turn
        x, y = (
            self.position[axis] == 0 and not np.delete(turn[axis], axis).any() for axis in (0, 1)
        )
        return x, y

    @property
    def sharp(self) -> PointSource:
        """Its middle."""
        point = PointSource(
            kind="point",
            position=self.position,
            emission=self.emission,
            **self.colour,
        )
        return point if self.turn is None else point.standing(None, self.turn)

    def blur(self, optic: Element, receiver: AnyReceiver) -> tuple[float, float]:
        """Its angles as seen from the lens, times how far they move light."""
        way = optic.front_z - self.position[2]
        moved_x, moved_y = receiver.per_radian(optic.leaving_z)
        return 2 * self.half_width[0] * moved_x / way, 2 * self.half_width[1] * moved_y / way

    def check_before(self, optic: Element) -> None:
        """Refuse an element that is too small beside it."""
        extent = [(f"source.half_width[{axis}]", r) for axis, r in enumerate(self.half_width)]
        limits.check_lengths(extent, optic.half_width, limits.FARTHEST)
        super().check_before(optic)

    def shrunk(self, factor: float) -> Self:
        """A source of another size about the same middle."""
        x, y = self.half_width
        return self.model_copy(update={"half_width": (factor * x, factor * y)})


PointCount = Annotated[int, Field(ge=1, le=512)]


class GridSource(WideSource, LightOfPoints):
    """Many points of equal intensity, standing for a source of some size.

    Each emits into a cone of its own that just covers the entrance face, so its part of the flux
    goes with what that cone takes of its light.
    """

    model_config = ConfigDict(title="Grid of points")

    kind: Literal["grid"]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about(
            "Position",
            "The middle of the grid: x, y and z. All points have the same z, before the entrance "
            "face.",
        ),
    ]
    half_width: Annotated[
        tuple[NonNegative, NonNegative],
        LENGTH,
        full_size(
            "Full width and height of the grid. No detail of the image can be sharper than the "
            "image that the lens makes of this."
        ),
        about(
            "Half width",
            "Half of the grid's extent along x and y. No detail of the image can be sharper than "
            "the image that the lens makes of this.",
        ),
    ]
    points: Annotated[
        tuple[PointCount, PointCount],
        EXPERT,
        about(
            "Points",
            "Points along x and y, the outer ones on the rim. More of them come closer to an "
            "evenly bright source.",
        ),
    ]
    rays: Annotated[
        int,
        EXPERT,
        about(
            "Rays per point",
            "Rays from each point of the grid, for the paper's method and derivative maps. What "
            "they add up to makes the image smooth; few from each of many points are enough. "
            "Automatic chooses its own.",
            ge=1,
            le=MOST_RAYS,
        ),
    ] = 1000

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is, half as wide as the lens."""
        x, y = scene.optic.half_width
        place = scene.source.place or in_front(scene.optic)
        return {"position": place, "half_width": (x / 2, y / 2), "points": (25, 25)}

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return self.rays * math.prod(self.points)

    @property
    def axes(self) -> tuple[Array, Array] | None:
        """The x of its columns, shape (m_x,), and the y of its rows of points, shape (m_y,).

        None where it is turned.
        """
        if self.turn is not None:
            return None
        x, y = (middle + aside for middle, aside in zip(self.position, self._aside, strict=False))
        return x, y

    @property
    def _aside(self) -> tuple[Array, Array]:
        """How far columns and rows are from the middle."""
        x, y = (
            np.linspace(-r, r, count) if count > 1 else np.zeros(1)
            for r, count in zip(self.half_width, self.points, strict=True)
        )
        return x, y

    @property
    def positions(self) -> Array:
        """Where its points are, shape (m_x m_y, 3): y runs first."""
        x, y = self._aside
        return self.places(x[:, None], y).reshape(-1, 3)

    def blur(self, optic: Element, receiver: AnyReceiver) -> tuple[float, float]:
        """Its angles as seen from the lens, times how far they move light."""
        widths = super().blur(optic, receiver)
        x, y = (w if count > 1 else 0.0 for w, count in zip(widths, self.points, strict=True))
        return x, y

    @property
    def blur_points(self) -> tuple[int, int]:
        """Its points."""
        return self.points

    def remarks(self) -> Mapping[str, str]:
        """All its rays."""
        return {"rays": f"= {self.ray_count:,} in all"}

    def check_before(self, optic: Element) -> None:
        """Refuse a lens as a single point does; refuse more rays than there is memory for."""
        if self.ray_count > MOST_RAYS:
            raise Refused(
                "source.rays",
                Message(
                    "{rays} from each of {points} points are too many; at most {most} rays in all",
                    rays=self.rays,
                    points=math.prod(self.points),
                    most=MOST_RAYS,
                ),
            )
        super().check_before(optic)

    def seen(self, most: tuple[int, int]) -> Array:
        """Points spread over the same extent; see `AnySource.seen`."""
        x, y = (min(pair) for pair in zip(self.points, most, strict=True))
        return self.model_copy(update={"points": (x, y)}).positions

    @property
    def corners(self) -> Array:
        """Its outermost points, shape (n, 3); none where there is nothing to widen."""
        return self.seen((2, 2)) if max(self.points) > 1 else np.zeros((0, 3))

    def widened(self, corner: Array, digits: int) -> Self:
        """A grid about the same middle with a corner at a place; see `AnySource.widened`."""
        wide = (np.round(np.abs(corner - self.position), digits) + 0.0).tolist()  # without -0
        # Along an axis with a single point there is nothing to widen.
        axes = zip(wide, self.half_width, self.points, strict=False)
        return self.model_copy(
            update={"half_width": tuple(new if count > 1 else old for new, old, count in axes)}
        )


class AreaSource(WideSource):
    """A flat emitter that faces the lens; it shines into the whole half-space before it.

    What misses the entrance face misses the lens.
    """

    model_config = ConfigDict(title="Area emitter")
    kind: Literal["area"]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "The middle of the emitter: x, y and z, before the entrance face."),
    ]
    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        full_size("Full width and height of the emitter."),
        about("Half width", "Half of the emitter's extent along x and y."),
    ]
    outline: Annotated[
        Literal["rectangle", "ellipse"],
        EXPERT,
        about(
            "Outline", "The shape of its face: the rectangle of its size, or the ellipse within."
        ),
    ] = "rectangle"
    emission: Emission = "lambertian"
    flux: Annotated[
        Positive | None,
        Measure("lm", "lumen"),
        about(
            "Luminous flux",
            "All light that the emitter gives. With it, light on a screen is given in lux and "
            "lumen; left empty, in parts of all light. The lens does not depend on it.",
            le=1e9,
        ),
    ] = None
    rays: Rays = 500_000

    @property
    def lumens(self) -> float | None:
        """As it says."""
        return self.flux

    @property
    def of_any_flux(self) -> Self:
        """The same emitter, whatever flux it has."""
        return self if self.flux is None else self.model_copy(update={"flux": None})

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is, a tenth as wide as the lens."""
        x, y = scene.optic.half_width
        place = scene.source.place or in_front(scene.optic)
        return {"position": place, "half_width": (x / 10, y / 10)}

    @property
    def continuous(self) -> bool:
        """Always."""
        return True

    @property
    def blur_shape(self) -> Literal["rectangle", "ellipse"]:
        """Its outline."""
        return self.outline

    def seen(self, most: tuple[int, int]) -> Array:
        """Points over its face; see `AnySource.seen`."""
        x, y = (np.linspace(-r, r, count) for r, count in zip(self.half_width, most, strict=True))
        places = self.places(x[:, None], y)
        if self.outline == "ellipse" and min(most) > 2:
            r_x, r_y = self.half_width
            return np.asarray(places[(x[:, None] / r_x) ** 2 + (y / r_y) ** 2 <= 1 + 1e-9])
        return places.reshape(-1, 3)

    def face(self, optic: Element, z: float) -> Array:
        """Its own; see `AnySource.face`."""
        if self.outline == "rectangle":
            return self.corners.reshape(2, 2, 3)
        return np.asarray(self.position + disc() * (*self.half_width, 0.0))

    @property
    def corners(self) -> Array:
        """Corners of the rectangle around it, shape (4, 3)."""
        return self.seen((2, 2))

    def widened(self, corner: Array, digits: int) -> Self:
        """An emitter about the same middle with a corner at a place; see `AnySource.widened`."""
        wide = np.round(np.abs(corner - self.position), digits).tolist()
        new = tuple(a or b for a, b in zip(wide, self.half_width, strict=False))
        return self.model_copy(update={"half_width": new})
