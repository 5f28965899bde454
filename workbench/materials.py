"""Refractive indices of common optical glasses and plastics."""

from collections.abc import Callable
from dataclasses import dataclass

from workbench.errors import Refused, shown
from workbench.messages import Message


@dataclass(frozen=True)
class Material:
    """A dispersion formula and where it holds."""

    index: Callable[[float], float]  # refractive index at a wavelength in µm
    range_um: tuple[float, float]  # wavelengths that the fit covers, µm
    source: str  # where the coefficients come from


def _sellmeier(*terms: tuple[float, float]) -> Callable[[float], float]:
    """n² = 1 + Σ B λ² / (λ² − C), with C in µm²."""

    def index(wavelength_um: float) -> float:
        square = wavelength_um**2
        return float((1 + sum(b * square / (square - c) for b, c in terms)) ** 0.5)

    return index


_SULTANOVA = "Sultanova, Kasarova, Nikolov, Acta Physica Polonica A 116, 585 (2009)"

CATALOGUE = {
    "PMMA": Material(_sellmeier((1.1819, 0.011313)), (0.437, 1.052), _SULTANOVA),
    "PC": Material(_sellmeier((1.4182, 0.021304)), (0.437, 1.052), _SULTANOVA),
    "PS": Material(_sellmeier((1.4435, 0.020216)), (0.437, 1.052), _SULTANOVA),
    "N-BK7": Material(
        _sellmeier(
            (1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)
        ),
        (0.3, 2.5),
        "SCHOTT optical glass data sheets",
    ),
    "fused silica": Material(
        _sellmeier((0.6961663, 0.0684043**2), (0.4079426, 0.1162414**2), (0.8974794, 9.896161**2)),
        (0.21, 3.71),
        "Malitson, J. Opt. Soc. Am. 55, 1205 (1965)",
    ),
}


def refractive_index(name: str, wavelength_um: float) -> float:
    """Refractive index of a catalogue material.

    `name`: a key of `CATALOGUE`; `wavelength_um`: vacuum wavelength in µm. Raises `Refused` if the
    name is not in the catalogue or its data do not cover the wavelength.
    """
    material = CATALOGUE.get(name)
    if material is None:
        known = ", ".join(CATALOGUE)
        raise Refused(
            "material",
            Message(
                "{name} is not in the catalogue; known: {known}", name=shown(name), known=known
            ),
        )
    low, high = material.range_um
    if not low <= wavelength_um <= high:
        raise Refused(
            "source.wavelength_um",
            Message(
                "{wavelength:g} is outside the data for {name}; {low:g} to {high:g}",
                wavelength=wavelength_um,
                name=name,
                low=low,
                high=high,
            ),
        )
    return material.index(wavelength_um)
