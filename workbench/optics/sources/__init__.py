"""Light before the lens: one file a kind.

A new kind of source is a file here, its fields in `workbench.scene`, and a row in ``_EMITTERS``.
"""

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from torch import Tensor

from workbench.arrays import Array
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.collimated import CollimatedEmitter
from workbench.optics.sources.crowding import where_lit
from workbench.optics.sources.extended import AreaEmitter, DirectionEmitter
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.photometric import PhotometricEmitter
from workbench.optics.sources.points import PointEmitter, RayFileEmitter
from workbench.scene import (
    AreaSource,
    CollimatedSource,
    Element,
    LightOfPoints,
    PhotometricSource,
    RayFileSource,
    Source,
)
from workbench.scene.part import row_of

__all__ = ["CollimatedEmitter", "Emitter", "Origins", "PointEmitter", "emitter_of"]


class Emitter(Protocol):
    """Emits rays.

    Attributes
    ----------
    samples : tuple[int, int] or Corners, optional
        Rays along x and y that were asked for; see `emitter_of`.
    origins : Origins
        Where its light comes from.
    by_area : bool
        Whether its rays stand for cells of the entrance face, and their flux for what of these is
        inside the outline of the lens: a ray beside it may stand for a cell that is cut.
    beside : float
        Flux that misses the lens by the outline, and is in none of the rays.
    splits : tuple of two ndarray, shape (m_x, 3) and (m_y, 3)
        Of rays at `workbench.optics.samples.Corners`, along x and y: which parts of their flux
        belong to the cells before and behind them. Rays of different points share no cell.
    """

    @property
    def samples(self) -> Samples | None:
        """See above."""
        ...

    @property
    def origins(self) -> Origins:
        """See above."""
        ...

    @property
    def by_area(self) -> bool:
        """See above."""
        ...

    @property
    def beside(self) -> float:
        """See above."""
        ...

    @property
    def splits(self) -> tuple[Array, Array]:
        """See above."""
        ...

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays of the source, in float64; with what is ``beside``, their flux adds up to 1.

        Parameters
        ----------
        seed : int
            The same seed gives the same rays.
        draw : int
            Number of the set of rays; where they are drawn at random, each is another one.
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


def _collimated(source: CollimatedSource, optic: Element, samples: Samples | None) -> Emitter:
    straight = source.along_axis
    return (CollimatedEmitter if straight else DirectionEmitter)(source, optic, samples)


_EMITTERS: Mapping[type, Callable[[Any, Element, Samples | None], Emitter]] = {
    CollimatedSource: _collimated,
    AreaSource: AreaEmitter,
    LightOfPoints: PointEmitter,
    PhotometricSource: PhotometricEmitter,
    RayFileSource: RayFileEmitter,
}


def emitter_of(source: Source, optic: Element, samples: Samples | None = None) -> Emitter:
    """The element that emits the light of a source towards a lens.

    `source`, `lens`: the light and its aperture; `samples`: rays along x and y that are wanted in
    place of the source's own. A source whose rays are drawn at random keeps them.
    """
    if isinstance(samples, Corners):
        samples = where_lit(samples, source, optic)
    return row_of(_EMITTERS, source)(source, optic, samples)
