"""What a face does to the light that meets it: one file a kind."""

from workbench.optics.interfaces.interface import Interface, Passed
from workbench.optics.interfaces.reflection import Reflection
from workbench.optics.interfaces.refraction import Refraction

__all__ = ["Interface", "Passed", "Reflection", "Refraction"]
