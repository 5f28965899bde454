"""Cells that are refined until the image is good enough."""

import time

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.cells.image import imaging
from workbench.errors import RunFailed

POINT = {"kind": "point", "position": [0.3, -0.2, -4.0]}


def found(scene, heights, **named):
    steps, parts = imaging(scene, {"lens.back": heights}, **named), [0.0]
    while True:
        try:
            parts.append(next(steps))
        except StopIteration as end:
            assert parts == sorted(parts)
            assert parts[-1] <= 1
            return end.value


def waves(scene):
    return net_of(scene, lambda x, y: 0.5 + 0.02 * np.sin(6 * x) * np.cos(5 * y + x))


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT])
@pytest.mark.parametrize(
    ("degree", "finest"), [((1, 2), 0.01), ((2, 3), 0.002), ((3, 3), 0.002), ((5, 4), 0.002)]
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


def test_an_image_is_the_same_each_time(make_scene):
    scene = make_scene({"source": POINT})
    first, again = (found(scene, waves(scene)) for _ in range(2))
    assert np.array_equal(first.irradiance, again.irradiance)


def test_a_lens_without_light_on_the_screen_fails(make_scene):
    scene = make_scene({"screen.half_width": [0.01, 0.01]})
    slope = net_of(scene, lambda x, y: 0.5 + 0.45 * x + 0 * y)
    with pytest.raises(RunFailed, match="no light of this lens reaches the screen"):
        found(scene, slope)


def test_leaving_it_ends_its_threads(make_scene):
    steps = imaging(
        make_scene({"source": POINT}), {"lens.back": waves(make_scene())}, accuracy=1e-9
    )
    next(steps)
    begun = time.monotonic()
    steps.close()
    assert time.monotonic() - begun < 30  # all levels take longer
