"""Metrics of an image, and the light of regions."""

import math

import numpy as np
import pytest

from tests.scenes import changed
from workbench.analysis import metrics
from workbench.analysis.regions import light_of_areas, light_of_lit_area, light_of_regions
from workbench.analysis.validation import validate
from workbench.report.figures import region_rows
from workbench.scene import EllipseRegion, FarField, PolygonRegion, RectangleRegion, Scene, Screen


@pytest.fixture
def target(rng):
    """A disc with a soft edge on black."""
    y, x = np.mgrid[-1:1:24j, -1:1:32j]
    return (1.2 - 2 * np.hypot(x, y)).clip(0, 0.6)


def test_relative_l2_by_hand():
    target, image = np.array([[0.0, 2.0]]), np.array([[1.0, 1.0]])
    assert metrics.relative_l2(image, target) == pytest.approx(math.sqrt(0.5))
    assert metrics.relative_l2(np.zeros((1, 2)), target) == 1  # no light at all


class TestSsim:
    def test_window_by_hand(self, rng):
        image, target = rng.random((30, 30)), rng.random((30, 30))
        a, b = image / image.sum(), target / target.sum()
        a, b = a / b.max(), b / b.max()
        here = np.arange(-5, 6)
        window = np.exp(-(here[:, None] ** 2 + here[None, :] ** 2) / (2 * 1.5**2))
        window /= window.sum()
        scores = []
        padded = [np.pad(each, 5, mode="symmetric") for each in (a, b)]
        for row in range(30):
            for column in range(30):
                p, q = (each[row : row + 11, column : column + 11] for each in padded)
                mean_p, mean_q = (window * p).sum(), (window * q).sum()
                var_p, var_q = (
                    (window * p * p).sum() - mean_p**2,
                    (window * q * q).sum() - mean_q**2,
                )
                cov = (window * p * q).sum() - mean_p * mean_q
                luminance = (2 * mean_p * mean_q + 1e-4) / (mean_p**2 + mean_q**2 + 1e-4)
                scores.append(luminance * (2 * cov + 9e-4) / (var_p + var_q + 9e-4))
        assert metrics.ssim(image, target) == pytest.approx(np.mean(scores), rel=1e-10)


class TestRegions:
    TARGET = np.array([[1.0, 1.0, 0.5, 0.3, 0.0, 0.0]])

    def test_uniformity_is_relative_to_the_target(self):
        image = np.array([[2.0, 1.0, 1.0, 9.0, 9.0, 9.0]])  # ratios 2, 1, 2 where it is lit
        assert metrics.uniformity(image, self.TARGET) == pytest.approx(1 / (5 / 3))


def lit_scene(changes=None):
    return Scene.from_data(changed({"screen.pixels": [32, 32]} | (changes or {})))


def test_the_lit_area_has_an_average_and_both_uniformities():
    target = np.zeros((32, 32))
    target[8:24, 8:24] = 1.0
    image = 0.1 * target
    image[8, 8], image[9, 9] = 0.05, 0.2
    scene = lit_scene({"regions": [{"name": "Desk", "size": [0.25, 0.25]}]})
    lit, desk = light_of_areas(scene, target, image)
    mean = (254 * 0.1 + 0.05 + 0.2) / 256
    assert (lit.name, desk.name) == ("lit area of the target", "Desk")
    assert (lit.mean, lit.least, lit.most) == pytest.approx((mean, 0.05, 0.2))
    figures = list(lit.figures.values())
    assert figures[2:] == [
        f"{0.05 / mean:.3f} × average",
        f"{0.2 / mean:.3f} × average",
        f"{0.05 / mean:.3f}",
        "0.250",
    ]
    assert desk.uniformity == pytest.approx(1)


def test_a_pixel_that_is_lit_in_part_does_not_count_as_dark():
    target = np.zeros((32, 32))
    target[8:24, 8:24] = 1.0
    target[8:24, 8] = target[8, 8:24] = 0.6
    light = light_of_lit_area(lit_scene(), target, 0.1 * target)
    assert (light.mean, light.uniformity, light.least_over_most) == pytest.approx((0.1, 1, 1))


