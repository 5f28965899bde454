"""Slopes of the face, and the side view, of a job."""

import math

import numpy as np
import pytest

from workbench.jobs import side_view
from workbench.jobs.lenses import SunPlate, Torch, WallWasher
from workbench.jobs.mirrors import MirrorJob
from workbench.jobs.slopes import needed_slopes
from workbench.scene.paths import with_values


def test_widths_and_distances_are_those_of_the_job():
    job = Torch().with_answers({"size": [60.0, 40.0], "image_size": [300.0, 160.0]})
    view = side_view(job.scene())
    lengths = {
        dimension.text: np.linalg.norm(np.subtract(*dimension.ends))
        for dimension in view.dimensions
    }
    assert view.across == "y"
    assert lengths == pytest.approx(
        {"40 mm": 40.0, "160 mm": 160.0, "200 mm": 200.0, "80 mm": 80.0}, abs=1e-9
    )


def test_rays_go_from_the_lamp_by_the_lens_to_the_image():
    scene = Torch().scene()
    view = side_view(scene)
    for ray, part in zip(view.rays, np.linspace(-1, 1, len(view.rays)), strict=True):
        begin, through, end = ray
        assert begin == pytest.approx([-80.0, 0.0])
        assert through == pytest.approx([scene.optic.leaving_z, 30.0 * part])
        assert end == pytest.approx([200.0, 80.0 * part])


@pytest.mark.parametrize(("kind", "across"), [(WallWasher, "y"), (MirrorJob, "x")])
def test_side_view_of_a_tilted_part_is_taken_from_where_the_tilt_shows(kind, across):
    view = side_view(kind().scene())
    assert view.across == across
    upright, tilted = view.receiver, view.optic[[0, 3]]
    if kind is MirrorJob:
        upright, tilted = tilted, upright
    assert np.ptp(upright[:, 0]) == pytest.approx(0.0, abs=1e-9)
    assert np.ptp(tilted[:, 0]) > 0.1 * np.ptp(tilted[:, 1])


def far_image(angle, distance=1e5):
    """A plate whose light all goes to a small image aside, at an angle to the axis."""
    scene = SunPlate().with_answers({"distance": distance, "image_size": [1.0, 1.0]}).scene()
    aside = (scene.receiver.z - scene.optic.leaving_z) * math.tan(math.radians(angle))
    return with_values(scene, {"images[0].receiver.position[0]": aside})


@pytest.mark.parametrize("angle", [1.0, 10.0, 30.0, 45.0])
def test_light_that_is_turned_needs_a_prism(angle):
    scene = far_image(angle)
    found = needed_slopes(scene)
    middle = found.gradient[8, 8]
    turn = math.radians(angle)
    prism = math.sin(turn) / (scene.optic.index - math.cos(turn))  # by Snell's law
    assert middle == pytest.approx([prism, 0.0], rel=1e-3, abs=1e-9)
    assert found.turn == pytest.approx(angle, abs=0.1)
    assert found.possible


def test_light_of_a_lamp_that_goes_straight_on_needs_a_flat_face():
    # Far away the lens is a point, and light goes on as it came: 20 mm aside after 40 mm.
    lamp = {"lamp_distance": 40.0, "size": [40.0, 40.0]}
    scene = Torch().with_answers(lamp | {"distance": 2e4, "image_size": [2e4, 2e4]}).scene()
    found = needed_slopes(scene)
    assert np.abs(found.gradient).max() < 0.01
    assert found.rise < 0.1


@pytest.mark.parametrize("aside", [10.0, 45.0, 80.0])
def test_a_mirror_is_turned_by_half_of_what_it_turns_light_by(aside):
    answers = {"aside": aside, "size": [1.0, 1.0], "image_size": [1.0, 1.0], "distance": 400.0}
    found = needed_slopes(MirrorJob().with_answers(answers).scene())
    slope = math.hypot(*found.gradient[8, 8])
    assert math.degrees(math.atan(slope)) == pytest.approx(aside / 2, rel=1e-4)  # the job rounds


def test_the_rise_of_a_face_is_that_of_its_slopes():
    scene = SunPlate().scene()
    found = needed_slopes(scene)
    # Evenly spread light needs a slope that grows evenly from the middle to both edges.
    edge = found.gradient[-1, 8, 0]
    assert found.rise == pytest.approx(2 * edge * 50.0 / 2, rel=0.05)
