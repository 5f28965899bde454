"""What sources have in common that are of some size about a middle."""

from typing import TYPE_CHECKING, Self

import numpy as np

from workbench.arrays import Array
from workbench.scene import limits
from workbench.scene.element import Element, Place
from workbench.scene.points import AnySource, PointSource
from workbench.scene.receiver import AnyReceiver

if TYPE_CHECKING:
    from workbench.scene.emission import Emission


class WideSource(AnySource):
    """A source that covers a place of some size, at one z."""

    if TYPE_CHECKING:  # each kind has these fields, at their places in the file
        position: Place
        half_width: tuple[float, float]
        emission: Emission

    @property
    def place(self) -> Place:
        """Its middle."""
        return self.position

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
        """Refuse an optic that is too small beside it."""
        extent = [(f"source.half_width[{axis}]", r) for axis, r in enumerate(self.half_width)]
        limits.check_lengths(extent, optic.half_width, limits.FARTHEST)
        super().check_before(optic)

    def placed(self, place: Place) -> Self:
        """The same source with its middle elsewhere."""
        return self.model_copy(update={"position": place})

    def shrunk(self, factor: float) -> Self:
        """A source of another size about the same middle."""
        x, y = self.half_width
        return self.model_copy(update={"half_width": (factor * x, factor * y)})
