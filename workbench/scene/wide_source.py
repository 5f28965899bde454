"""What sources have in common that are of some size about a middle."""

from typing import TYPE_CHECKING, Self

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

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """Where its middle is on the axis."""
        return self.position[0] == 0, self.position[1] == 0

    @property
    def sharp(self) -> PointSource:
        """Its middle."""
        return PointSource(
            kind="point",
            position=self.position,
            emission=self.emission,
            **self.colour,
        )

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
