"""The drawing of a job is its scene, to scale."""

import numpy as np
import pytest

from workbench.jobs import side_view
from workbench.jobs.mirror import MirrorJob
from workbench.jobs.torch import Torch
from workbench.jobs.wall_washer import WallWasher


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
