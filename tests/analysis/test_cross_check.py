"""Mitsuba 3 and the independent check see the same light of the same lens."""

import math
import sys

import numpy as np
import pytest

from tests.lamps import crooked_lamp, led
from workbench.analysis import mitsuba as other
from workbench.analysis import mitsuba_elements
from workbench.analysis.cross_check import bare_and_clear, cross_check
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet

POINT = {"kind": "point", "position": [0.3, -0.2, -4.0], "rays": 1000}
GRID = {
    "kind": "grid",
    "center": [0.1, 0.2, -4.0],
    "half_width": [0.5, 0.3],
    "points": [3, 2],
    "rays": 100,
}
SOURCES = {
    "collimated": {"kind": "collimated"},
    "point": POINT,
    "lambertian": POINT | {"emission": "lambertian"},
    "grid": GRID,
    "tilted": {"kind": "collimated", "direction": [4.0, -6.0]},
    "beam": {"kind": "collimated", "direction": [3.0, 2.0]}
    | {"profile": {"kind": "gaussian", "radius": 1.0}},
}
AREA = {"kind": "area", "center": [0.2, -0.1, -3.0], "half_width": [0.3, 0.2]}
DISC = {"kind": "collimated", "direction": [2.0, 3.0], "angular_diameter": 4.0}
EXTENDED = {
    "disc": DISC,
    "beam from a disc": DISC | {"profile": {"kind": "gaussian", "radius": 0.6}},
    "rectangle": AREA,
    "even rectangle": AREA | {"emission": "uniform"},
    "ellipse": AREA | {"outline": "ellipse"},
    "even ellipse": AREA | {"outline": "ellipse", "emission": "uniform"},
}


def test_the_extra_is_named_where_it_is_missing(make_scene, monkeypatch):
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    with pytest.raises(Refused, match=r"freeform-lens-workbench\[mitsuba\]"):
        other.MitsubaScene(make_scene(), {"lens.back": np.full((12, 10), 0.5)})


class TestBareAndClear:
    def test_losses_unknown_to_mitsuba_are_left_out_and_named(self, make_scene):
        lossy = {"lens.coating": [0.01, 0.02], "lens.absorption": 0.3}
        scene, left_out = bare_and_clear(make_scene(lossy))
        assert left_out == ("coating", "absorption")
        assert scene == make_scene({"lens.reflection": "fresnel"})
        scene, left_out = bare_and_clear(make_scene({"lens.reflection": "none"}))
        assert left_out == ("reflectance of the faces",)
        assert scene == make_scene({"lens.reflection": "fresnel"})


