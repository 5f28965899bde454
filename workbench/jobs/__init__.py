"""Jobs: tasks in real units that begin from a few questions, each one small file.

A job is a part as those of a scene are: its fields say their titles, tips and units, and what it is
asked for makes a `Scene`. A new job is a file here and a line in `JOBS`.
"""

from workbench.jobs.beam_shaper import BeamShaper
from workbench.jobs.empty import Empty
from workbench.jobs.experiment import Experiment
from workbench.jobs.far_field import StreetLight
from workbench.jobs.job import Job
from workbench.jobs.led import LedRectangle
from workbench.jobs.mirror import MirrorJob
from workbench.jobs.side_view import Dimension, SideView, side_view
from workbench.jobs.sun_plate import SunPlate
from workbench.jobs.torch import Torch
from workbench.jobs.wall_washer import WallWasher

JOBS: tuple[type[Job], ...] = (
    SunPlate,
    Torch,
    LedRectangle,
    BeamShaper,
    WallWasher,
    StreetLight,
    MirrorJob,
    Experiment,
    Empty,
)
"""All jobs, in the order in which people are asked to choose."""

__all__ = [
    "JOBS",
    "Dimension",
    "Job",
    "SideView",
    "side_view",
]
