"""What all manufacturing processes have in common, and what several of them leave together."""

import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

from workbench.errors import Refused, refused_within
from workbench.levels import EXPERT
from workbench.messages import Message
from workbench.scene.element import Element
from workbench.scene.fields import about
from workbench.scene.making.relief import RandomRelief, Relief
from workbench.scene.part import Part

Shrinkage = Annotated[
    float,
    EXPERT,
    about(
        "Shrinkage",
        "Part by which all lengths of the element become smaller and the mould or the print file "
        "does not make up for: 0.005 for 0.5 %.",
        ge=0,
        lt=0.1,
    ),
]


class BallCut(NamedTuple):
    """A cut with a ball cutter in parallel passes."""

    radius: float  # of the ball, scene units
    step_over: float  # seen along z, scene units


class Process(Part):
    """One step of manufacture: what it leaves of each designed face."""

    @property
    def ball_cut(self) -> BallCut | None:
        """The cut that it is, for programs of milling machines; None for other processes."""
        return None

    @property
    def smoothing(self) -> float:
        """Rms width of the Gaussian by which it averages the face, seen along z, scene units."""
        return 0.0

    @property
    def removed(self) -> float:
        """Thickness of the layer that it takes off, scene units."""
        return 0.0

    @property
    def shrunk(self) -> float:
        """Part by which the element becomes smaller."""
        return 0.0

    @property
    def reliefs(self) -> tuple[Relief, ...]:
        """What it adds to the face that is too fine for the control net."""
        return ()

    @property
    def errors(self) -> tuple[RandomRelief, ...]:
        """Random errors of the face that it adds, which no run can know."""
        return ()

    def check_for(self, element: Element) -> None:
        """Refuse what is too large for an element; the path is from the process."""


class Making(NamedTuple):
    """What the processes of a scene leave together, in their order."""

    smoothing: float  # of the designed face, rms width of a Gaussian, scene units
    removed: float  # scene units
    factor: float  # of all lengths of the element
    # What is too fine for the control net, with the rms width by which later steps smooth it.
    reliefs: tuple[tuple[Relief, float], ...]
    errors: tuple[tuple[RandomRelief, float], ...]  # random errors, likewise

    @classmethod
    def of(cls, processes: Sequence[Process]) -> "Making":
        """Combine processes; smoothing is by Gaussians, so their squares add up."""
        later = [
            math.hypot(*(each.smoothing for each in processes[number + 1 :]))
            for number in range(len(processes))
        ]
        smoothed = list(zip(processes, later, strict=True))
        return cls(
            math.hypot(*(each.smoothing for each in processes)),
            sum(each.removed for each in processes),
            math.prod(1 - each.shrunk for each in processes),
            tuple((relief, width) for each, width in smoothed for relief in each.reliefs),
            tuple((error, width) for each, width in smoothed for error in each.errors),
        )


_MOST = 8


def check_processes(processes: Sequence[Process], elements: Sequence[Element]) -> None:
    """Refuse processes that do not suit the designed elements, or too many of them.

    Raises `Refused` with the path of the field in the scene.
    """
    if len(processes) > _MOST:
        many = Message("{count} are given; at most {most}", count=len(processes), most=_MOST)
        raise Refused("processes", many)
    for number, process in enumerate(processes):
        for element in elements:
            if element.designed:
                with refused_within(f"processes[{number}]"):
                    process.check_for(element)


def check_width(name: str, width: float, element: Element, part: float) -> None:
    """Refuse a length that is more than a part of the smaller half-width of an element."""
    most = part * min(element.half_width)
    if width > most:
        raise Refused(
            name,
            Message(
                "{width:g} is too large for {name}; at most {most:.3g}",
                width=width,
                name=element.name,
                most=most,
            ),
        )


def check_step(name: str, step: float, radius: float) -> None:
    """Refuse a step of a round tool that leaves ridges as high as the tool itself."""
    if step > radius:
        raise Refused(
            name,
            Message(
                "{step:g} leaves ridges of the tool's own size; at most {most:g}",
                step=step,
                most=radius,
            ),
        )
