"""Photographs of projected light: rectified, compared, and explained."""

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from tests.scenes import changed
from workbench.analysis.making.photograph import comparing, rectified
from workbench.analysis.tracing.trace import Trace
from workbench.design.run import run
from workbench.errors import Refused, RunFailed
from workbench.progress import finished
from workbench.scene import Scene

_CORNERS = ((60.0, 40.0), (330.0, 20.0), (350.0, 280.0), (40.0, 250.0))


def photographed(light, corners=_CORNERS, shape=(300, 400)):
    """A picture of light at a slant: the inverse of what rectifies it, solved anew."""
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], dtype=float)
    rows = []
    for (x, y), (u, v) in zip(corners, square, strict=True):
        rows.append([x, y, 1, 0, 0, 0, -u * x, -u * y])
        rows.append([0, 0, 0, x, y, 1, -v * x, -v * y])
    h = np.append(np.linalg.solve(np.array(rows), square.ravel()), 1).reshape(3, 3)
    row, column = np.indices(shape) + 0.5
    u, v, w = np.tensordot(h, np.stack([column, row, np.ones(shape)]), axes=1)
    n_y, n_x = light.shape
    return map_coordinates(light, [v / w * n_y - 0.5, u / w * n_x - 0.5], order=1)


@pytest.fixture(scope="module")
def plate():
    small = {
        "lens.control_points": [24, 24],
        "screen.pixels": [64, 64],
        "source": {"kind": "collimated", "angular_diameter": 2.0},
    }
    scene = Scene.from_data(changed(small) | {"version": 2})
    target = np.full((64, 64), 0.2)
    target[12:52, 16:26] = target[42:52, 26:48] = 1.0
    *_, last = run(scene, target)
    return scene, target, last.state.heights


def light_of(scene, heights, noise=0.0):
    trace = Trace(scene, heights, 2_000_000, 5)
    batches = (batch.flux[0] for batch in trace.batches() if batch is not None)
    light = sum(batches).reshape(64, 64)
    light = light / light.max()
    return light + noise * np.random.default_rng(0).normal(size=light.shape)


def test_a_quadrilateral_becomes_the_receiver(rng):
    smooth = np.add.outer(np.sin(np.arange(40) / 6), np.cos(np.arange(50) / 9)) + 3
    found = rectified(photographed(smooth), _CORNERS, (40, 50))
    assert found[2:-2, 2:-2] == pytest.approx(smooth[2:-2, 2:-2], abs=0.03)


@pytest.mark.full
def test_distance_tilt_and_source_are_recovered(plate):
    scene, target, heights = plate
    receiver = scene.receiver.model_copy(
        update={"position": (0.0, 0.0, 5.2), "tilt": (8.0, 0.0, 0.0)}
    )
    real = scene.with_receiver(receiver)
    real = real.model_copy(update={"source": scene.source.resized(1.3)})
    picture = photographed(light_of(real, heights, 0.005))
    row, column = np.indices(picture.shape)
    picture *= 1 - 0.3 * ((row - 150) ** 2 + (column - 200) ** 2) / (150**2 + 200**2)
    found = finished(comparing(scene, target, heights, picture, _CORNERS))
    causes = {cause.name: cause.value for cause in found.causes}
    assert causes["distance"] == pytest.approx(0.2, abs=0.02 * 5)
    assert causes["tilt about x"] == pytest.approx(8.0, abs=2.0)
    assert causes["tilt about y"] == pytest.approx(0.0, abs=1.0)
    assert causes["source size"] == pytest.approx(0.3, abs=0.13)
    assert found.left < 0.6 * found.apart
    assert found.turned == ""
    assert found.darkening < 0.95


@pytest.mark.full
def test_a_photograph_that_stands_on_its_head_is_turned(plate):
    scene, target, heights = plate
    picture = photographed(light_of(scene, heights)[::-1, ::-1])
    found = finished(comparing(scene, target, heights, picture, _CORNERS))
    assert found.turned == "turned by 180°"
    assert found.left < 0.1


@pytest.mark.parametrize("light", [0.0, 1.0])
def test_one_without_the_picture_is_refused(plate, rng, light):
    scene, target, heights = plate
    with pytest.raises(Refused, match="photograph: the picture of this lens is not within"):
        finished(comparing(scene, target, heights, light * rng.random((300, 400)), _CORNERS))


def test_a_lens_without_light_on_the_screen_is_not_compared(plate, rng):
    scene, target, heights = plate
    beside = scene.with_receiver(scene.receiver.model_copy(update={"position": (40.0, 0.0, 5.0)}))
    with pytest.raises(RunFailed, match="no light of this lens reaches the screen"):
        finished(comparing(beside, target, heights, rng.random((300, 400)), _CORNERS))


@pytest.mark.parametrize(
    ("corners", "message"),
    [
        (((60, 40), (350, 280), (330, 20), (40, 250)), "no convex quadrilateral"),
        (((60, 40), (530, 20), (350, 280), (40, 250)), "beside the photograph of 400 × 300"),
    ],
)
def test_bad_corners(corners, message):
    with pytest.raises(Refused, match=f"corners: .*{message}"):
        rectified(np.ones((300, 400)), corners, (8, 8))
