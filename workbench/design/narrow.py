"""The first lens of a run whose height range is too narrow for the first design.

A first design that is cut off at the ends of its range leaves light in the wrong places, and a
descent on a fine net moves light over long distances slowly. So the descent begins with few pixels
and control points, whose steps cost next to nothing, and is carried to finer ones. It begins with
the surface within the range whose slopes are closest to those of the first design.

In half of the range that the first design needs, a photograph of 128 × 128 pixels ends at 11 % in
place of 31 %.
"""

from collections.abc import Callable, Mapping

import numpy as np
import scipy

from workbench.arrays import Array
from workbench.design.bounds import Bounds
from workbench.design.limits import HeightLimits
from workbench.geometry.surface import nets_of

Improve = Callable[[Bounds, int], Mapping[str, Array]]
"""Descends within bounds for a number of steps, and returns the heights of the last lens."""

# Pixels along the shorter axis of the coarsest image, at least, and the steps there. An image of
# twice as many pixels gets this part of the steps of the one before, at least the last number.
_FEWEST_PIXELS, _STEPS, _PART, _FEWEST_STEPS = 16, 150, 0.4, 20
# Steps to the closest slopes, their relaxation, and the weight of a copy: that of a wave of so many
# periods per lens. They end within 0.3 % of the range.
_CLOSEST_STEPS, _RELAXED, _PERIODS = 100, 1.6, 8.0


def times_fewer(pixels: tuple[int, int]) -> int:
    """How many times fewer pixels the coarsest image has along each axis; 1 for a small image."""
    times = 1
    while min(pixels) > 2 * times * _FEWEST_PIXELS:
        times *= 2
    return times


def begin_within(bounds: Bounds, improve: Improve) -> dict[str, Array]:
    """Control heights (n_u, n_v) of each face of a lens within its limits.

    `bounds`: of the run, whose first design does not fit within them; `improve`: a descent.
    """
    assert bounds.first is not None
    times = times_fewer(bounds.scene.receiver.pixels)
    heights, nets = dict(bounds.first), nets_of(bounds.scene)
    steps = float(_STEPS)
    coarsest = True
    while times > 1:
        coarse = bounds.coarser(times)
        own = nets_of(coarse.scene)
        heights = {face: nets[face].carry(each, own[face]) for face, each in heights.items()}
        if coarsest:
            heights = _closest(heights, coarse.limits)
        coarse.start = heights
        heights, nets = dict(improve(coarse, round(steps))), own
        times, steps, coarsest = times // 2, max(_PART * steps, _FEWEST_STEPS), False
    own = nets_of(bounds.scene)
    return {face: nets[face].carry(each, own[face]) for face, each in heights.items()}


def _closest(heights: Mapping[str, Array], limits: Mapping[str, HeightLimits]) -> dict[str, Array]:
    return {face: closest_slopes(each, limits[face]) for face, each in heights.items()}


def closest_slopes(heights: Array, limits: HeightLimits) -> Array:
    """The surface within limits whose slopes are closest to those of another one.

    Found by the alternating direction method of multipliers (Boyd et al. 2011, section 3), for each
    cosine wave of the net alone: a copy of the heights is within the limits.
    """
    along_u, along_v = (np.arange(count) / 2 for count in heights.shape)
    stiffness = along_u[:, None] ** 2 + along_v**2
    wanted = stiffness * scipy.fft.dctn(heights, norm="ortho")
    within, gap = heights.clip(limits.lower, limits.upper), np.zeros_like(heights)
    for _ in range(_CLOSEST_STEPS):
        waves = wanted + _PERIODS**2 * scipy.fft.dctn(within - gap, norm="ortho")
        surface = scipy.fft.idctn(waves / (stiffness + _PERIODS**2), norm="ortho")
        surface = _RELAXED * surface + (1 - _RELAXED) * within
        within = (surface + gap).clip(limits.lower, limits.upper)
        gap = gap + surface - within
    return np.asarray(within)
