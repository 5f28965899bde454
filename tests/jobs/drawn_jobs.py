"""Jobs drawn at random over all kinds, within ranges that people ask for."""

import numpy as np

from workbench.errors import Refused
from workbench.jobs import Job
from workbench.jobs.beam_shaper import BeamShaper
from workbench.jobs.empty import Empty
from workbench.jobs.experiment import Experiment
from workbench.jobs.far_field import StreetLight
from workbench.jobs.fields import shipped
from workbench.jobs.led import LedRectangle
from workbench.jobs.mirror import MirrorJob
from workbench.jobs.sun_plate import SunPlate
from workbench.jobs.torch import Torch
from workbench.jobs.wall_washer import WallWasher

_PICTURES = (
    {"image": shipped("photo").image},
    {"image": shipped("letter").image},
    {"builtin": "flame"},
    {"builtin": "ball"},
    {"builtin": "tophat"},
    {"builtin": "rectangle", "width": 0.8, "height": 0.8},
    {"builtin": "ring"},
)


class Draw:
    """Random answers, each of one question."""

    def __init__(self, seed):
        self.rng = np.random.default_rng(seed)

    def length(self, low, high):
        """Evenly on a logarithmic scale."""
        return float(f"{np.exp(self.rng.uniform(np.log(low), np.log(high))):.3g}")

    def pair(self, low, high, most=1.6):
        """Two lengths whose ratio is at most so large."""
        length, ratio = self.length(low, high), self.length(1 / most, most)
        return [length, float(f"{length * ratio:.3g}")]

    def choice(self, values):
        return values[self.rng.integers(len(values))]


def _sun_plate(d):
    size = d.length(40, 200)
    return SunPlate, {
        "size": [size, size],
        "distance": d.length(2 * size, 8 * size),
        "image_size": d.pair(0.5 * size, 3 * size),
    }


def _torch(d):
    distance = d.length(100, 600)
    return Torch, {
        "lamp_size": d.pair(0.5, 2),
        "lamp_distance": d.length(30, 150),
        "size": d.pair(30, 100),
        "distance": distance,
        "image_size": d.pair(0.4 * distance, distance),
    }


def _led(d):
    distance = d.length(60, 300)
    return LedRectangle, {
        "lamp_size": d.pair(0.5, 2),
        "lamp_distance": d.length(8, 30),
        "size": d.pair(20, 60),
        "distance": distance,
        "image_size": d.pair(0.5 * distance, 2.5 * distance, 2.5),
    }


def _beam_shaper(d):
    beam = d.length(3, 10)
    size = beam * d.length(2, 3)
    return BeamShaper, {
        "beam_diameter": beam,
        "size": [size, size],
        "distance": d.length(100, 500),
        "image_size": d.pair(5, 40),
    }


def _wall_washer(d):
    return WallWasher, {
        "wall_size": d.pair(1000, 3000),
        "wall_distance": d.length(700, 3000),
        "above": round(d.rng.uniform(0, 1500)),
        "lamp_size": d.pair(0.5, 2),
        "lamp_distance": d.length(12, 40),
        "size": d.pair(25, 60),
    }


def _street_light(d):
    return StreetLight, {
        "lamp_distance": d.length(10, 40),
        "size": d.pair(20, 50),
        "image_angles": d.pair(30, 110),
    }


def _mirror(d):
    size = d.length(15, 60)
    return MirrorJob, {
        "size": [size, size],
        "angular_diameter": d.choice((0.0, 0.533)),
        "distance": d.length(2 * size, 8 * size),
        "aside": round(d.rng.uniform(15, 75)),
        "image_size": d.pair(0.6 * size, 2.5 * size),
    }


def _experiment(d):
    names = ("tophat-none-zeros", "flame-x1", "flame-x5", "ball-x3", "ball-x5", "flame-point")
    return Experiment, {"name": d.choice(names)}


def _empty(d):
    return Empty, {}


_KINDS = (
    _sun_plate,
    _torch,
    _led,
    _beam_shaper,
    _wall_washer,
    _street_light,
    _mirror,
    _experiment,
    _empty,
)


def drawn_jobs(count: int, seed: int) -> list[Job]:
    """So many possible jobs, each kind as often; one alone of that which asks nothing."""
    d, jobs = Draw(seed), []
    number = 0
    while len(jobs) < count:
        make = _KINDS[number % len(_KINDS)]
        number += 1
        if make is _empty and number > len(_KINDS):
            continue
        while True:
            kind, answers = make(d)
            if "target" in kind.model_fields:
                answers["target"] = d.choice(_PICTURES)
            try:
                jobs.append(kind().with_answers(answers))
                break
            except Refused:
                continue
    return jobs
