"""Charts found by lenses of few cells."""

import numpy as np
import pytest

from workbench.design.transport.chart import rough_lens
from workbench.design.transport.one_face import first_error, transport_start, wanted_cells
from workbench.geometry.surface import ControlNet

CELLS = 288
MIRROR = {
    "lens": None,
    "mirror": {"half_width": [1.0, 1.0], "control_points": [40, 40], "height_range": [-0.5, 0.5]},
}
BESIDE = {
    "screen.z": -4.0,
    "screen.center": [4.0, 0.0],
    "screen.tilt": [0.0, -45.0],
    "screen.half_width": [1.0, 1.0],
}


def _rough(scene, target):
    net = ControlNet.of(scene.optic)
    wanted, _ = wanted_cells(scene, target, CELLS)
    return rough_lens(scene, net, wanted, 1)


@pytest.fixture
def disc():
    """An even image with a brighter disc in it."""
    x = (np.arange(64) + 0.5) / 32 - 1
    return 1.0 + (np.hypot(x, x[:, None] - 0.2) < 0.5)


def test_a_screen_beside_a_mirror_needs_one_and_its_first_lens_is_good(make_scene, disc):
    scene = make_scene(MIRROR | BESIDE | {"screen.pixels": [64, 64]})
    found = _rough(scene, disc)
    assert found.chart is not None
    assert found.chart.finer(1).x.shape == (CELLS, CELLS)
    rough = first_error(scene, disc, {"mirror.face": found.heights})
    heights = transport_start(scene, disc)
    assert heights is not None
    assert first_error(scene, disc, {"mirror.face": heights}) < min(0.08, rough)
