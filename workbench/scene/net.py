"""Control nets as scenes tell them: how many control points there are, and of which degree."""

from typing import Annotated

from pydantic import Field

from workbench.errors import Refused
from workbench.said import Said
from workbench.scene.auto_net import AutoNet, NumbersOrAuto
from workbench.scene.fields import about

Degree = Annotated[int, Field(ge=1, le=7)]
LARGEST_NET = 1024
"""Control points along an axis, at most."""
NetSize = Annotated[int, Field(ge=2, le=LARGEST_NET)]
NetShape = tuple[NetSize, NetSize]
ControlPoints = Annotated[
    NetShape | AutoNet,
    NumbersOrAuto(),
    about(
        "Control points",
        "Number of control points along x and y. More of them draw finer detail and take "
        "longer. Automatic takes what the target's detail, the screen's pixels and the size of "
        "the source are worth; the paper's method then has nets like those of the paper.",
    ),
]
"""How many control points the net of a face has."""


def check_net(path: str, shape: tuple[int, int], degree: tuple[int, int]) -> None:
    """Refuse a net with fewer control points than its degrees need.

    Raises
    ------
    Refused
        With the number, and the least.
    """
    for axis, count in enumerate(shape):
        if count < degree[axis] + 1:
            raise Refused(
                f"{path}[{axis}]",
                Said(
                    "{count} is too few for degree {degree}; at least {least}",
                    count=count,
                    degree=degree[axis],
                    least=degree[axis] + 1,
                ),
            )
