"""What the stored values of a picture mean: how much light each of them is."""

from collections.abc import Callable
from dataclasses import dataclass

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
        As in ``target.tone``, or what a file says.
    light : callable
        From an array of stored values to light.
    stored : callable
        The way back.
    """

    name: str
    light: Callable[[Array], Array]
    stored: Callable[[Array], Array]

    @classmethod
    def power(cls, exponent: float) -> "Tone":
        """Light is a power of the stored value."""
        return cls(
            f"power {exponent:g}",
            lambda stored: stored**exponent,
            lambda light: light ** (1 / exponent),
        )

    @classmethod
    def measured(cls, light: Array) -> "Tone":
        """Light of equally spaced stored values from 0 to 1, shape (values,); it does not fall."""
        stored = np.linspace(0.0, 1.0, len(light))
        return cls(
            "measured",
            lambda values: np.interp(values, stored, light),
            lambda values: np.interp(values, light, stored),
        )


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

NUMBERS = Tone("linear", _same, _same)
"""The stored value is the light, and there is no largest one: no tone of a monitor can be meant."""

SRGB = Tone("srgb", _light_of_srgb, _srgb_of_light)
"""What a monitor makes of the stored value; IEC 61966-2-1."""

TONES = {tone.name: tone for tone in (LINEAR, SRGB)}
"""By name."""
