"""Manufacturing processes of a scene: what they leave together, and what is refused."""

import math

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import Scene
from workbench.scene.making.process import Making
from workbench.scene.making.relief import FacePlaces, Grooves, RandomRelief, Terraces

_MILLED = {"kind": "milling", "ball_radius": 0.1, "step_over": 0.02}
_POLISHED = {"kind": "polishing", "width": 0.03}


def places_of(x, y, slope=(0.0, 0.0)):
    flat = np.zeros(x.size)
    return FacePlaces(x.ravel(), y.ravel(), flat + slope[0], flat + slope[1])


class TestTogether:
    def test_smoothing_adds_up_in_squares_and_reaches_what_was_before(self, make_scene):
        scene = make_scene({}).altered(processes=())
        data = scene.to_data() | {
            "processes": [_POLISHED, _MILLED, _POLISHED | {"width": 0.04, "depth": 0.01}]
        }
        making = Making.of(Scene.from_data(data).processes)
        assert making.smoothing == pytest.approx(0.05)
        assert making.removed == 0.01
        ((grooves, smoothing),) = making.reliefs
        assert (grooves.period, smoothing) == (0.02, 0.04)

    def test_shrinkages_multiply(self, make_scene):
        mould = {"kind": "moulding", "shrinkage": 0.01}
        printed = {"kind": "printing", "layer_height": 0.01, "pixel_size": 0.01, "shrinkage": 0.02}
        scene = Scene.from_data(make_scene({}).to_data() | {"processes": [mould, printed]})
        assert Making.of(scene.processes).factor == pytest.approx(0.99 * 0.98)

    def test_lengths_follow_the_unit(self, make_scene):
        scene = Scene.from_data(make_scene({}).to_data() | {"processes": [_MILLED, _POLISHED]})
        milling, polishing = scene.in_unit("mm").processes
        assert (milling.ball_radius, milling.step_over) == pytest.approx((1.0, 0.2))
        assert polishing.width == pytest.approx(0.3)
        assert Scene.from_data(scene.to_data()) == scene


@pytest.mark.parametrize(
    ("process", "message"),
    [
        (_MILLED | {"ball_radius": 3}, "ball_radius: 3 is too large for lens; at most 1"),
        (_MILLED | {"ball_radius": -1}, "ball_radius: "),
        (_MILLED | {"step_over": 0.2}, "step_over: 0.2 leaves ridges of the tool's own size"),
        ({"kind": "turning", "nose_radius": 0.01, "feed": 0.1}, "feed: 0.1 leaves ridges"),
        (_POLISHED | {"width": 0.5}, "width: 0.5 is too large for lens; at most 0.25"),
        ({"kind": "moulding", "shrinkage": 0.2}, "shrinkage: "),
        ({"kind": "figure_error", "slope": -1, "length": 1}, "slope: "),
        ({"kind": "forging"}, "kind"),
    ],
)
def test_refused(make_scene, process, message):
    data = make_scene({}).to_data() | {"processes": [process]}
    with pytest.raises(Refused) as refused:
        Scene.from_data(data)
    assert str(refused.value).startswith("processes[0]")
    assert message in str(refused.value)


class TestGrooves:
    def test_slopes_on_a_plane_are_uniform_up_to_those_of_the_ridges(self):
        y = np.linspace(0, 10, 40_001)
        dx, dy = Grooves(1.5, 0.25, (0.0, 1.0)).slopes(places_of(0 * y, y), 0.0)
        assert not dx.any()
        assert np.abs(dy).max() == pytest.approx(0.125 / 1.5, rel=1e-3)
        assert dy.std() == pytest.approx(0.125 / 1.5 / math.sqrt(3), rel=1e-3)

    @pytest.mark.parametrize("smoothing", [0.01, 0.03, 0.06, 0.12])
    def test_polishing_damps_each_harmonic_as_a_gaussian_does(self, smoothing):
        y = (np.arange(1000) + 0.5) / 1000 * 0.25
        sharp, polished = (
            Grooves(1.5, 0.25, (0.0, 1.0)).slopes(places_of(0 * y, y), width)[1]
            for width in (0.0, smoothing)
        )
        waves = np.fft.rfft(sharp) * np.exp(-2 * (np.pi * np.arange(501) * smoothing / 0.25) ** 2)
        assert polished == pytest.approx(np.fft.irfft(waves), abs=1e-4)

    def test_turning_goes_around_the_axis(self):
        angle = np.linspace(0, 2 * np.pi, 7)
        x, y = 1.03 * np.cos(angle), 1.03 * np.sin(angle)
        dx, dy = Grooves(0.5, 0.1).slopes(places_of(x, y), 0.0)
        outward = (dx * x + dy * y) / 1.03
        assert np.ptp(outward) < 1e-12
        assert dx * y == pytest.approx(dy * x, abs=1e-12)


def test_terraces_keep_the_mean_slope():
    x = np.linspace(0, 10, 100_001)
    places = places_of(x, 0 * x, slope=(0.3, 0.0))
    for width in (0.005, 0.05, 0.5):
        dx, dy = Terraces(0.05, width).slopes(places, 0.0)
        assert dx[:-1].mean() == pytest.approx(0, abs=2e-3)
        assert not dy.any()
    assert np.abs(dx).max() < 1e-6  # smooth
    coarse = Terraces(0.05, 0.005).slopes(places, 0.0)[0]
    assert np.median(coarse) == pytest.approx(-0.3)  # level between steps


class TestRandomRelief:
    error = RandomRelief(1e-3, 2.0, 5)

    def test_slopes_are_those_asked_for_and_of_its_heights(self, rng):
        x, y = rng.uniform(-50, 50, (2, 20_000))
        dx, dy = self.error.slopes(places_of(x, y), 0.0)
        assert math.sqrt((dx**2 + dy**2).mean()) == pytest.approx(1e-3, rel=0.05)
        step = 1e-4
        ends = [self.error.heights(np.array([3 + s]), np.array([1.0]), 0.0) for s in (step, -step)]
        (slope,), _ = self.error.slopes(places_of(np.array([3.0]), np.array([1.0])), 0.0)
        assert slope == pytest.approx((ends[0] - ends[1]).item() / (2 * step), rel=1e-6)

    def test_long_and_short_waves_are_all_of_it(self, rng):
        x, y = rng.uniform(-50, 50, (2, 100))
        whole, *parts = (
            np.array(each.slopes(places_of(x, y), 0.1))
            for each in (self.error, *self.error.split(1.0))
        )
        assert sum(parts) == pytest.approx(whole, abs=1e-15)

    def test_smoothing_over_its_length_takes_it_away(self, rng):
        x, y = rng.uniform(-50, 50, (2, 1000))
        places = places_of(x, y)
        sharp, one, four = (np.std(self.error.slopes(places, w)) for w in (0.0, 1.0, 4.0))
        assert one / sharp == pytest.approx(4 / (4 + 4), rel=0.15)  # l² / (l² + 4 σ²)
        assert four / sharp == pytest.approx(4 / (4 + 64), rel=0.5)
