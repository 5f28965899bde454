"""Rays that are given to Mitsuba are those of the source."""

import math

import numpy as np
import pytest

from resources import path
from workbench.analysis.mitsuba import MitsubaScene
from workbench.analysis.mitsuba_rays import _from_area, _from_disc
from workbench.scene import Scene

COUNT = 100_000


def found(draw, scene):
    return draw(scene.source, scene.optic, np.random.default_rng(3), COUNT)


def test_light_of_a_disc_is_even_in_solid_angle(make_scene):
    scene = make_scene({"source": {"kind": "collimated", "angular_diameter": 60.0}})
    light = found(_from_disc, scene)
    assert np.linalg.norm(light.way, axis=1) == pytest.approx(1.0)
    lowest = math.cos(math.radians(30))
    assert light.way[:, 2].min() > lowest
    counts = np.histogram(light.way[:, 2], 10, (lowest, 1.0))[0]
    assert counts == pytest.approx(COUNT / 10, rel=0.06)
    assert light.flux.sum() == pytest.approx(light.emitted)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_rays_of_an_emitter_come_from_its_face(make_scene, outline):
    emitter = {"kind": "area", "center": [0.1, 0.2, -3.0], "half_width": [0.4, 0.2]}
    scene = make_scene({"source": emitter | {"outline": outline, "emission": "uniform"}})
    light = found(_from_area, scene)
    back = (scene.optic.entrance_z + 3.0) / light.way[:, 2]
    x = (light.x - back * light.way[:, 0] - 0.1) / 0.4
    y = (light.y - back * light.way[:, 1] - 0.2) / 0.2
    far = np.hypot(x, y) if outline == "ellipse" else np.maximum(abs(x), abs(y))
    assert far.max() <= 1 + 1e-6
    assert (far < 0.5).mean() == pytest.approx(0.25, rel=0.03)
    # From afar: the solid angle of the face over that of the half-space.
    r_x, r_y = scene.optic.half_width
    x, y = np.meshgrid(np.linspace(-r_x, r_x, 101), np.linspace(-r_y, r_y, 101))
    h = scene.optic.entrance_z + 3.0
    solid = 4 * r_x * r_y * np.mean(h / ((x - 0.1) ** 2 + (y - 0.2) ** 2 + h**2) ** 1.5)
    assert light.flux.sum() / light.emitted == pytest.approx(solid / (2 * math.pi), rel=0.02)


@pytest.mark.full
class TestWithMitsuba:
    @pytest.fixture(autouse=True)
    def coarse_mesh(self, monkeypatch):
        pytest.importorskip("mitsuba")
        monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)

    def test_the_disc_lights_a_plate(self, make_scene):
        """Its light is nearly straight, so that faces reflect 4 % each."""
        changes = {"source": {"kind": "collimated", "angular_diameter": 2.0}}
        plate = {"lens.back": np.full((12, 10), 0.5)}
        screen = {"z": 4.0, "half_width": [2.0, 2.0], "pixels": [32, 32]}
        flux = MitsubaScene(make_scene(changes | {"screen": screen}), plate).flux(50_000, 1)
        assert flux.sum() == pytest.approx(0.96**2, rel=0.01)

    def test_light_that_a_mirror_folds_passes_the_places_where_it_begins(self):
        """Only the faces of the plate behind the mirror take some of it."""
        scene = Scene.from_json(path("examples", "fold-mirror.json").read_bytes()).with_net((6, 6))
        plate = {"lens.back": np.full((6, 6), scene.optic.base.height)}
        flux = MitsubaScene(scene, plate).flux(200_000, 1)
        index = scene.optic.lit(scene.source.wavelength).index
        passed = 1 - ((index - 1) / (index + 1)) ** 2
        assert flux.sum() == pytest.approx(passed**2, abs=2e-3)
