"""Standard ball cutters, which a shop can buy."""

from workbench.units import METRES

INCH = 25.4
CUTTERS = {f"{size:g} mm": size for size in (0.5, 1, 1.5, 2, 3, 4, 5, 6)} | {
    f"1/{part} inch": INCH / part for part in (64, 32, 16, 8, 4)
}
"""Diameters of standard cutters by name, mm."""


def cutter_radius(name: str, unit: str) -> float:
    """Return the radius of a standard cutter in a unit of length."""
    return CUTTERS[name] / 2000 / METRES[unit]


def cutter_radii(unit: str, most: float) -> list[float]:
    """Return the radii of standard cutters up to ``most`` in a unit of length, largest first."""
    radii = (cutter_radius(name, unit) for name in CUTTERS)
    return sorted((radius for radius in radii if radius <= most), reverse=True)


def cutter_name(radius: float, unit: str) -> str | None:
    """Return the name of the standard cutter with a radius; None if there is none."""
    size = 2000 * METRES[unit] * radius
    return next((name for name, each in CUTTERS.items() if abs(each - size) < 1e-6), None)
