"""In what the light of a scene is told: in lumen where the source has any, else as parts of all."""

from typing import NamedTuple

from workbench import units
from workbench.errors import Refused
from workbench.measured.lamps import intensity_of
from workbench.powers import written
from workbench.scene import PhotometricSource, Scene


class LightUnit(NamedTuple):
    """What figures of a source whose flux is 1 come to for people.

    Attributes
    ----------
    words : str
        Unit of a density: "lx", "cd", or "flux / cm²" and the like.
    density : float
        By which a density is multiplied: flux per area in a scene's unit, or per solid angle.
    lumens : float, optional
        Flux of the source, lm; None where nobody says it.
    """

    words: str = "flux"
    density: float = 1.0
    lumens: float | None = None

    @property
    def short(self) -> str:
        """The unit of a density behind a number."""
        return self.words.removeprefix("flux ")

    def flux_in_words(self, share: float) -> str:
        """A part of the light in lumen, as in "12.3 lm"; empty where nobody knows them."""
        return "" if self.lumens is None else written(share * self.lumens, "lm")

    def density_in_words(self, density: float) -> str:
        """A density with its unit."""
        return written(density * self.density, self.short)


IN_PARTS = LightUnit()
"""For light of which nobody says how much it is."""


def light_unit(scene: Scene) -> LightUnit:
    """The unit for the light of a scene; parts of all where a file of the source cannot be read.

    Examples
    --------
    >>> from workbench.scene import Scene
    >>> scene = Scene.from_data({
    ...     "version": 3, "unit": "cm",
    ...     "source": {
    ...         "kind": "area", "position": [0, 0, -3], "half_width": [0.1, 0.1], "flux": 200,
    ...     },
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": "PMMA",
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 50], "half_width": [10, 10],
    ...             "pixels": [64, 64],
    ...         },
    ...         "target": {"builtin": "rectangle"},
    ...     }],
    ... })
    >>> light_unit(scene)
    LightUnit(words='lx', density=2000000.0, lumens=200.0)
    """
    receiver, lumens = scene.receiver, _lumens(scene)
    if lumens is None:
        return LightUnit(receiver.density_words(scene.unit))
    if not receiver.measure.power:
        return LightUnit("cd", lumens, lumens)
    return LightUnit("lx", lumens / float(units.METRES[scene.unit]) ** 2, lumens)


def _lumens(scene: Scene) -> float | None:
    """Flux of the source into all directions, lm."""
    source = scene.source
    if not isinstance(source, PhotometricSource):
        return source.lumens
    try:
        return intensity_of(source).lumens
    except Refused:  # said where the file is needed
        return None
