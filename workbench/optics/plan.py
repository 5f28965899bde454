"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

import copy
from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor

from workbench.compiled import unkept
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.kernels import ready
from workbench.optics.kernels.locked import Mask
from workbench.optics.light import Light, Tracer
from workbench.optics.path import Path
from workbench.optics.precision import precision_of
from workbench.optics.ways import Ways
from workbench.scene import BoxFilter, Filter, Scene, Screen

_NEARLY_ALL = 0.999


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
    samples : tuple[int, int], optional
        Rays of collimated light along x and y; those of the source by default. For light of points
        they mean samples of the exit face, in place of rays that search for it.
    mirrored : tuple[bool, bool]
        The caller's promise that heights, lens and source are mirror images of themselves in x,
        in y. Kernels for collimated light and for samples then trace one half of them only.
    locked : ndarray of bool, shape (n_u, n_v), optional
        The caller's promise that these control points of the exit face have the same heights in all
        lenses that are traced. The kernel for collimated light then traces rays that see no others
        only once.

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
        samples: tuple[int, int] | None = None,
        mirrored: tuple[bool, bool] = (False, False),
        locked: Mask | None = None,
    ) -> None:
        self._screen = scene.screen
        self._filter = filter or scene.filter
        net = net or ControlNet.of(scene.lens)
        self._fine = False  # by the scene's need, not by that of the caller
        if dtype is None:
            dtype = precision_of(scene, net)
            self._fine = dtype == torch.float64
        self._dtype, self._device = dtype, device_of(scene)
        self._fused = fused and self._device.type == "cpu"
        self._redrawn = scene.source.redrawn
        path = Path.of(scene, net, dtype, self._device, samples)
        self._ways = Ways(path, mirrored, locked)

    def trace(self, heights: Mapping[str, Tensor]) -> Light:
        """Image and light account of a lens.

        Parameters
        ----------
        heights : mapping of str to Tensor, shape (n_u, n_v)
            Control heights of each freeform face by its name, scene units.
        """
        return self._tracer().image(heights, self._screen, self._filter)

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        precision = str(self._dtype).removeprefix("torch.")
        if self._compiled():
            threads = torch.get_num_threads()
            notes = [f"fused kernels, {threads} thread{'s' * (threads > 1)}, {precision}"]
        else:
            notes = [f"reference in torch on {self._device.type}, {precision}"]
        notes += self._tracer().notes
        if self._ways.kind is None:
            faces = ", ".join(step.surface.kind for step in self._ways.path.steps)
            notes.append(f"no kernel for this path ({faces}): by the reference alone")
        if self._fine:
            notes.append("float64: float32 would move light by a part of a pixel")
        if isinstance(self._filter, BoxFilter):
            notes.append("box filter: one pixel a ray, no ghost pixels")
        return tuple(notes + self._defects())

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        if self._redrawn:
            self._ways.path.redraw()

    def reach(self, heights: Mapping[str, Tensor]) -> tuple[float, float]:
        """How far from the axis, along x and y, nearly all light on the screen plane falls."""
        with torch.no_grad():
            x, y, rays, _ = self._ways.reference.arrival(heights)
        lands = (rays.flux > 0) & x.isfinite()
        if not lands.any():
            return 0.0, 0.0
        from_axis = (c[lands].abs().double().cpu().numpy() for c in (x, y))
        far_x, far_y = (float(np.quantile(c, _NEARLY_ALL)) for c in from_axis)
        return far_x, far_y

    def on(self, screen: Screen) -> "Plan":
        """The same rays, with the image of another part of the same plane.

        Nothing of them is computed again, and the account is still of the scene's own screen.
        """
        other = copy.copy(self)
        other._screen = screen
        return other

    def flux(self, heights: Mapping[str, Tensor]) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp: always by the reference."""
        return self._ways.reference.flux(heights, self._screen, self._filter)

    def _tracer(self) -> Tracer:
        return self._ways.kernel if self._compiled() else self._ways.reference

    def _compiled(self) -> bool:
        """Whether the kernel does the work; see `workbench.optics.kernels.ready`."""
        kind = self._ways.kind
        return self._fused and kind is not None and ready.obtain(kind.name, self._dtype)

    def _defects(self) -> list[str]:
        """What makes traces or starts slower than they should be."""
        notes, kind = [], self._ways.kind
        error = ready.failure(kind.name, self._dtype) if self._fused and kind is not None else None
        if error is not None:
            notes.append(
                f"the kernel could not be compiled ({type(error).__name__}: {error}), so this run "
                "is many times slower"
            )
        if reason := unkept():
            notes.append(
                f"compiled kernels could not be kept ({reason}), so each start compiles them again"
            )
        return notes


def device_of(scene: Scene) -> torch.device:
    """The device on which a scene wants to be traced.

    Raises
    ------
    Refused
        If it is not there.
    """
    if scene.run.device == "cuda" and not torch.cuda.is_available():
        raise Refused(
            "run.device", "'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'"
        )
    return torch.device(scene.run.device)
