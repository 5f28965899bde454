"""What all sources have in common: light of origins towards a lens."""

from abc import ABC, abstractmethod

from torch import Tensor

from workbench.arrays import Array
from workbench.optics.rays import RayBundle
from workbench.optics.samples import Corners, Samples, places_of_points
from workbench.optics.sources.origins import Origins, through_cells
from workbench.scene import Element


class Emitter(ABC):
    """Emits rays, from places and in directions that stand for a source.

    Parameters
    ----------
    optic : Element
        Gives the entrance face.
    samples : tuple[int, int] or Corners, optional
        Rays along x and y; see `emitter_of`.
    """

    def __init__(self, optic: Element, samples: Samples | None) -> None:
        self.optic, self.samples = optic, samples

    @property
    @abstractmethod
    def origins(self) -> Origins:
        """Where its light comes from."""

    @property
    def by_area(self) -> bool:
        """Whether its rays stand for cells of the entrance face.

        Their flux is for what of these is inside the outline of the lens: a ray beside it may stand
        for a cell that is cut.
        """
        return isinstance(self.samples, Corners)

    @property
    def beside(self) -> float:
        """Flux that misses the lens by the outline, and is in none of the rays."""
        return 0.0

    @property
    def splits(self) -> tuple[Array, Array]:
        """Which parts of the flux of rays at corners belong to the cells before and behind them.

        Shape (m_x, 3) and (m_y, 3), along x and y. Origins come one after the other along y; rays
        of different ones share no cell.
        """
        if not isinstance(self.samples, Corners):
            raise TypeError("these rays are no corners of cells")
        counts = 1, len(self.origins.places)
        x, y = (places_of_points(self.samples, axis, n).split for axis, n in enumerate(counts))
        return x, y

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        """Rays of the source, in float64; with what is ``beside``, their flux adds up to 1.

        Parameters
        ----------
        seed : int
            The same seed gives the same rays.
        draw : int
            Number of the set of rays; where they are drawn at random, each is another one.
        """
        if isinstance(self.samples, Corners):
            return through_cells(self.origins, self.optic, self.samples)
        return self._drawn(seed, draw)

    @abstractmethod
    def _drawn(self, seed: int, draw: int) -> RayBundle:
        """Rays that are no corners of cells."""

    @abstractmethod
    def towards(self, x: Tensor, y: Tensor) -> RayBundle:
        """Rays to look at: from before the lens through places of the entrance face.

        Parameters
        ----------
        x, y : Tensor, shape (m,), float64
            The places, scene units.
        """
