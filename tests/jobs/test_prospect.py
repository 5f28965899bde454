"""What jobs say before anything is designed."""

import math
from pathlib import Path

import numpy as np
import pytest

from workbench.design.task import begin
from workbench.extended.diffraction import diffraction
from workbench.jobs import JOBS
from workbench.jobs.estimate import Estimate, estimating
from workbench.jobs.experiment import Experiment
from workbench.jobs.far_field import StreetLight
from workbench.jobs.led import LedRectangle
from workbench.jobs.mirror import MirrorJob
from workbench.jobs.proposals import blur_widths
from workbench.jobs.prospect import _estimated, _light_of, prospecting
from workbench.jobs.sun_plate import SunPlate
from workbench.jobs.torch import Torch
from workbench.jobs.wall_washer import WallWasher
from workbench.scene import Scene
from workbench.watch import finished

EVEN = {"target": {"builtin": "rectangle"}}


def session_of(job):
    return begin(job.scene(), Path("/"))


def coarse(scene):
    """The same task with a quarter of the pixels along each axis."""
    data = scene.to_data()
    receiver = data.get("screen") or data["far_field"]
    receiver["pixels"] = [number // 4 for number in receiver["pixels"]]
    return Scene.from_data(data)


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


def test_diffraction_grows_with_the_root_of_the_distance():
    for distance in (200.0, 800.0):
        scene = SunPlate().with_answers({"distance": distance}).scene()
        way = distance - scene.optic.leaving_z
        assert diffraction(scene) == pytest.approx(math.sqrt(0.55e-3 * way))


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


def test_light_that_no_lens_can_bring_into_the_picture_is_said(no_estimate):
    shape = {"builtin": "rectangle", "width": 0.05, "height": 0.05}
    far = {"lamp_size": [4.0, 4.0], "lamp_distance": 60.0, "size": [30.0, 30.0]}
    said = figures(Torch().with_answers({"target": shape} | far))
    assert said["Light at best"].warns and said["Error at best"].warns
    assert "%" in said["Error at best"].value


def test_an_error_of_no_bound_is_not_known(no_estimate):
    """An LED of 1 mm, 10 mm before its lens, and 500 × 200 mm at 100 mm: 24 % and 11 % came."""
    wide = {"distance": 100.0, "image_size": [500.0, 200.0]}
    for job in (LedRectangle().with_answers(EVEN | wide), LedRectangle().with_answers(EVEN)):
        said = figures(job)
        assert said["Error at best"].value == "not known"
        assert not any("allows it" in figure.value for figure in said.values())
    sharp = figures(MirrorJob().with_answers(EVEN))
    assert sharp["Error at best"].value == "not known"


def test_light_at_best_is_what_a_face_reflects_least_of():
    """Of a plate at normal incidence, by Fresnel's equations at both faces."""
    session = session_of(SunPlate().with_answers(EVEN))
    n = session.scene.optic.index
    through = (1 - ((n - 1) / (n + 1)) ** 2) ** 2
    assert _light_of(session.scene).leaves == pytest.approx(through, abs=1e-3)
    assert _light_of(MirrorJob().with_answers(EVEN).scene()).leaves == pytest.approx(1)


SMALL = {"target": {"builtin": "tophat"}, "size": [20.0, 20.0], "image_size": [20.0, 20.0]}


def test_an_estimate_is_that_of_a_coarse_design():
    session = session_of(MirrorJob().with_answers(SMALL | {"angular_diameter": 0.0}))
    parts = []
    estimate = finished(estimating(session), parts.append)
    assert parts == sorted(parts) and parts[0] >= 0 and parts[-1] <= 1
    assert 0.95 < estimate.light <= 0.98 and 0 < estimate.least < estimate.most < 0.05


def test_an_estimate_holds_the_error_of_the_blur(monkeypatch):
    def least(session):
        yield 0.0
        return 0.04

    session = session_of(MirrorJob().with_answers(SMALL | {"angular_diameter": 0.0}))
    monkeypatch.setattr("workbench.jobs.estimate._least", least)
    estimate = finished(estimating(session))
    assert estimate.least < 0.05 < estimate.most < 0.08


def test_an_estimate_of_a_narrow_lamp_counts_what_passes_the_lens_by():
    """Gebhart's view factor, less what both faces reflect at least."""
    job = Torch().with_answers(EVEN | {"lamp_size": [0.5, 0.5]})
    session = begin(coarse(job.scene()), Path("/"))
    caught = _light_of(session.scene).caught
    estimate = finished(estimating(session))
    assert 0.8 * caught < estimate.light < 0.95 * caught


def test_the_estimate_comes_before_the_bound(monkeypatch):
    def given(session):
        yield 0.5
        return Estimate(0.02, 0.04, 0.9)

    monkeypatch.setattr("workbench.jobs.prospect.estimating", given)
    steps = prospecting(session_of(SunPlate().with_answers(EVEN)))
    first, part, second = next(steps), next(steps), next(steps)
    steps.close()
    assert "estimating" in first.figures[0].value and part == 0.5
    assert second.picture is None and second.figures[0].value.startswith("error 2.0 – 4.0 %, 90 %")


def test_designs_by_other_methods_are_not_estimated(no_estimate):
    said = figures(Experiment(name="tophat-none-zeros", method="paper"))
    assert said["Estimate"].value == "not known" and "automatic" in said["Estimate"].meaning


def test_small_errors_are_not_told_apart():
    scene = Torch().with_answers(EVEN).scene()
    assert _estimated(scene, Estimate(0.003, 0.005, 0.9)).value.startswith("error < 1.0 %, 90 %")
    assert _estimated(scene, Estimate(0.007, 0.012, 0.9)).value.startswith("error 0.70 – 1.2 %")


def test_a_task_whose_light_does_not_arrive_is_not_promised_anything():
    said = _estimated(Torch().with_answers(EVEN).scene(), None)
    assert said.warns and said.value == "not known"


def test_a_turn_that_no_face_can_make_is_said():
    said = figures_at_once(
        SunPlate().with_answers(EVEN | {"distance": 60.0, "image_size": [400.0, 400.0]})
    )
    assert said["Largest slope"].warns
    assert "at most" in said["Largest slope"].meaning


def test_figures_known_at_once_come_before_the_best_possible_picture():
    steps = prospecting(session_of(Torch()))
    first = next(steps)
    assert first.picture is None
    assert "Largest slope" in {figure.name for figure in first.figures}
    steps.close()


def test_light_that_passes_the_lens_by_is_said():
    """Of a Lambertian lamp at h before a square: Gebhart's view factor of a point and a corner."""
    job = Torch().with_answers(EVEN)
    half, height = job.size[0] / 2, job.lamp_distance
    slant = math.hypot(half, height)
    caught = 4 / math.pi * (half / slant) * math.atan(half / slant)
    said = figures_at_once(job)["Light on the lens"]
    assert said.value == f"{100 * caught:.0f} % of it" and said.warns
    assert "Light on the lens" not in figures_at_once(SunPlate().with_answers(EVEN))
    assert not figures_at_once(LedRectangle())["Light on the lens"].warns


def test_a_wall_that_light_grazes_is_said():
    near = figures_at_once(WallWasher(**EVEN, wall_distance=400.0, above=2200.0))
    assert near["Light on the screen"].warns and "grazes" in near["Light on the screen"].meaning
    assert "Light on the screen" not in figures_at_once(WallWasher(**EVEN))


def test_angles_have_their_sign_without_a_space():
    said = figures_at_once(StreetLight())
    assert said["Diffraction"].value.endswith("°")
    assert not [figure.value for figure in said.values() if " °" in figure.value]
