import math

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.validation import validate
from workbench.errors import RunFailed
from workbench.geometry.surface import ControlNet

INDEX = 1.5
HEAD_ON = 0.04  # ((1.5 - 1) / (1.5 + 1))²
ALIGNED = 16 * 64 * 64  # rays whose cells, 256 × 256, fill 32 × 32 pixels evenly


def uniform(scene):
    n_x, n_y = scene.receiver.pixels
    return np.ones((n_y, n_x))


def parts(account):
    data = account.to_data()
    return data.pop("emitted"), data


class TestFlatLens:
    def test_uniform_image_and_its_account(self, make_scene):
        scene = make_scene()
        found = validate(scene, uniform(scene), {"lens.back": np.full((12, 10), 0.5)}, ALIGNED)
        assert found.rays == ALIGNED
        assert found.relative_l2 < 1e-12
        assert found.loss < 1e-12
        assert found.noise < 1e-12
        assert found.irradiance == pytest.approx((1 - HEAD_ON) ** 2 / 4, rel=1e-12)
        account = found.account
        assert account.on_screen == pytest.approx((1 - HEAD_ON) ** 2, rel=1e-12)
        assert account.lost["fresnel_entrance"] == pytest.approx(HEAD_ON, rel=1e-12)
        assert account.lost["fresnel_exit"] == pytest.approx(HEAD_ON * (1 - HEAD_ON), rel=1e-12)
        for name in ("off_screen", "total_reflection", "missed_lens"):
            assert account.lost[name] == 0


@pytest.mark.parametrize("degree", [(1, 1), (2, 5), (3, 3), (7, 4)])
class TestPrism:
    """An inclined plane sends all light aside by one angle."""

    def found(self, make_scene, degree, slope_x, slope_y):
        scene = make_scene(
            {"lens.degree": degree, "lens.entrance_z": -1.0, "screen.half_width": [2.0, 2.0]}
        )
        x, y = ControlNet.of(scene.optic).positions
        heights = 0.5 + slope_x * x[:, None] + slope_y * y[None, :]
        return validate(scene, uniform(scene), {"lens.back": heights}, ALIGNED)

    @pytest.mark.parametrize("slope", [(0.2, 0.0), (-0.2, 0.0), (0.0, 0.2), (0.0, -0.2)])
    def test_side_and_shift(self, make_scene, degree, slope):
        image = self.found(make_scene, degree, *slope).irradiance
        column, row = np.meshgrid(np.arange(32) + 0.5, np.arange(32) + 0.5)
        mean = np.array([(image * column).sum(), (image * row).sum()]) / image.sum()
        angle = math.atan(0.2)
        shift = (5.0 - 0.5) * math.tan(math.asin(INDEX * math.sin(angle)) - angle)
        towards = np.array(slope) / 0.2 * [1, -1]  # row 0 is at +y
        assert mean == pytest.approx(16 + towards * shift * 8, abs=0.02)

    def test_losses(self, make_scene, degree):
        account = self.found(make_scene, degree, 0.3, -0.4).account
        refracted = math.asin(INDEX * math.sin(math.atan(0.5)))
        reflectance = HEAD_ON + (1 - HEAD_ON) * (1 - math.cos(refracted)) ** 5
        assert account.lost["fresnel_exit"] == pytest.approx((1 - HEAD_ON) * reflectance, rel=1e-9)

    def test_total_reflection(self, make_scene, degree):
        with pytest.raises(RunFailed, match="no light of this lens reaches the screen"):
            self.found(make_scene, degree, 0.9, 0.0)


class TestPlanoHyperbolicLens:
    """The Cartesian oval that brings collimated light to one point."""

    FOCUS = 4.5  # from the vertex at z = 0.5

    def sag(self, x, y):
        f, n = self.FOCUS, INDEX
        square = x**2 + y**2
        root = np.sqrt(((n - 1) * f) ** 2 + (n * n - 1) * square)
        return (root - (n - 1) * f) / (n * n - 1)

    def trace(self, make_scene, z, half_width, pixels):
        scene = make_scene(
            {
                "lens.degree": [5, 5],
                "lens.control_points": [40, 40],
                "screen.z": z,
                "screen.half_width": [half_width, half_width],
                "screen.pixels": pixels,
            }
        )
        heights = net_of(scene, lambda x, y: 0.5 - self.sag(x, y))
        return validate(scene, uniform(scene), {"lens.back": heights}, ALIGNED)

    def test_all_light_in_the_focus(self, make_scene):
        found = self.trace(make_scene, 5.0, 3e-6, [3, 3])
        assert found.irradiance[1, 1] * 4e-12 == pytest.approx(found.account.on_screen, rel=1e-12)
        assert found.account.lost["off_screen"] == 0

    def test_losses(self, make_scene):
        account = self.trace(make_scene, 5.0, 3e-6, [3, 3]).account
        node, share = np.polynomial.legendre.leggauss(60)
        x, y = node[:, None], node[None, :]
        t = self.sag(x, y)
        # From the optical path: ray and face normal at the exit, in air.
        ray = np.stack([-x + 0 * y, -y + 0 * x, self.FOCUS + t])
        ray /= np.linalg.norm(ray, axis=0)
        normal = np.stack([0 * t, 0 * t, INDEX + 0 * t]) - ray  # n d - t is along the normal
        normal /= np.linalg.norm(normal, axis=0)
        reflectance = HEAD_ON + (1 - HEAD_ON) * (1 - (ray * normal).sum(0)) ** 5
        mean = (reflectance * share[:, None] * share[None, :]).sum() / 4
        assert account.lost["fresnel_exit"] == pytest.approx((1 - HEAD_ON) * mean, rel=1e-6)


@pytest.fixture
def rough(make_scene, rng):
    """A lens that loses light in every way."""
    scene = make_scene({"screen.half_width": [0.8, 0.9], "screen.pixels": [16, 12]})
    return scene, 0.5 + 0.3 * rng.random((12, 10))


def test_the_account_adds_up(rough):
    scene, heights = rough
    emitted, where = parts(validate(scene, uniform(scene), {"lens.back": heights}, 100_000).account)
    assert sum(where.values()) == pytest.approx(emitted, abs=1e-12)
    assert where.pop("missed_lens") == where.pop("left_side") == 0
    assert min(where.values()) > 1e-3


class TestRays:
    def test_noise_is_an_upper_estimate_of_the_scatter_between_seeds(self, rough):
        scene, heights = rough
        runs = [
            validate(scene, uniform(scene), {"lens.back": heights}, 8_000, seed)
            for seed in range(30)
        ]
        scatter = np.std([run.relative_l2 for run in runs], ddof=1)
        noise = np.mean([run.noise for run in runs])
        assert scatter < noise < 6 * scatter