@pytest.mark.full
class TestWithMitsuba:
    @pytest.fixture(autouse=True)
    def coarse_mesh(self, monkeypatch):
        pytest.importorskip("mitsuba")
        monkeypatch.setattr(mitsuba_elements, "_CELLS", 96)

    @staticmethod
    def lopsided(scene):
        """A face that gathers light beside the axis, differently along x and y."""
        x, y = ControlNet.of(scene.optic).positions
        x, y = x[:, None], y[None, :]
        return 0.5 - 0.05 * x**2 + 0.03 * y**2 + 0.04 * x + 0.03 * x * y**2 - 0.02 * y

    @pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
    @pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
    def test_both_see_the_same(self, make_scene, source, outline):
        screen = {"z": 4.0, "half_width": [1.2, 0.9], "pixels": [32, 24]}
        changes = {"lens.half_width": [1.0, 0.8], "source": source, "screen": screen}
        scene = make_scene(changes | {"lens.outline": outline})
        lens = self.lopsided(scene)
        found = cross_check(scene, np.ones((24, 32)), {"lens.back": lens}, 200_000)
        assert found.difference == pytest.approx(found.noise, rel=0.15)
        low, high = found.difference_corrected_interval
        assert 3 * low**2 < high**2  # less than 4 standard deviations above nothing
        assert high < found.difference
        # 4 standard deviations of the light on 32 × 24 pixels, and what Schlick leaves out.
        slack = 4 * found.noise / math.sqrt(32 * 24) + 0.002
        assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=slack)
        error = found.mitsuba.relative_l2_corrected
        assert error == pytest.approx(found.ours.relative_l2_corrected, abs=found.noise)

    @pytest.mark.slow
    @pytest.mark.parametrize("source", EXTENDED.values(), ids=EXTENDED)
    def test_both_see_the_same_of_extended_light(self, make_scene, source):
        self.test_both_see_the_same(make_scene, source, "ellipse")

    @pytest.mark.slow
    def test_both_see_the_rays_of_a_file(self, make_scene, tmp_path):
        self.test_both_see_the_same(make_scene, led(tmp_path), "rectangle")

    @pytest.mark.slow
    @pytest.mark.parametrize("receiver", ["tilted", "far field"])
    def test_both_see_the_same_on_other_receivers(self, make_scene, receiver):
        screen = {"z": 5.0, "half_width": [1.6, 1.2], "pixels": [32, 24]}
        screen |= {"center": [0.6, 0.2], "tilt": [10.0, 40.0]}
        # With the sharp rim of the beam in it.
        far_field = {"half_angle": [4.0, 4.0], "center": [1.4, -0.2], "pixels": [32, 32]}
        changes = {
            "tilted": {"screen": screen},
            "far field": {"screen": None, "far_field": far_field},
        }
        scene = make_scene(changes[receiver])
        target = np.ones(scene.receiver.pixels[::-1])
        found = cross_check(scene, target, {"lens.back": self.lopsided(scene)}, 1_000_000)
        assert found.difference == pytest.approx(found.noise, rel=0.15)
        low, high = found.difference_corrected_interval
        assert 3 * low**2 < high**2
        assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.005)

    def test_both_see_the_light_of_a_photometric_file(self, make_scene, tmp_path):
        self.test_both_see_the_same(make_scene, crooked_lamp(tmp_path), "rectangle")

    def test_steep_light_of_exact_faces_is_as_bright_for_both(self, make_scene):
        """Schlick's approximation lets 4 % more of it through."""
        source = {"kind": "point", "position": [6.0, 0.0, -3.0]}
        screen = {"z": 4.0, "half_width": [12.0, 12.0], "pixels": [8, 8]}
        changes = {"source": source, "screen": screen}
        plate, target = {"lens.back": np.full((12, 10), 0.5)}, np.ones((8, 8))
        found = {
            reflection: cross_check(
                make_scene(changes | {"lens.reflection": reflection}), target, plate, 400_000
            )
            for reflection in ("fresnel", "schlick")
        }
        exact, approximate = (each.ours.efficiency for each in found.values())
        theirs = found["fresnel"].mitsuba.efficiency
        assert exact == pytest.approx(theirs, rel=0.01)
        assert approximate > 1.03 * theirs

    def test_another_lens_differs_beyond_the_noise(self, make_scene, monkeypatch):
        scene, dense = make_scene(), make_scene({"lens.refractive_index": 1.6})
        lens, target = self.lopsided(scene), np.ones((32, 32))
        trace = other.MitsubaScene(dense, {"lens.back": lens})
        monkeypatch.setattr("workbench.analysis.cross_check.MitsubaScene", lambda *task: trace)
        found = cross_check(scene, target, {"lens.back": lens}, 100_000)
        assert found.difference > 2 * found.noise
        assert found.difference_corrected_interval[0] > found.noise

    def test_pixels_that_are_not_square_are_refused(self, make_scene):
        scene = make_scene({"screen.pixels": [32, 31]})
        with pytest.raises(
            Refused, match=r"receiver.pixels: \[32, 31\] on \[1, 1\] are not square"
        ):
            other.MitsubaScene(scene, {"lens.back": np.full((12, 10), 0.5)})
