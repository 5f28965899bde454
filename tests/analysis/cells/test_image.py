"""Cells that are refined until the image is good enough."""

import math
import time

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.cells import image
from workbench.analysis.cells.image import imaging
from workbench.analysis.cells.lattice import CellLattice
from workbench.errors import Refused, RunFailed

POINT = {"kind": "point", "position": [0.3, -0.2, -4.0]}


def found(scene, heights, **named):
    steps, parts = imaging(scene, {"exit": heights}, **named), [0.0]
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


def test_finer_cells_where_more_accuracy_is_asked_for(make_scene):
    scene = make_scene()
    coarse, fine = (found(scene, waves(scene), accuracy=a) for a in (0.1, 0.001))
    assert coarse.cells[0] < fine.cells[0]
    assert fine.bound <= 0.001 < coarse.bound
    assert fine.cells[0] % (12 - 3) == fine.cells[1] % (10 - 3) == 0  # they end at knots


def test_a_plate_needs_the_first_levels_alone(make_scene):
    scene = make_scene()
    plate = found(scene, np.full((12, 10), 0.5), accuracy=1e-10)
    assert plate.bound < 1e-12
    assert plate.cells == (4 * 36, 4 * 35)
    assert plate.irradiance == pytest.approx(0.96**2 / 4, rel=1e-12)


def test_an_image_is_the_same_each_time(make_scene):
    scene = make_scene({"source": POINT})
    first, again = (found(scene, waves(scene)) for _ in range(2))
    assert np.array_equal(first.irradiance, again.irradiance)


def test_refining_ends_with_the_cells_that_are_allowed(make_scene, monkeypatch):
    monkeypatch.setattr(image, "_MOST", 200 * 200)
    reached = found(make_scene(), waves(make_scene()), accuracy=1e-9)
    assert reached.cells == (4 * 36, 4 * 35)
    assert 1e-9 < reached.bound < 0.1


def test_no_level_follows_more_rays_than_are_allowed_where_much_light_is_lost(
    make_scene, monkeypatch
):
    most, followed = 1 << 19, []

    class Counted(CellLattice):
        def tracing(self, threads=None):
            found = yield from super().tracing(threads)
            followed.append(self.rays)
            return found

    monkeypatch.setattr(image, "_MOST", most)
    monkeypatch.setattr(image, "_BEGIN", 1 << 15)
    monkeypatch.setattr(image, "CellLattice", Counted)
    near = {"kind": "grid", "center": [0, 0, -0.3], "half_width": [0.1, 0.1], "points": [2, 3]}
    scene = make_scene({"source": near, "screen.half_width": [3.0, 3.0]})
    # Waves so steep that they reflect much of the light totally, in many places.
    steep = net_of(scene, lambda x, y: 0.6 + 0.15 * np.sin(9 * x) * np.cos(8 * y))
    reached = found(scene, steep)
    assert len(followed) >= 3
    assert max(followed) <= most
    # Nodes alone would leave room for one more: rays in cells of which a part is lost count too.
    assert 4 * 6 * math.prod(reached.cells) < most < 4 * followed[-1]
    assert reached.bound > reached.wanted == image.ACCURACY


def test_sources_of_many_points_have_fewer_cells_for_each(make_scene, monkeypatch):
    monkeypatch.setattr(image, "_BEGIN", 6 * 64 * 60)
    grid = {"kind": "grid", "center": [0, 0, -4], "half_width": [1, 1], "points": [2, 3]}
    few = found(make_scene({"source": grid}), np.full((12, 10), 0.5), accuracy=1.0)
    assert few.cells == (4 * 15, 4 * 15)
    grid["points"] = [20, 30]
    assert found(make_scene({"source": grid}), np.full((12, 10), 0.5)) is None


def test_a_lens_without_light_on_the_screen_fails(make_scene):
    scene = make_scene({"screen.half_width": [0.01, 0.01]})
    slope = net_of(scene, lambda x, y: 0.5 + 0.45 * x + 0 * y)
    with pytest.raises(RunFailed, match="no light of this lens reaches the screen"):
        found(scene, slope)


def test_a_lens_that_is_no_body_is_refused(make_scene):
    with pytest.raises(Refused):
        found(make_scene(), np.full((12, 10), -0.5))


def test_leaving_it_ends_its_threads(make_scene):
    steps = imaging(make_scene({"source": POINT}), {"exit": waves(make_scene())}, accuracy=1e-9)
    next(steps)
    begun = time.monotonic()
    steps.close()
    assert time.monotonic() - begun < 30  # all levels take longer


def test_few_random_rays_allow_few_rays_of_cells(make_scene, monkeypatch):
    """The check is bounded by the rays that are asked for."""
    followed = []

    class Counted(CellLattice):
        def tracing(self, threads=None):
            found = yield from super().tracing(threads)
            followed.append(self.rays)
            return found

    monkeypatch.setattr(image, "CellLattice", Counted)
    monkeypatch.setattr(image, "_BEGIN", 1 << 15)
    scene = make_scene()
    few = found(scene, waves(scene), accuracy=1e-9, random_rays=1000)
    assert max(followed) <= 2 << 15
    more = found(scene, waves(scene), accuracy=1e-9, random_rays=20_000)
    assert max(few.cells) < max(more.cells)
    assert max(followed) <= 16 * 20_000


def test_light_that_most_cells_lose_in_part_is_left_to_random_rays(make_scene, monkeypatch):
    monkeypatch.setattr(image, "_BEGIN", 1 << 12)
    near = {"kind": "grid", "center": [0, 0, -0.3], "half_width": [0.1, 0.1], "points": [1, 1]}
    scene = make_scene({"source": near, "screen.half_width": [3.0, 3.0]})
    steep = net_of(scene, lambda x, y: 0.6 + 0.15 * np.sin(9 * x) * np.cos(8 * y))
    assert found(scene, steep, random_rays=100) is None
