"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

import copy
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.compiled import unkept
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.face_samples import FaceSamples
from workbench.optics.kernels import ready
from workbench.optics.kernels.collimated import FusedCollimatedRays
from workbench.optics.kernels.face import FusedFaceSamples
from workbench.optics.kernels.locked import Mask
from workbench.optics.ledger import Ledger
from workbench.optics.light import Tracer
from workbench.optics.precision import precision_of
from workbench.optics.reference import Reference
from workbench.optics.ways import Options, way_of
from workbench.scene import BoxFilter, Filter, Scene, Screen

_NEARLY_ALL = 0.999


class Traced(NamedTuple):
    """The image of a lens, and where its light went.

    Attributes
    ----------
    flux : Tensor, shape (n_y, n_x)
        Flux in each pixel, row 0 at +y; differentiable.
    ledger : Ledger
        The account of all light.
    """

    flux: Tensor
    ledger: Ledger


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
        The caller's promise that these control points have the same heights in all lenses that are
        traced. The kernel for collimated light then traces rays that see no others only once.

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
        options = Options(net, dtype, self._device, samples, mirrored, locked)
        self._way = way_of(scene, options)

    def trace(self, heights: Tensor) -> Traced:
        """Image and ledger of a lens.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, scene units.
        """
        tracer = self._tracer()
        light = tracer.image(heights, self._screen, self._filter)
        ledger = Ledger(
            emitted=tracer.emitted,
            on_screen=light.on_screen,
            off_screen=light.off_screen,
            missed_lens=tracer.missed_lens,
            left_side=light.left_side,
            total_reflection=light.total_reflection,
            fresnel_entrance=tracer.fresnel_entrance,
            fresnel_exit=light.fresnel_exit,
        )
        return Traced(light.flux, ledger)

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        precision = str(self._dtype).removeprefix("torch.")
        tracer = self._tracer()
        if isinstance(tracer, Reference):
            notes = [f"reference in torch on {self._device.type}, {precision}"]
        else:
            threads = torch.get_num_threads()
            notes = [f"fused kernels, {threads} thread{'s' * (threads > 1)}, {precision}"]
        notes += self._way.notes
        if isinstance(tracer, FusedCollimatedRays | FusedFaceSamples) and any(tracer.mirrored):
            part = "a quarter" if all(tracer.mirrored) else "half"
            notes.append(f"mirror symmetry: {part} of the rays")
        if isinstance(tracer, FusedCollimatedRays) and tracer.traced < 1:
            notes.append(f"locked control points: {tracer.traced:.0%} of the rays after the first")
        if self._fine:
            notes.append("float64: float32 would move light by a part of a pixel")
        if isinstance(self._filter, BoxFilter):
            notes.append("box filter: one pixel a ray, no ghost pixels")
        return tuple(notes + self._defects())

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        self._way.redraw()

    def reach(self, heights: Tensor) -> tuple[float, float]:
        """How far from the axis, along x and y, nearly all light on the screen plane falls."""
        with torch.no_grad():
            hits = self._way.reference().rays.trace(heights)
        lands = (hits.weight > 0) & hits.x.isfinite()
        if not lands.any():
            return 0.0, 0.0
        x, y = (c[lands].abs().double().cpu().numpy() for c in (hits.x, hits.y))
        return float(np.quantile(x, _NEARLY_ALL)), float(np.quantile(y, _NEARLY_ALL))

    def on(self, screen: Screen) -> "Plan":
        """The same rays, with the image of another part of the same plane.

        Nothing of them is computed again, and the account is still of the scene's own screen.
        """
        other = copy.copy(self)
        other._screen = screen
        return other

    def flux(self, heights: Tensor) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp: always by the reference."""
        return self._way.reference().flux(heights, self._screen, self._filter)

    def valid(self, heights: Tensor) -> bool:
        """Whether the way of tracing is surely right for a lens; see `FaceSamples.valid`."""
        rays = self._way.reference().rays
        return not isinstance(rays, FaceSamples) or rays.valid(heights)

    def _tracer(self) -> Tracer:
        """The kernel, or the reference; see `workbench.optics.kernels.ready`."""
        needs = self._way.kernel_name
        if self._fused and needs is not None and ready.obtain(needs, self._dtype):
            return self._way.kernel()
        return self._way.reference()

    def _defects(self) -> list[str]:
        """What makes traces or starts slower than they should be."""
        notes, needs = [], self._way.kernel_name
        error = ready.failure(needs, self._dtype) if self._fused and needs is not None else None
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
