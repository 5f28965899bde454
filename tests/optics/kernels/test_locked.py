"""Rays that see locked control points alone are traced once."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.kernels import collimated
from workbench.optics.kernels.collimated import FusedCollimatedRays
from workbench.optics.kernels.grid import make_axis
from workbench.optics.kernels.locked import count, split
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.scene import BoxFilter

NET = ControlNet((12, 10), (3, 2), (1.0, 2.0))


def rays(halved=(False, False)):
    def places(axis):
        count = (40, 30)[axis]
        return (np.arange(count // 2 if halved[axis] else count) + 0.5) / count

    return tuple(make_axis(NET, axis, places(axis), np.float64) for axis in (0, 1))


def lock(*free):
    locked = np.ones(NET.shape, bool)
    for point in free:
        locked[point] = False
    return locked


def sees(axis, free):
    return [free in range(first, first + axis.value.shape[1]) for first in axis.first.tolist()]


def test_the_rectangle_is_the_smallest_that_sees_all_free_points():
    all_rays = rays()
    moving, still = split(all_rays, lock((4, 5), (6, 3)))
    for axis, whole, points in zip(moving, all_rays, [(4, 6), (5, 3)], strict=True):
        seeing = np.logical_or(*(sees(whole, point) for point in points))
        begin, *_, last = np.flatnonzero(seeing)
        np.testing.assert_array_equal(axis.place, whole.place[begin : last + 1])
    assert count(moving) + sum(map(count, still)) == count(all_rays)
    places = [(x, y) for a, b in [moving, *still] for x in a.place for y in b.place]
    assert len(set(places)) == count(all_rays)


@pytest.mark.parametrize("free", [(0, 0), (11, 9), (0, 9)])
def test_corners_leave_two_rectangles(free):
    moving, still = split(rays(), lock(free))
    assert 0 < count(moving) < 1200
    assert len(still) == 2


def test_all_locked_leaves_nothing_to_trace_again():
    moving, still = split(rays(), lock())
    assert count(moving) == 0
    assert sum(map(count, still)) == 1200


def test_none_locked_leaves_nothing_still():
    moving, still = split(rays(), np.zeros(NET.shape, bool))
    assert count(moving) == 1200
    assert still == ()
    assert split(rays(), None)[1] == ()


@pytest.fixture
def scene(make_scene):
    return make_scene({"source.rays": [96, 80], "filter.size": [5, 3]})


def lenses(scene, locked, rng, number=3):
    """Lenses that differ at free control points alone."""
    heights = 0.5 + 0.03 * rng.normal(size=(number, *locked.shape))
    return [torch.as_tensor(np.where(locked, heights[0], each)) for each in heights]


def seen(plan, heights, cotangent):
    heights = heights.clone().requires_grad_()
    traced = plan.trace({"exit": heights})
    (gradient,) = torch.autograd.grad((traced.flux * cotangent).sum(), heights)
    return traced.flux.detach(), gradient, traced.account


@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
@pytest.mark.parametrize("mirrored", [(False, False), (True, False), (True, True)])
def test_image_and_gradient_are_those_of_the_full_trace(scene, rng, dtype, mirrored):
    locked = np.ones((12, 10), bool)
    locked[2:4, 1:3] = False
    for axis in (0, 1):
        if mirrored[axis]:
            locked &= np.flip(locked, axis)
    some, full = (
        Plan(scene, dtype=dtype, mirrored=mirrored, locked=each) for each in (locked, None)
    )
    assert "locked control points" in " ".join(some.notes)
    cotangent = torch.as_tensor(rng.normal(size=(32, 32)), dtype=dtype)
    close = 2e-5 if dtype == torch.float32 else 1e-12
    for heights in lenses(scene, locked, rng):
        for axis in (0, 1):
            if mirrored[axis]:
                heights = (heights + heights.flip(axis)) / 2
        image, gradient, account = seen(some, heights, cotangent)
        true_image, true_gradient, true_account = seen(full, heights, cotangent)
        assert (image - true_image).abs().sum() < close
        free = torch.as_tensor(~locked)
        error = (gradient - true_gradient)[free].norm() / true_gradient[free].norm()
        assert error < 20 * close
        assert list(account.to_data().values()) == pytest.approx(
            list(true_account.to_data().values()), abs=close
        )


def test_still_rays_are_traced_for_the_first_lens_alone(scene, rng, monkeypatch):
    locked = np.ones((12, 10), bool)
    locked[:3, :3] = False
    path = Path.of(scene, ControlNet.of(scene.lens), torch.float64, samples=(96, 80))
    tracer = FusedCollimatedRays(path, locked=locked)
    traced = []
    loops = collimated.LOOPS

    def counting(heights, bases, light, spread, begin, end, canvas, sums):
        traced.append((end - begin) * len(bases[1].place))
        loops.trace(heights, bases, light, spread, begin, end, canvas, sums)

    monkeypatch.setattr(collimated, "LOOPS", loops._replace(trace=counting))
    first, *others = lenses(scene, locked, rng)
    tracer.image({"exit": first}, scene.filter)
    assert sum(traced) == 96 * 80
    for heights in others:
        traced.clear()
        tracer.image({"exit": heights}, scene.filter)
        assert sum(traced) == pytest.approx(tracer.traced * 96 * 80)
        assert sum(traced) < 0.3 * 96 * 80
    # Another filter gets an image of its own.
    traced.clear()
    tracer.image({"exit": first}, BoxFilter())
    assert sum(traced) == 96 * 80


def test_a_lens_that_is_locked_throughout_still_has_its_image(scene, rng):
    locked = np.ones((12, 10), bool)
    (heights,) = lenses(scene, locked, rng, 1)
    plan, full = Plan(scene, locked=locked), Plan(scene)
    for _ in range(2):
        assert (
            plan.trace({"exit": heights}).flux - full.trace({"exit": heights}).flux
        ).abs().sum() < 2e-5
