"""Jobs: tasks in real units that begin from a few questions.

A job is a `Part` with titles, tips and units; its answers make a `Scene`. A new job is a class in
`lenses` or a file of its own, and a line in `JOBS`.
"""

from workbench.jobs.job import Job
from workbench.jobs.lenses import (
    BeamShaper,
    Empty,
    Experiment,
    LedRectangle,
    StreetLight,
    SunPlate,
    Torch,
    TorchBeam,
    WallWasher,
)
from workbench.jobs.mirrors import MirrorJob
from workbench.jobs.side_view import Dimension, SideView, side_view

JOBS: tuple[type[Job], ...] = (
    SunPlate,
    Torch,
    TorchBeam,
    LedRectangle,
    BeamShaper,
    WallWasher,
    StreetLight,
    MirrorJob,
    Experiment,
    Empty,
)
"""All jobs, in the order in which people are asked to choose."""

__all__ = ["JOBS", "Dimension", "Job", "SideView", "side_view"]
