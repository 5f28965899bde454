"""Light of given points or directions: as exact at each level of cells."""

from typing import Self

from workbench.analysis.tracing.elements import LightSource
from workbench.arrays import Array


class Unspread:
    """What sources have in common that no disc of directions is; see `LightSource`."""

    sampled = False
    places: Array | None = None

    def finer(self, level: int) -> Self:
        """The same: see `LightSource`."""
        return self

    def on_disc(self, part: Array, turn: Array) -> LightSource | None:
        """None: see `LightSource`."""
        return None
