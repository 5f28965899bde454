"""What the stored values of a picture mean: how much light each of them is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from workbench.arrays import Array

# Below these a straight line takes the place of the power, in stored values and in light.
_STRAIGHT_SHADE, _STRAIGHT_LIGHT, _STEEPNESS = 0.04045, 0.0031308, 12.92
_OFFSET, _POWER = 0.055, 2.4


@dataclass(frozen=True)
class Tone:
    """A relation of stored values and light, both in [0, 1] and growing together.

    Attributes
    ----------
    name : str
        As in ``target.tone``.
    light : callable
        From an array of stored values to light.
    stored : callable
        The way back.
    """

    name: Literal["linear", "srgb"]
    light: Callable[[Array], Array]
    stored: Callable[[Array], Array]


def _same(values: Array) -> Array:
    return values


def _light_of_srgb(stored: Array) -> Array:
    power = ((stored + _OFFSET) / (1 + _OFFSET)) ** _POWER
    return np.where(stored <= _STRAIGHT_SHADE, stored / _STEEPNESS, power)


def _srgb_of_light(light: Array) -> Array:
    power = (1 + _OFFSET) * light ** (1 / _POWER) - _OFFSET
    return np.where(light <= _STRAIGHT_LIGHT, light * _STEEPNESS, power)


LINEAR = Tone("linear", _same, _same)
"""The stored value is the light."""

SRGB = Tone("srgb", _light_of_srgb, _srgb_of_light)
"""What a monitor makes of the stored value; IEC 61966-2-1."""

TONES = {tone.name: tone for tone in (LINEAR, SRGB)}
"""By name."""
