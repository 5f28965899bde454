"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

from collections.abc import Mapping

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.choice import Choice
from workbench.optics.light import Light, Tracer
from workbench.optics.path import Path
from workbench.optics.precision import precision_of
from workbench.optics.samples import Samples
from workbench.optics.tracers import Tracers
from workbench.said import Said
from workbench.scene import Filter, Scene


class Plan:
    """A trace that is ready to go: fused kernels where there are some, else the torch reference.

    Parameters
    ----------
    scene : Scene
        What is traced.
    net : ControlNet, optional
        Control net of the heights to come; the scene's own by default.
    filter : BoxFilter or GaussianFilter, optional
        Reconstruction filter; the scene's own by default.
    dtype : torch.dtype, optional
        Float type of the trace; by default the one that the scene needs, see `precision_of`.
    fused : bool
        False asks for the reference.
    samples : tuple[int, int] or Corners, optional
        Rays of collimated light along x and y; or corners of cells of any light, of which the first
        freeform face is sampled. By default the rays of the source.
    mirrored : tuple[bool, bool]
        The caller's promise that heights, lens and source are mirror images of themselves in x,
        in y. The kernel for collimated light then traces one half of the rays only.

    Raises
    ------
    Refused
        If the scene asks for a device that is not there.
    """

    def __init__(
        self,
        scene: Scene,
        net: ControlNet | None = None,
        filter: Filter | None = None,
        dtype: torch.dtype | None = None,
        fused: bool = True,
        samples: Samples | None = None,
        mirrored: tuple[bool, bool] = (False, False),
    ) -> None:
        self._filter = filter or scene.filter
        net = net or ControlNet.of(scene.optic)
        needed = precision_of(scene, net)
        # Fine by the scene's need, not by that of the caller.
        fine = dtype is None and needed == torch.float64
        self._redrawn = scene.source.redrawn
        path = Path.of(scene, net, dtype or needed, device_of(scene), samples)
        self._tracers = Tracers(path, mirrored)
        self._choice = Choice(path, self._tracers.compiled, fused, fine)

    def trace(self, heights: Mapping[str, Tensor]) -> Light:
        """Image and light account of a lens.

        Parameters
        ----------
        heights : mapping of str to Tensor, shape (n_u, n_v)
            Control heights of each freeform face by its name, scene units.
        """
        return self._tracer().image(heights, self._filter)

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        notes = self._choice.notes(self._tracer().notes)
        if not self._filter.smooth:
            notes.append(Said("box filter: one pixel a ray, no ghost pixels"))
        return tuple(notes + self._choice.defects())

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        if self._redrawn:
            self._tracers.path.redraw()

    def flux(self, heights: Mapping[str, Tensor]) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp: always by the reference."""
        return self._tracers.reference.flux(heights, self._filter)

    def _tracer(self) -> Tracer:
        return self._tracers.kernel if self._choice.compiled else self._tracers.reference


def device_of(scene: Scene) -> torch.device:
    """The device on which a scene wants to be traced.

    Raises
    ------
    Refused
        If it is not there.
    """
    if scene.run.device == "cuda" and not torch.cuda.is_available():
        raise Refused(
            "run.device",
            Said("'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'"),
        )
    return torch.device(scene.run.device)


def tensors_of(heights: Mapping[str, Array], scene: Scene) -> dict[str, Tensor]:
    """Control heights of each freeform face, copied to where a scene wants to be traced.

    Parameters
    ----------
    heights : mapping of str to ndarray, shape (n_u, n_v)
        By the names of the faces, scene units.
    scene : Scene
        Of the trace; see `device_of`.
    """
    device = device_of(scene)
    return {face: torch.tensor(each, device=device) for face, each in heights.items()}