def test_a_photograph_has_no_lit_area_and_an_even_target_is_the_whole_receiver(rng):
    light = np.full((32, 32), 0.25)
    assert light_of_lit_area(lit_scene(), rng.random((32, 32)), light) is None
    assert light_of_lit_area(lit_scene(), np.ones((32, 32)), light).name == "whole receiver"
    dark = light_of_lit_area(lit_scene(), np.ones((32, 32)), 0 * light)
    assert (dark.uniformity, dark.figures["minimum"]) == (None, "–")


def test_light_of_a_known_flux_is_stated_in_lux():
    source = {"kind": "area", "center": [0, 0, -5], "half_width": [0.1, 0.1], "flux": 100.0}
    scene = lit_scene({"source": source})
    light = light_of_lit_area(scene, np.ones((32, 32)), np.full((32, 32), 0.25))
    assert light.figures["average"] == light.figures["minimum"] == "250 · 10³ lx"
    assert light.figures["part of the light"] == "100.00 % (100 lm)"


SCREEN = Screen(position=(0.0, 0.0, 5.0), half_width=(2.0, 1.0), pixels=(40, 20))


def ramp(receiver):
    """An image that rises along x from 0 to 2 times its mean, of flux 1."""
    n_x, n_y = receiver.pixels
    image = np.tile((np.arange(n_x) + 0.5) / n_x, (n_y, 1))
    return image / receiver.total(image)


def test_the_share_of_an_even_image_is_the_area_of_a_region():
    even = np.full((20, 40), 1 / 8)
    regions = [
        RectangleRegion(center=(0.1, -0.2), size=(0.33, 0.21)),
        EllipseRegion(size=(0.5, 0.5)),
        PolygonRegion(corners=((-0.5, -0.5), (0.5, -0.5), (0.0, 0.5))),
    ]
    shares = [light.share for light in light_of_regions(regions, SCREEN, even)]
    assert shares == pytest.approx([0.33 * 0.21, np.pi / 16, 0.5], rel=1e-5)


def test_mean_least_and_most_follow_a_ramp():
    image = ramp(SCREEN)
    right = RectangleRegion(name="Right", center=(0.25, 0.0), size=(0.5, 1.0))
    (light,) = light_of_regions([right], SCREEN, image)
    mean = 1 / 8
    assert light.share == pytest.approx(0.75)
    assert light.mean == pytest.approx(1.5 * mean)
    assert light.least == pytest.approx((1 + 1 / 40) * mean)
    assert light.most == pytest.approx((2 - 1 / 40) * mean)
    assert light.uniformity == pytest.approx((1 + 1 / 40) / 1.5)
    assert light.least_over_most == pytest.approx((1 + 1 / 40) / (2 - 1 / 40))


def test_a_dark_region_and_one_smaller_than_a_pixel_have_no_uniformity():
    dark = light_of_regions([RectangleRegion()], SCREEN, np.zeros((20, 40)))
    assert dark[0].uniformity is None
    # Its middle is a corner of four pixels.
    (small,) = light_of_regions([RectangleRegion(size=(0.01, 0.01))], SCREEN, ramp(SCREEN))
    assert small.least is None
    assert small.to_data()["uniformity"] is None
    assert small.mean == pytest.approx(1 / 8)


def test_flux_per_solid_angle_counts_by_the_solid_angle_of_pixels():
    far = FarField(half_angle=(60.0, 60.0), pixels=(30, 30))
    even = np.full((30, 30), 1.0)
    upper = RectangleRegion(center=(0.0, 0.25), size=(1.0, 0.5))
    (light,) = light_of_regions([upper], far, even)
    assert light.mean == pytest.approx(1)
    assert light.share == pytest.approx(far.total(even) / 2)


def test_a_check_tells_the_light_of_the_regions_of_its_scene():
    scene = Scene.from_data(changed({"regions": [{"name": "All", "size": [1, 1]}]}))
    plate = {"lens.back": np.full(scene.optic.net_shape, 0.5)}
    found = validate(scene, np.ones((32, 32)), plate, rays=10_000)
    (light,) = found.regions
    assert light.name == "All"
    assert light.share == pytest.approx(found.efficiency)
    assert found.to_data()["regions"][0]["share"] == light.share
    lit, row = region_rows(found)
    assert (lit.name, row.name) == ("whole receiver", "All")
    assert row.value.startswith(f"{100 * light.share:.2f} % of the light")
    assert found.to_data()["lit_area"]["uniformity"] == pytest.approx(found.quality.uniformity)
