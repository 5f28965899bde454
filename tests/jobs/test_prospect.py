"""What jobs say before anything is designed."""

import math
from pathlib import Path

import numpy as np
import pytest

from workbench.analysis.light_limit import light_limits
from workbench.design.task import begin
from workbench.jobs import JOBS
from workbench.jobs.estimate import estimating
from workbench.jobs.job import blur_widths
from workbench.jobs.lenses import LedRectangle, SunPlate, Torch
from workbench.jobs.mirrors import MirrorJob
from workbench.jobs.prospect import prospecting
from workbench.progress import finished
from workbench.scene.paths import with_values

EVEN = {"target": {"builtin": "rectangle"}}


def session_of(job):
    return begin(job.scene(), Path("/"))


def coarse(scene):
    """The same task with a quarter of the pixels along each axis."""
    pixels = [number // 4 for number in scene.receiver.pixels]
    return with_values(scene, {"images[0].receiver.pixels": pixels})


def prospect(session):
    return finished(prospecting(session))


def figures(job):
    return {figure.name: figure for figure in prospect(session_of(job)).figures}


def figures_at_once(job):
    """Those that need no picture at best."""
    steps = prospecting(session_of(job))
    try:
        return {figure.name: figure for figure in next(steps).figures}
    finally:
        steps.close()


@pytest.fixture
def no_estimate(monkeypatch):
    """Bounds alone are asked for."""

    def none(session):
        yield from ()

    monkeypatch.setattr("workbench.jobs.prospect.estimating", none)


def test_the_blur_is_that_of_the_sun_through_a_pinhole():
    scene = SunPlate().scene()
    wide = (500.0 - scene.optic.leaving_z) * math.radians(0.533)
    assert blur_widths(scene) == pytest.approx((wide, wide))


@pytest.mark.parametrize("kind", JOBS, ids=lambda kind: kind.__name__)
def test_each_job_can_be_begun_as_it_is(kind, no_estimate):
    answers = EVEN if "target" in kind.model_fields else {}
    session = session_of(kind().with_answers(answers))
    assert session.scene.optic.known_shape is not None
    session = begin(coarse(session.scene), Path("/"))
    found = prospect(session)
    assert found.picture.shape == session.target.shape
    assert found.picture.min() >= 0 and found.picture.max() > 0
    slope = next(figure for figure in found.figures if figure.name == "Largest slope")
    assert not slope.warns


def test_the_picture_at_best_is_blurred_by_the_lamp(no_estimate):
    job = Torch().with_answers({"target": {"builtin": "tophat"}, "lamp_size": [4.0, 4.0]})
    session = session_of(job)
    image, wanted = (each / each.sum() for each in (prospect(session).picture, session.target))
    assert np.abs(image - wanted).max() > 0.1 * wanted.max()


SMALL = {"target": {"builtin": "tophat"}, "size": [20.0, 20.0], "image_size": [20.0, 20.0]}


def test_an_estimate_is_that_of_a_coarse_design():
    session = session_of(MirrorJob().with_answers(SMALL | {"angular_diameter": 0.0}))
    parts = []
    estimate = finished(estimating(session), parts.append)
    assert parts == sorted(parts) and parts[0] >= 0 and parts[-1] <= 1
    assert 0.95 < estimate.light <= 0.98 and 0 < estimate.least < estimate.most < 0.05


def test_an_estimate_of_a_narrow_lamp_counts_what_passes_the_lens_by():
    """Gebhart's view factor, less what both faces reflect at least."""
    job = Torch().with_answers(EVEN | {"lamp_size": [0.5, 0.5]})
    session = begin(coarse(job.scene()), Path("/"))
    caught = light_limits(session.scene)[0].meets
    estimate = finished(estimating(session))
    assert 0.8 * caught < estimate.light < 0.95 * caught


def test_a_turn_that_no_face_can_make_is_stated():
    stated = figures_at_once(
        SunPlate().with_answers(EVEN | {"distance": 60.0, "image_size": [400.0, 400.0]})
    )
    assert stated["Largest slope"].warns
    assert "at most" in stated["Largest slope"].meaning


def test_light_that_passes_the_lens_by_is_stated():
    """Of a Lambertian lamp at h before a square: Gebhart's view factor of a point and a corner."""
    job = Torch().with_answers(EVEN)
    half, height = job.size[0] / 2, job.lamp_distance
    slant = math.hypot(half, height)
    caught = 4 / math.pi * (half / slant) * math.atan(half / slant)
    stated = figures_at_once(job)["Light on the lens"]
    assert stated.value == f"{100 * caught:.0f} % of it" and stated.warns
    assert "Light on the lens" not in figures_at_once(SunPlate().with_answers(EVEN))
    assert not figures_at_once(LedRectangle())["Light on the lens"].warns
