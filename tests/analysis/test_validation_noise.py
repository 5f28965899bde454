"""The error without the scatter of the rays, and screens at other distances."""

from types import SimpleNamespace

import numpy as np
import pytest

from tests.scenes import changed
from workbench.analysis.validation import validate
from workbench.scene import Scene


@pytest.fixture(scope="module", params=["collimated", "point"])
def checks(request):
    """Many checks by few rays of a lens with a true error of some 20 %, and one by many rays."""
    rng = np.random.default_rng(7)
    changes = {"screen.half_width": [1.6, 1.6], "screen.pixels": [24, 24]}
    if request.param == "point":
        changes["source"] = {"kind": "point", "position": [0, 0, -4]}
    scene, heights = Scene.from_data(changed(changes)), 0.5 + 0.05 * rng.random((12, 10))

    def check(target, rays, seed):
        return validate(scene, target, {"lens.back": heights}, rays, seed)

    image = check(np.ones((24, 24)), 1_000_000, 99).irradiance
    target = image * (1 + 0.4 * (rng.random(image.shape) - 0.5))
    found = [check(target, 4_000, seed) for seed in range(40)]
    truth = check(target, 1_000_000, 98).relative_l2_corrected
    return SimpleNamespace(found=found, truth=truth)


def test_few_rays_show_the_error_of_many(checks):
    found, true = checks.found, checks.truth
    corrected = np.array([each.relative_l2_corrected for each in found])
    plain = np.mean([each.relative_l2 for each in found])
    assert plain > 1.2 * true  # what the scatter adds
    standard_error = np.std(corrected, ddof=1) / np.sqrt(len(found))
    assert np.mean(corrected**2) == pytest.approx(true**2, abs=6 * true * standard_error)
    intervals = [each.relative_l2_corrected_interval for each in found]
    assert sum(low <= true <= high for low, high in intervals) >= 36


def test_the_interval_of_the_error_with_scatter(checks):
    middle = np.mean([each.relative_l2 for each in checks.found])
    assert sum(a <= middle <= b for a, b in (e.relative_l2_interval for e in checks.found)) >= 37


def test_a_perfect_lens_has_no_error_but_scatter(make_scene):
    scene = make_scene()
    flat = {"lens.back": np.full((12, 10), 0.5)}
    # 144 cells a side do not fill 32 pixels evenly: the image scatters.
    found = [validate(scene, np.ones((32, 32)), flat, 16 * 36 * 36, seed) for seed in range(20)]
    assert min(each.relative_l2 for each in found) > 0.05
    assert np.mean([each.relative_l2_corrected for each in found]) < 0.02
    assert sum(each.relative_l2_corrected_interval[0] == 0 for each in found) >= 19
