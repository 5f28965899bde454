"""Elements that this program has not yet: the walk along a train asks for nothing else."""

import numpy as np
import pytest

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.surfaces import FlatFace
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.geometry.outlines import Rectangle

UP = np.array([[0.0, 0.0, 1.0]])


class Lamp:
    """Even light over a square, along the axis."""

    rays, beside = 20_000, 0.0

    def batch(self, number):
        place = np.random.default_rng(number).uniform(-1, 1, (self.rays, 3))
        yield TracedRays(place * [1, 1, 0], UP, np.ones(self.rays))


class RoundFace:
    missed = "beside_the_ring"

    def meet(self, rays):
        inside = np.hypot(*rays.position.T[:2]) < 0.5
        flux = np.where(inside, rays.flux, 0)
        return Crossings(rays.position, UP, flux, float(rays.flux.sum() - flux.sum()))


class GreyFilter:
    def turn(self, rays, crossings):
        lost = {"absorbed": 0.25 * float(crossings.flux.sum())}
        return rays._replace(flux=0.75 * crossings.flux), lost


class Halves:
    """Two pixels: left and right."""

    images, pixels = 1, 2

    def count(self, rays, flux, beside):
        right = rays.position[:, 0] > 0
        flux[0] += [rays.flux[~right].sum(), rays.flux[right].sum()]


def test_elements_of_new_kinds_are_followed_and_their_losses_counted():
    faces = [
        (FlatFace(0.0, Rectangle((1.0, 0.5)), "missed_lens"), GreyFilter()),
        (RoundFace(), GreyFilter()),
    ]
    train = OpticalTrain(Lamp(), faces, Halves())
    tally = Tally(1, 2)
    for rays in train.source.batch(1):
        train.walk(rays, tally)
    assert tally.emitted == Lamp.rays
    disc = np.pi * 0.25 / 4  # of the square
    assert tally.lost == pytest.approx(
        {
            "missed_lens": Lamp.rays / 2,
            "beside_the_ring": 0.75 * Lamp.rays * (0.5 - disc),
            "absorbed": 0.25 * Lamp.rays * (0.5 + 0.75 * disc),
        },
        rel=0.02,
    )
    assert tally.flux.sum() + sum(tally.lost.values()) == pytest.approx(tally.emitted)
    assert tally.flux[0] == pytest.approx(0.75**2 * Lamp.rays * disc / 2, rel=0.05)


def test_rays_are_followed_some_at_a_time_and_all_of_them():
    rays = next(Lamp().batch(3))
    for direction in (UP, UP.repeat(Lamp.rays, axis=0)):
        some = list(rays._replace(direction=direction).split(3000))
        assert [len(each.flux) for each in some] == [3000] * 6 + [2000]
        assert np.array_equal(np.vstack([each.position for each in some]), rays.position)
        assert all(len(each.direction) in (1, len(each.flux)) for each in some)
