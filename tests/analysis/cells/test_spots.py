"""The light of wide sources, drawn as spots."""

import numpy as np
import pytest

from tests.analysis.cells.test_image import found, waves
from tests.analysis.cells.test_lattice import distance
from tests.analysis.lenses import followed, net_of
from workbench.analysis.cells.spots import Spots
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.analysis.validation import validate
from workbench.geometry.outlines import Ellipse

SUN = {"kind": "collimated", "angular_diameter": 3.0}
TILTED = SUN | {"direction": [8.0, -5.0]}
WIDER = {"screen.half_width": [1.5, 1.3]}


def train_of(scene, heights):
    return OpticalTrain.of(scene, {"lens.back": heights}, 1, 0, Pose(), [scene.receiver])


def spots_of(scene, heights, cells):
    """Part of the emitted flux in each pixel."""
    return followed(Spots(scene, train_of(scene, heights), cells).tracing())


def test_the_rim_of_the_light_behind_a_plate_is_the_blur_of_the_sun(make_scene):
    scene = make_scene({"source": SUN, "screen.half_width": [1.37, 1.21], "screen.pixels": [40, 4]})
    thin = 1e-3  # light hardly leaves through its side
    image = spots_of(scene, np.full((12, 10), thin), (800, 50)).sum(axis=0)
    # A cone from a place of the lens is a disc on the screen, but for angles to the third power.
    angle = np.radians(1.5)
    radius = (5 - thin) * np.tan(angle) + thin * np.tan(np.arcsin(np.sin(angle) / 1.5))
    disc = Ellipse((radius, radius))
    ends = np.linspace(-1.37, 1.37, 41)
    place = (np.arange(4000) + 0.5) / 2000 - 1
    inside = disc.area_inside((-2.0, ends[:, None] - place), (-2.0, 2.0)) / disc.area
    exact = (1 - 0.04) ** 2 * np.diff(inside.mean(axis=1))
    assert distance(image, exact) < 1e-3


def test_the_error_of_spots_is_within_its_bound(make_scene):
    scene = make_scene({"source": SUN} | WIDER)
    exact = found(scene, waves(scene), accuracy=1.5e-3).irradiance
    for accuracy in (0.1, 8e-3):
        coarse = found(scene, waves(scene), accuracy=accuracy)
        assert distance(coarse.irradiance, exact) < coarse.bound <= accuracy


def test_random_rays_see_no_difference(make_scene, rng):
    scene = make_scene({"source": TILTED} | WIDER)
    target = 1 + rng.random((32, 32))
    both = validate(scene, target, {"lens.back": waves(scene)}, 1_000_000, seed=3, accuracy=2e-3)
    assert both.by_cells.less_exact is None
    assert both.by_cells.unscattered.interval[0] == 0
    low, high = both.by_cells.relative_l2_corrected_interval
    least, most = both.relative_l2_corrected_interval
    assert least < high and low < most
    assert high - low < most - least


def test_light_is_lost_where_it_is_in_truth(make_scene):
    scene = make_scene({"source": SUN, "screen.half_width": [3.0, 3.0]})
    # Waves so steep that they reflect much of the light totally, in many places.
    steep = net_of(scene, lambda x, y: 0.6 + 0.15 * np.sin(9 * x) * np.cos(8 * y))
    by_rays = validate(scene, np.ones((32, 32)), {"lens.back": steep}, 100_000)
    assert by_rays.account.lost["total_reflection"] > 0.01
    assert spots_of(scene, steep, (120, 120)).sum() == pytest.approx(by_rays.efficiency, abs=1e-3)
