"""The error without the scatter of the rays, and screens at other distances."""

import numpy as np
import pytest

from workbench.analysis.validation import validate


@pytest.fixture(params=["collimated", "point"])
def lens(request, make_scene, rng):
    """A lens with a true error of some 20 %, and a target for it."""
    source = {"kind": "point", "position": [0, 0, -4]} if request.param == "point" else None
    changes = {"screen.half_width": [1.6, 1.6], "screen.pixels": [24, 24]}
    scene = make_scene(changes | ({"source": source} if source else {}))
    heights = 0.5 + 0.05 * rng.random((12, 10))
    truth = validate(
        scene, np.ones((24, 24)), {"lens.back": heights}, 1_000_000, seed=99
    ).irradiance
    target = truth * (1 + 0.4 * (rng.random(truth.shape) - 0.5))
    return scene, target, heights


def test_few_rays_show_the_error_of_many(lens):
    scene, target, heights = lens
    truth = validate(scene, target, {"lens.back": heights}, 1_000_000, seed=98)
    found = [validate(scene, target, {"lens.back": heights}, 4_000, seed) for seed in range(40)]
    corrected = np.array([each.relative_l2_corrected for each in found])
    plain = np.mean([each.relative_l2 for each in found])
    true = truth.relative_l2_corrected
    assert plain > 1.2 * true  # what the scatter adds
    standard_error = np.std(corrected, ddof=1) / np.sqrt(len(found))
    assert np.mean(corrected**2) == pytest.approx(true**2, abs=6 * true * standard_error)
    intervals = [each.relative_l2_corrected_interval for each in found]
    assert sum(low <= true <= high for low, high in intervals) >= 36


def test_the_interval_of_the_error_with_scatter(lens):
    scene, target, heights = lens
    found = [validate(scene, target, {"lens.back": heights}, 4_000, seed) for seed in range(30)]
    middle = np.mean([each.relative_l2 for each in found])
    assert sum(a <= middle <= b for a, b in (each.relative_l2_interval for each in found)) >= 28


def test_a_perfect_lens_has_no_error_but_scatter(make_scene):
    scene = make_scene()
    # 144 cells a side do not fill 32 pixels evenly: the image scatters.
    found = [
        validate(
            scene, np.ones((32, 32)), {"lens.back": np.full((12, 10), 0.5)}, 16 * 36 * 36, seed
        )
        for seed in range(20)
    ]
    assert min(each.relative_l2 for each in found) > 0.05
    assert np.mean([each.relative_l2_corrected for each in found]) < 0.02
    assert sum(each.relative_l2_corrected_interval[0] == 0 for each in found) >= 19
