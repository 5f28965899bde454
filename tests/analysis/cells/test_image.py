"""Cells that are refined until the image is good enough."""

import threading

import numpy as np
import pytest

from tests.analysis.lenses import followed, net_of
from workbench.analysis.cells.image import imaging
from workbench.analysis.validation import validate
from workbench.errors import RunFailed

POINT = {"kind": "point", "position": [0.3, -0.2, -4.0]}


def found(scene, heights, **named):
    return followed(imaging(scene, {"lens.back": heights}, **named))


def waves(scene):
    return net_of(scene, lambda x, y: 0.5 + 0.02 * np.sin(6 * x) * np.cos(5 * y + x))


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT])
@pytest.mark.parametrize(
    ("degree", "finest"), [((1, 2), 0.03), ((2, 3), 0.002), ((3, 3), 0.002), ((5, 4), 0.002)]
)
def test_the_error_is_within_its_bound(make_scene, source, degree, finest):
    scene = make_scene(
        {"lens.degree": degree, "lens.control_points": [20, 24], "source": source}
        | {"screen.half_width": [1.5, 1.3]}
    )
    exact = found(scene, waves(scene), accuracy=finest).irradiance
    for accuracy in (0.3, 4 * finest):
        coarse = found(scene, waves(scene), accuracy=accuracy)
        error = np.linalg.norm(coarse.irradiance - exact) / np.linalg.norm(exact)
        assert error < coarse.bound <= accuracy
        assert coarse.bound < 5 * error + finest


@pytest.mark.parametrize("source", [POINT, {"kind": "collimated", "angular_diameter": 6.0}])
def test_an_image_far_from_its_target_takes_fewer_cells(make_scene, source):
    scene = make_scene({"source": source, "screen.half_width": [1.5, 1.3]})
    exact = found(scene, waves(scene), accuracy=1e-3)
    there = exact.irradiance.sum() / exact.irradiance.size
    stripes = there * (np.arange(32) % 2) * np.ones((32, 1))
    # The error of the stripes, and of an image that is nearly the target.
    for part, fewer in ((1.0, True), (0.01, False)):
        target = part * stripes + (1 - part) * exact.irradiance
        image = found(scene, waves(scene), accuracy=1e-3, target=target)
        assert (image.cells < exact.cells) is fewer
        error, bound = image.error(target)
        assert bound <= (error / 20 if fewer else 2e-3)
        assert abs(error - exact.error(target)[0]) < bound


def test_an_image_is_the_same_each_time(make_scene):
    scene = make_scene({"source": POINT})
    first, again = (found(scene, waves(scene)) for _ in range(2))
    assert np.array_equal(first.irradiance, again.irradiance)


def test_a_lens_without_light_on_the_screen_has_no_image(make_scene):
    scene = make_scene({"screen.half_width": [0.01, 0.01]})
    slope = net_of(scene, lambda x, y: 0.5 + 0.45 * x + 0 * y)
    assert found(scene, slope) is None
    with pytest.raises(RunFailed, match="no light of this lens reaches the screen"):
        validate(scene, np.ones((32, 32)), {"lens.back": slope}, rays=10_000, accuracy=1e-3)


@pytest.mark.usefixtures("fewer_rays")
@pytest.mark.parametrize("kind", ["area", "point"])
@pytest.mark.parametrize("distance", [1e-4, 1e-9])
def test_a_source_that_nearly_touches_the_lens_is_checked(make_scene, kind, distance):
    """Cells that meet no light leave the check to random rays, which find what a plate does."""
    place = {"position" if kind == "point" else "center": [0, 0, -distance]}
    wide = {"half_width": [0.1, 0.1]} if kind == "area" else {}
    source = {"kind": kind, "emission": "lambertian"} | place | wide
    scene = make_scene({"version": 2, "source": source, "lens.reflection": "none"})
    plate = {"lens.back": np.full(scene.optic.net_shape, 0.5)}
    check = validate(scene, np.ones((32, 32)), plate, rays=50_000, accuracy=0.05)
    assert check.contradiction is None
    square, around, *off = np.random.default_rng(1).random((4, 400_000))
    inside = 0.5 * np.sqrt(square / (1.5**2 - square)) + 4.5 * np.sqrt(square / (1 - square))
    x, y = (
        inside * turn(2 * np.pi * around) + (kind == "area") * 0.1 * (2 * each - 1)
        for turn, each in zip((np.cos, np.sin), off, strict=True)
    )
    exact = np.mean((abs(x) < 1) & (abs(y) < 1))
    assert check.efficiency == pytest.approx(exact, rel=0.05)
    assert check.verified.efficiency == pytest.approx(exact, rel=0.05)


def test_leaving_it_ends_its_threads(make_scene):
    steps = imaging(
        make_scene({"source": POINT}), {"lens.back": waves(make_scene())}, accuracy=1e-9
    )
    before = threading.active_count()
    next(steps)
    steps.close()
    assert threading.active_count() == before
