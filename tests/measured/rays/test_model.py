"""Points that stand for rays."""

import numpy as np
import pytest

from tests.lamps import led
from workbench.measured.lamps import of_known_size, placed_rays, ray_model
from workbench.measured.rays.model import _misplaced_flux
from workbench.scene import Scene


@pytest.fixture
def scene(make_scene, tmp_path) -> Scene:
    return make_scene({"source": led(tmp_path)})


def test_rays_are_turned_moved_and_measured_in_the_unit_of_the_scene(scene):
    rays = placed_rays(scene.source)

    x, y, z = rays.position.T - np.array([[0.1], [0.0], [-3.0]])
    back = np.radians(-30)
    along = x * np.cos(back) - y * np.sin(back), x * np.sin(back) + y * np.cos(back)
    assert [np.abs(part).max() for part in along] == pytest.approx([0.25, 0.15], abs=1e-3)
    assert np.abs(z).max() < 1e-6
    assert rays.flux.sum() == pytest.approx(1)
    in_mm = placed_rays(scene.in_unit("mm").source)
    assert np.allclose(in_mm.position, 10 * rays.position)


def test_points_stand_on_the_emitter_and_have_the_light_of_its_rays(scene):
    model = ray_model(scene.source, scene.optic, 16)

    assert len(model.places) == 16
    assert np.allclose(model.places[:, 2], -3, atol=0.1)
    assert np.allclose(model.places.mean(axis=0)[:2], [0.1, 0], atol=0.01)
    assert model.spread < 0.35  # 1/4, for points on a grid of 4 × 4
    steps = (2 * (np.arange(300) + 0.5) / 300 - 1) * 0.9
    across, up = (part.ravel() for part in np.meshgrid(steps, steps))
    flux = 0.0
    for k, place in enumerate(model.places):
        ways = across - place[0], up - place[1], np.full(len(up), -place[2])
        length = np.sqrt(np.square(ways).sum(axis=0))
        ahead = tuple(way / length for way in ways)
        lit = model.intensity(np.full(len(up), k), ahead) * ahead[2] / length**2
        flux += lit.sum() * (1.8 / 300) ** 2
    x, y, come = placed_rays(scene.source).onto(0.0)
    come &= (np.abs(x) <= 0.9) & (np.abs(y) <= 0.9)
    assert flux == pytest.approx(come.mean(), rel=0.005)


@pytest.mark.parametrize(("outline", "half_width"), [("rectangle", 0.25), ("ellipse", 0.2)])
def test_size_of_a_model_is_that_of_the_uniform_emitter_of_its_rays(
    make_scene, tmp_path, outline, half_width
):
    source = led(tmp_path)
    if outline == "ellipse":
        path = tmp_path / "led.tm25ray"
        table = np.frombuffer(path.read_bytes(), "<f4").copy()
        starts = table[-200_000 * 7 :].reshape(-1, 7)
        turn, radius = 2 * np.pi * (starts[:, 0] / 5 + 0.5), 2 * np.sqrt(starts[:, 1] / 3 + 0.5)
        starts[:, 0], starts[:, 1] = radius * np.cos(turn), radius * np.sin(turn)
        path.write_bytes(table.tobytes())
    scene = make_scene({"source": source | {"rotation": [0.0, 0.0, 0.0]}})

    found = of_known_size(scene.source, scene.optic)

    assert found.outline == outline
    assert found.position == pytest.approx((0.1, 0.0, -3.0), abs=0.05)
    assert found.half_width[0] == pytest.approx(half_width, rel=0.02)
    assert of_known_size(found, scene.optic) is found


def test_model_states_how_far_its_light_on_the_lens_is_from_its_rays(scene):
    rays = placed_rays(scene.source)
    x, y, come = rays.onto(0.0)
    r_x, r_y = scene.optic.half_width
    come &= (np.abs(x) <= r_x) & (np.abs(y) <= r_y)
    model = ray_model(scene.source, scene.optic, 16)
    assert 0 < model.off < 0.05
    assert f"16 points stand for the rays of the file: {100 * model.off:.1f} %" in model.note
    # All light on one side of the lens in place of an even one is half of it elsewhere.
    radiance = model.radiance.copy()
    half = radiance.shape[1] // 2
    radiance[:, :half] = 0.0
    radiance[:, half:] *= 2
    one_sided = model._replace(radiance=radiance)
    crossing = np.column_stack([x, y])[come]
    assert _misplaced_flux(one_sided, crossing, rays.flux[come], (r_x, r_y)) == pytest.approx(
        0.5, abs=0.08
    )
