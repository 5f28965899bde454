"""Light on a mirror by samples that all origins of the light share: no ray has to search for it.

All of the mirror is lit, wherever its light crosses the plane before it.
"""

from collections.abc import Mapping
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.geometry.surface import ControlNet
from workbench.optics.arrival import Arrival
from workbench.optics.lit_face import LitFace
from workbench.optics.path import Path
from workbench.optics.samples import Corners, Places, Samples, places, splits_side_by_side
from workbench.optics.sources.origins import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface
from workbench.said import Said


class SharedMirror(NamedTuple):
    """A path of which a mirror is sampled for all origins of its light.

    Attributes
    ----------
    origins : Origins
        Where the light comes from.
    samples : tuple[int, int] or Corners
        Middles of so many cells along x and y, or corners of cells.
    net : ControlNet
        Where the control heights of the mirror sit.
    step : FaceStep
        The mirror.
    """

    origins: Origins
    samples: Samples
    net: ControlNet
    step: FaceStep

    @classmethod
    def of(cls, path: Path) -> "SharedMirror | None":
        """Light without patterns of which samples are wanted, and a B-spline that reflects."""
        emitter, samples = path.emitter, path.emitter.samples
        if samples is None or emitter.origins.pattern is not None:
            return None
        # Middles of cells are those of the plane before it, unless rays are drawn at random.
        if not isinstance(samples, Corners) and emitter.by_area:
            return None
        match path.steps:
            case (FaceStep(BSplineSurface(net=net, subdivisions=None)) as step,):
                return cls(emitter.origins, samples, net, step)
        return None

    @property
    def lines(self) -> tuple[Places, Places]:
        """Samples along x and y, and what each stands for, as parts of the way across."""
        return places(self.samples, 0), places(self.samples, 1)

    @property
    def splits(self) -> tuple[Array, Array]:
        """See `workbench.optics.light.BeamTracer`: origins one after the other along y."""
        return splits_side_by_side(*self.lines, len(self.origins.places))


class MirrorSamples:
    """A tensor grid of samples of a mirror, with all that does not depend on the heights.

    Parameters
    ----------
    shared : SharedMirror
        What is sampled.
    path : Path
        The path of the light.
    """

    note = Said("samples on the mirror, shared by all origins of the light")

    def __init__(self, shared: SharedMirror, path: Path) -> None:
        self._step, self._path = shared.step, path
        self._face = LitFace(shared.net, path.datum, shared.lines, shared.origins, path)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the light from the mirror to the receiver; see `Path.walk`."""
        surface, interface, missed = self._step
        lit = self._face.light(heights[surface.name])
        passed = interface.turn(*lit)
        with torch.no_grad():
            lost = {name: part.sum(dtype=torch.float64) for name, part in passed.lost.items()}
            lost[missed] = 1 - lit.rays.flux.sum(dtype=torch.float64)
        return Arrival(*self._path.receiver.places(passed.rays), passed.rays, lost)
