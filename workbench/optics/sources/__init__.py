"""Light before the lens: one file a kind.

A new kind of source is a file here, its fields in `workbench.scene`, and a row in ``_EMITTERS``.
"""

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from torch import Tensor

from workbench.optics.rays import RayBundle
from workbench.optics.sources.collimated import CollimatedEmitter
from workbench.optics.sources.points import PointEmitter
from workbench.scene import CollimatedSource, GridSource, Lens, PointSource, Source


class Emitter(Protocol):
    """Emits rays.

    Attributes
    ----------
    along_axis : bool
        Whether all rays go along +z: the entrance face then leaves them as they are.
    """

    along_axis: bool

    def rays(self, seed: int) -> RayBundle:
        """Rays of the source, in float64; their flux adds up to 1.

        Parameters
        ----------
        seed : int
            The same seed gives the same rays.
        """
        ...

    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays to look at: from before the lens through places of the entrance face.

        Parameters
        ----------
        x, y : Tensor, shape (m,), float64
            The places, scene units.
        """
        ...


_EMITTERS: Mapping[type, Callable[[Any, Lens], Emitter]] = {
    CollimatedSource: CollimatedEmitter,
    PointSource: PointEmitter,
    GridSource: PointEmitter,
}


def emitter_of(source: Source, lens: Lens) -> Emitter:
    """The element that emits the light of a source towards a lens."""
    return _EMITTERS[type(source)](source, lens)
