"""The face that light meets first: flat, or a B-spline of its own."""

from typing import Annotated, ClassVar, Literal

from pydantic import ConfigDict

from workbench.errors import Refused
from workbench.said import Said
from workbench.scene.auto_net import AutoNet, NumbersOrAuto
from workbench.scene.fields import LENGTH, RANGE, about
from workbench.scene.kinds import Kinds
from workbench.scene.net import Degree, NetShape, NetSize, check_net
from workbench.scene.part import Part


class FlatEntrance(Part):
    """A plane across the axis."""

    model_config = ConfigDict(title="Flat")

    shape: Literal["flat"] = "flat"
    height_range: ClassVar = None

    def net(self, exit_shape: NetShape) -> None:
        """No control points."""

    def offsets(self, room: float) -> tuple[float, float]:
        """It is where it stands; see `FreeformEntrance.offsets`."""
        return 0.0, 0.0

    def within(self, offsets: tuple[float, float]) -> "FlatEntrance":
        """The same: it has no range."""
        return self

    def check_within(self, exit_shape: NetShape | None) -> None:
        """Refuse nothing: it suits any lens."""

    def lengths(self) -> list[tuple[str, float]]:
        """None that could be too long."""
        return []


class FreeformEntrance(Part):
    """A second B-spline face, which is designed together with the exit face."""

    model_config = ConfigDict(title="Freeform")

    since: ClassVar = 2

    shape: Literal["freeform"] = "freeform"
    degree: Annotated[
        tuple[Degree, Degree],
        about("Entrance degree", "Polynomial degree of the entrance face along x and y."),
    ] = (3, 3)
    control_points: Annotated[
        tuple[NetSize, NetSize] | AutoNet,
        NumbersOrAuto(),
        about(
            "Entrance control points",
            "Number of control points of the entrance face along x and y. Automatic takes as many "
            "as the exit face has.",
        ),
    ] = AutoNet()
    height_range: Annotated[
        tuple[float, float] | None,
        LENGTH,
        RANGE,
        about(
            "Entrance range",
            "How far the entrance face may be from its place on the axis, towards the source and "
            "away from it. Automatic leaves it room behind that place, as glass and source allow.",
        ),
    ] = None

    def net(self, exit_shape: NetShape) -> tuple[NetShape, tuple[int, int]]:
        """Numbers of control points and degrees, beside an exit face with so many points."""
        points = self.control_points
        return exit_shape if isinstance(points, AutoNet) else points, self.degree

    def offsets(self, room: float) -> tuple[float, float]:
        """How far the face may be from its place, down and up; automatic leaves it ``room``."""
        return (0.0, room) if self.height_range is None else self.height_range

    def within(self, offsets: tuple[float, float]) -> "FreeformEntrance":
        """The same with this range."""
        return self.model_copy(update={"height_range": offsets})

    def check_within(self, exit_shape: NetShape | None) -> None:
        """Refuse a net that cannot be, and a range that leaves a control point nowhere to be."""
        automatic = isinstance(self.control_points, AutoNet)
        shape = exit_shape if automatic else self.control_points
        if shape is not None and not isinstance(shape, AutoNet):
            check_net("lens.entrance.control_points", shape, self.degree)
        if self.height_range is not None:
            low, high = self.height_range
            if not low < high:
                raise Refused(
                    "lens.entrance.height_range",
                    Said("[{low:g}, {high:g}] is empty; low before high", low=low, high=high),
                )

    def lengths(self) -> list[tuple[str, float]]:
        """Paths and values of lengths that could be too long."""
        path = "entrance.height_range"
        return [(f"{path}[{end}]", z) for end, z in enumerate(self.height_range or ())]


Entrance = Annotated[FlatEntrance | FreeformEntrance, Kinds("shape", default="flat")]
