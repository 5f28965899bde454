"""A grid of points that stands for an extended source."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.element import Element, Place
from workbench.scene.fields import LENGTH, PLACE, about
from workbench.scene.part import NonNegative
from workbench.scene.points import MOST_RAYS, LightOfPoints, in_front
from workbench.scene.receiver import AnyReceiver
from workbench.scene.wide_source import WideSource

if TYPE_CHECKING:
    from workbench.scene.task import Scene

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
        about(
            "Half width",
            "Half of the grid's extent along x and y. No detail of the image can be sharper than "
            "the image that the lens makes of this.",
        ),
    ]
    points: Annotated[
        tuple[PointCount, PointCount],
        about(
            "Points",
            "Points along x and y, the outer ones on the rim. More of them come closer to an "
            "evenly bright source.",
        ),
    ]
    rays: Annotated[
        int,
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
