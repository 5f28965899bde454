"""How fine details of an image can be before diffraction washes them out."""

import math

import numpy as np

from workbench.scene import Scene

_MICRO = 1e-3  # millimetres


def diffraction(scene: Scene) -> float:
    """Scale below which diffraction washes details out, in the receiver's measure.

    √(λ · distance) on a screen: a wider part of the lens could aim better, a narrower one spreads
    more. In a far field, wavelength over width of the lens.
    """
    optic, receiver = scene.optic, scene.receiver
    wavelength = _MICRO * wavelength_um(scene)
    if not receiver.at_distance:
        return float(np.degrees(wavelength / (2 * min(optic.half_width))))
    return math.sqrt(wavelength * abs(receiver.plane_z - optic.leaving_z))


def wavelength_um(scene: Scene) -> float:
    """Of the light, as far as the scene says it; that of green light otherwise."""
    return scene.source.wavelength_um or 0.55
