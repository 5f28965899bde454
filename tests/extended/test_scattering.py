"""Kernels of diffusers, against their closed form and the random rays of the independent check."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from tests.diffusers import with_diffuser
from workbench.analysis.mitsuba_receivers import picture_of
from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.interfaces import ScatterBoundary
from workbench.errors import Refused
from workbench.extended.blurring import near
from workbench.extended.bound import Bound
from workbench.extended.deblur import spread_light, wanted_light
from workbench.extended.scatter_kernels import ScatteredRays
from workbench.extended.scattering import film_scene, scattering_of
from workbench.scene import Diffuser, Scene

_RAYS = 400_000


def _scene(**changes) -> Scene:
    return Scene.from_data(with_diffuser(**changes))


def _film(scene: Scene) -> Diffuser:
    assert scene.diffuser is not None
    return scene.diffuser


def _counted(scene: Scene, way: np.ndarray, shape: tuple[int, int], rng) -> np.ndarray:
    """Part of a ray's light in pixels about the one where it would land, by random rays."""
    away = scene.receiver.plane_z - _film(scene).position[2]
    start = np.array([0.0, 0.0, 0.0]) - away * way / way[2]
    places = np.tile(start, (_RAYS, 1))
    normal = np.array([[0.0, 0.0, 1.0]])
    boundary = ScatterBoundary(_film(scene))
    rays, lost = boundary.turn(
        TracedRays(places, way[None], np.ones(_RAYS)), Crossings(places, normal, np.ones(_RAYS))
    )
    assert lost["absorbed_diffuser"].sum() == pytest.approx(0.1 * _RAYS)
    assert np.all(rays.direction[:, 2] > 0)
    np.testing.assert_allclose(np.linalg.norm(rays.direction, axis=1), 1)
    hit = places + rays.direction * (away / rays.direction[:, 2:])
    side = 2 * scene.receiver.half_extent[0] / scene.receiver.pixels[0]
    # Light that is uniform in a pixel; rows go down.
    x, y = (hit[:, axis] / side + rng.random(_RAYS) - 0.5 for axis in (0, 1))
    edges = [np.arange(-(n // 2) - 0.5, n // 2 + 1) for n in shape]
    return np.histogram2d(-y, x, bins=edges)[0] / _RAYS


@pytest.mark.parametrize(
    ("scatter", "incidence"),
    [
        ({"kind": "lambertian"}, 0),
        ({"kind": "gaussian", "sigma": 6}, 0),
        ({"kind": "gaussian", "sigma": 6}, 40),
        ({"kind": "gaussian", "sigma": 30}, 40),
    ],
)
def test_a_kernel_is_what_random_rays_make(scatter, incidence, rng):
    scene, angle = _scene(scatter=scatter), math.radians(incidence)
    way = np.array([math.sin(angle), 0.0, math.cos(angle)])
    at = np.zeros(1)
    (kernel,) = ScatteredRays(_film(scene), scene.receiver, 1, at, at, way[None]).kernels()
    counted = _counted(scene, way, kernel.shape, rng)
    noise = math.sqrt(counted.sum() / _RAYS)
    assert np.linalg.norm(counted - kernel) < 1.2 * noise
    assert counted.sum() == pytest.approx(kernel.sum(), abs=3e-3)


def test_a_lambertian_kernel_is_its_closed_form():
    scene = _scene(scatter={"kind": "lambertian"})
    scattering = scattering_of(scene)
    assert scattering is not None
    ((kernel,),), away = scattering.kernels, 8.0
    rows, columns = np.indices(kernel.shape) - kernel.shape[0] // 2
    square = rows**2 + columns**2  # pixels are 1 wide
    form = away**2 / (math.pi * (away**2 + square) ** 2)
    np.testing.assert_allclose(kernel[square > 25], form[square > 25], rtol=5e-3)
    inside = square <= 30**2
    assert kernel[inside].sum() == pytest.approx(30**2 / (30**2 + away**2), abs=1e-3)


def test_the_receiver_of_undeflected_light_is_the_lambertian_film():
    data = with_diffuser({"kind": "lambertian"}, tilt=[0, 30, 0])
    data["images"][0]["receiver"] |= {"tilt": [0, 30, 0], "position": [1, 2, 45]}
    moved = film_scene(Scene.from_data(data)).receiver
    normal = np.array([0.5, 0.0, math.sqrt(0.75)])
    assert normal @ np.subtract(moved.position, [0, 0, 22]) == pytest.approx(0, abs=0.011)
    sideways = np.cross(normal, np.subtract(moved.position, [1, 2, 45]))
    np.testing.assert_allclose(sideways, 0, atol=1e-12)
    assert film_scene(_scene()) == _scene()


def test_a_gaussian_kernel_changes_with_the_direction_of_light():
    scene = _scene(scatter={"kind": "gaussian", "sigma": 3})

    def slanted(u, v):
        ways = np.stack([(u - v / 2) / 25, v / 25, np.ones_like(u)], axis=-1)
        return ways / np.linalg.norm(ways, axis=-1, keepdims=True)

    scattering = scattering_of(scene, slanted)
    assert scattering is not None
    factors = scattering.factors_at((40, 40), (0, 0))
    for row, column in ((20, 20), (2, 37), (30, 5)):
        kernels = scattering.kernels.mean(axis=1)
        found = kernels[0] + np.tensordot(factors[:, row, column], kernels[1:], 1)
        u, v = np.array([column - 19.5]), np.array([19.5 - row])
        ways = slanted(u, v)
        (exact,) = ScatteredRays(_film(scene), scene.receiver, 1, u, v, ways).kernels()
        more = [(a - b) // 2 for a, b in zip(found.shape, exact.shape, strict=True)]
        inner = found[more[0] : more[0] + len(exact), more[1] : more[1] + exact.shape[1]]
        assert np.linalg.norm(inner - exact) < 0.04 * np.linalg.norm(exact)
        assert found.sum() == pytest.approx(1, abs=1e-3)


def test_no_bound_is_known_behind_a_diffuser():
    bound = Bound(_scene(), np.ones((40, 40)))
    assert bound.sentences == ("Other elements, or a tilt, change the blur: no bound is known.",)
    assert bound.to_data()["relative_l2_bound"] is None


@pytest.mark.parametrize("use", [scattering_of, picture_of])
def test_a_receiver_of_another_kind_is_refused(use):
    scene = _scene()
    image = scene.images[0].model_copy(update={"receiver": SimpleNamespace(kind="dome")})
    with pytest.raises(Refused, match=r"dome.* use a plane or a far field"):
        use(scene.model_copy(update={"images": (image,)}))


def test_light_wanted_before_a_diffuser_is_sharper_than_the_target():
    scattering = scattering_of(_scene())
    assert scattering is not None
    x = np.abs(np.arange(40) - 19.5)
    target = np.where(np.hypot(x[:, None], x) < 10, 1.0, 0.1)
    light = spread_light(target, near(scattering.of_pixels[None], target.shape))
    wanted = wanted_light(target, scattering.of_pixels, (3, 2))
    assert wanted.shape == (44, 46)
    inside = wanted[2:-2, 3:-3]
    np.testing.assert_allclose(inside, inside.sum() * target / target.sum())
    assert 0.9 < wanted.sum() <= 1 + 1e-9
    assert light.min() >= 0
    assert light.max() / light.mean() > target.max() / target.mean()
