"""The error of a lens from pairs of independent images."""

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from tests.lamps import PLATE, led
from workbench.analysis.cells.lattice import CellLattice
from workbench.analysis.metrics import relative_l2
from workbench.analysis.scatter import CorrectedDistance
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.analysis.validation import validate
from workbench.progress import finished

LED = {"kind": "area", "center": [0.1, 0, -0.5], "half_width": [0.1, 0.1]}


@pytest.fixture
def lens(make_scene):
    settings = {"screen.half_width": [3.0, 3.0], "screen.pixels": [16, 16]}
    scene = make_scene({"source": LED, "lens.control_points": [50, 50]} | settings)
    waves = net_of(scene, lambda x, y: 0.01 * np.sin(25 * x + y) * np.cos(22 * y))
    heights = waves + net_of(scene, lambda x, y: 0.5 - 0.1 * x**2 - 0.05 * y**2)
    return scene, {"lens.back": heights}


@pytest.fixture
def target():
    return np.ones((16, 16)) + np.eye(16)


def test_pairs_find_the_distance_and_its_interval(rng):
    """Of images with much more scatter than distance, 40 times anew."""
    wanted = 1 + rng.random((20, 20))
    true = wanted * (1 + 0.02 * np.sign(rng.normal(size=(20, 20))))
    exact = relative_l2(true, wanted)
    inside, found = 0, []
    for _ in range(40):
        images = true + 0.1 * rng.normal(size=(16, 20, 20))
        pairs = CorrectedDistance.of_pairs(images, wanted)
        low, high = pairs.interval
        inside += low <= exact <= high
        found.append(pairs.square)
        assert relative_l2(images.mean(axis=0), wanted) > exact
    assert inside >= 34
    error = np.std(found, ddof=1) / np.sqrt(40)
    assert np.mean(found) == pytest.approx(exact**2, abs=3 * error)


@pytest.mark.usefixtures("fewer_rays")
def test_independent_images_give_the_error_of_a_near_emitter_where_cells_do_not(lens, target):
    train = OpticalTrain.of(lens[0], lens[1], 1, 0, Pose(), [lens[0].receiver])
    fine = CellLattice(lens[0], train.lit_by(train.source.finer(2)), (70, 70))
    error = relative_l2(finished(fine.tracing()), target)
    found = validate(lens[0], target, lens[1], 200_000, accuracy=6e-3)
    cells = found.by_cells
    assert cells.bound > 2 * 6e-3
    low, high = cells.relative_l2_corrected_interval
    assert low - 1e-3 < error < high + 1e-3  # 256 origins are off by a little, too
    assert (high - low) / 2 <= 6e-3
    assert cells.relative_l2_corrected == cells.independent.unscattered.distance
    assert cells.less_exact is None
    assert cells.way.startswith("16 independent images of ")
    assert cells.to_data()["independent_rays"] == cells.independent.rays
    rays = cells.efficiency == pytest.approx(found.efficiency, rel=1e-12)
    assert rays == (cells.bound > 0.5)


@pytest.mark.usefixtures("fewer_rays")
def test_rays_of_a_file_tell_how_far_they_may_be_from_their_lamp(make_scene, tmp_path):
    """Two checks by all rays of one file follow the same rays: they would find no scatter."""
    found = []
    for name, count in (("few", 20_000), ("many", 400_000)):
        (tmp_path / name).mkdir()
        scene = make_scene(PLATE | {"source": led(tmp_path / name, count)})
        plate = {"lens.back": np.full(scene.optic.net_shape, 0.5)}
        wanted = np.ones((40, 40))
        found.append(validate(scene, wanted, plate, 4_000_000, accuracy=3e-3))
    few, many = found
    assert (few.rays, many.rays) == (20_000, 400_000)
    low, high = few.relative_l2_corrected_interval
    assert low <= many.relative_l2_corrected <= high
    assert few.relative_l2 > high
    assert high - low > 3 * np.subtract(*many.relative_l2_corrected_interval[::-1]) > 0
    # Cells see the points that stand for the rays; the error is that of the rays themselves.
    assert few.verified.relative_l2_corrected == few.relative_l2_corrected
    assert few.verified.independent.rays == 20_000
    assert few.by_cells.noise > 0
    assert few.by_cells.less_exact.endswith("that needs more rays")
