"""Runs for several images at once."""

import numpy as np
import pytest
import torch

from tests.scene.test_images import SECOND
from workbench.analysis.metrics import paper_loss, relative_l2
from workbench.design.levels import finest_image
from workbench.design.loss import relative_error
from workbench.design.run import run
from workbench.design.session import Session
from workbench.design.snapshot import Result
from workbench.design.task import begin
from workbench.files.session import read_session, write_session
from workbench.scene.paths import with_values

BOTH = {
    "lens.entrance": {"shape": "freeform", "height_range": [-0.3, 0.3]},
    "lens.height_range": None,
    "lens.base": {"shape": "flat", "height": 1.5},
    "screen.z": 4.5,
    "lens.control_points": [24, 24],
    "target": {"builtin": "tophat", "radius": 0.85, "blur": 2.0},
    "run.iterations": 25,
}


@pytest.fixture
def at_two_distances(make_scene, tmp_path):
    """The same image on two screens, by two faces."""
    scene = make_scene(BOTH)
    second = scene.images[0].altered(receiver=scene.receiver.moved_to(5.5))
    short = scene.run.altered(iterations=12)
    return begin(scene.with_images((*scene.images, second)).altered(run=short), tmp_path)


def with_one_face(session, tmp_path):
    return begin(with_values(session.scene, {"lens.front": {"shape": "plane"}}), tmp_path)


def last_of(session):
    *_, last = run(session.scene, session.target)
    return last


def test_two_faces_make_an_image_at_two_distances_that_one_face_cannot(at_two_distances, tmp_path):
    one_face = with_one_face(at_two_distances, tmp_path)
    two, one = (last_of(session).state for session in (at_two_distances, one_face))
    assert two.loss < 0.4 * one.loss
    for state in (two, one):
        assert len(state.further) == 1
        assert state.further[0].irradiance.shape == (32, 32)


def test_the_loss_is_that_of_the_mean_square_of_relative_errors_by_weight(make_scene, tmp_path):
    session = begin(make_scene({"further_images": [SECOND]}), tmp_path)
    state = next(run(session.scene, session.target)).state
    images = session.scene.wanted(session.target)
    assert [image.weight for image in images] == [1.0, 2.0]
    squares = [
        relative_l2(light.irradiance, image.target) ** 2
        for light, image in zip(state.lights, images, strict=True)
    ]
    wanted = np.sqrt((squares[0] + 2 * squares[1]) / 3)
    assert relative_error(state, session.target) == pytest.approx(wanted, rel=1e-5)
    second = images[1].target
    assert state.further[0].loss == pytest.approx(
        paper_loss(state.further[0].irradiance, second), rel=1e-5
    )


def test_the_gradient_is_that_of_the_weighted_sum_of_images(make_scene, tmp_path, rng):
    session = begin(make_scene({"further_images": [SECOND]}), tmp_path)
    scene, target = session.scene, session.target
    heights = 0.5 + 0.02 * rng.standard_normal(scene.optic.net_shape)

    def gradient(scene, target):
        z = torch.tensor(heights, requires_grad=True)
        image = finest_image(scene, target, {"lens.back": torch.tensor(heights)})
        error, _ = image.compare({"lens.back": z})
        error.square().sum().backward()
        return z.grad.numpy()

    first, second = scene.wanted(target)
    alone = [gradient(image.scene, image.target) for image in (first, second)]
    np.testing.assert_allclose(
        gradient(scene, target), (alone[0] + 2 * alone[1]) / 3, rtol=1e-4, atol=1e-6
    )


def test_sessions_keep_all_targets_and_all_light(make_scene, tmp_path):
    np.save(tmp_path / "wanted.npy", np.eye(8) + 0.1)
    image = {**SECOND, "target": {"image": str(tmp_path / "wanted.npy")}}
    session = begin(make_scene({"further_images": [SECOND, image]}), tmp_path)
    shot = next(run(session.scene, session.target))
    result = Result(shot.state, np.array([1.0]), 1.0)
    path = tmp_path / "several.freeform"
    write_session(Session(session.scene, session.target, result), path)
    (tmp_path / "wanted.npy").unlink()
    again = read_session(path)
    assert again.scene == session.scene
    for before, after in zip(session.scene.images[1:], again.scene.images[1:], strict=True):
        np.testing.assert_array_equal(before.wanted, after.wanted)
        assert before.drawn.picture == after.drawn.picture
    for before, after in zip(shot.state.further, again.result.state.further, strict=True):
        np.testing.assert_array_equal(before.irradiance, after.irradiance)
        assert (before.loss, before.account) == (after.loss, after.account)
    in_mm = again.in_unit("mm")
    assert in_mm.result.state.further[0].irradiance.sum() == pytest.approx(
        shot.state.further[0].irradiance.sum() / 100
    )
    path.unlink()
