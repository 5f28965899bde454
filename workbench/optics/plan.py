"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

import copy
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays
from workbench.optics.face_samples import FaceSamples
from workbench.optics.kernels import ready
from workbench.optics.kernels.collimated import FusedCollimatedRays
from workbench.optics.kernels.face import FusedFaceSamples
from workbench.optics.kernels.locked import Mask
from workbench.optics.kernels.point import FusedPointRays
from workbench.optics.ledger import Ledger
from workbench.optics.light import Tracer
from workbench.optics.point import PointRays
from workbench.optics.precision import precision_of
from workbench.optics.reference import Reference
from workbench.scene import (
    BoxFilter,
    CollimatedSource,
    ExactMethod,
    Filter,
    MeshMethod,
    Scene,
    Screen,
)

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
        self._fine = False  # by the scene's need, not by the caller's wish
        if dtype is None:
            dtype = precision_of(scene, net)
            self._fine = dtype == torch.float64
        self._dtype, self._device = dtype, device_of(scene)
        self._fused = fused and self._device.type == "cpu"
        self._mirrored, self._locked = mirrored, locked
        self._kernel: Tracer | None = None
        if samples is not None and isinstance(scene.source, CollimatedSource):
            source = CollimatedSource(kind="collimated", rays=samples)
            scene = scene.model_copy(update={"source": source})
        self._scene, self._net, self._samples = scene, net, samples
        self._fresh = not isinstance(scene.source, CollimatedSource) and scene.source.fresh
        # Collimated light needs no entrance refraction and no intersection: it is not in its plan.
        if isinstance(scene.source, CollimatedSource):
            self._reference = Reference(CollimatedRays(scene, net, dtype, self._device))
        elif samples is not None:
            self._reference = Reference(FaceSamples(scene, net, samples, dtype, self._device))
        else:
            self._reference = Reference(PointRays(scene, net, dtype=dtype, device=self._device))

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
        if isinstance(self._scene.source, CollimatedSource):
            notes.append("collimated light: entrance refraction and intersection left out")
        elif self._samples is not None:
            notes.append("samples on the exit face: no ray has to search for it")
        elif isinstance(self._scene.source.intersection, MeshMethod):
            notes.append("intersection with the triangle mesh: by the reference alone")
        if isinstance(tracer, FusedCollimatedRays | FusedFaceSamples) and any(tracer.mirrored):
            part = "a quarter" if all(tracer.mirrored) else "half"
            notes.append(f"mirror symmetry: {part} of the rays")
        if isinstance(tracer, FusedCollimatedRays) and tracer.traced < 1:
            notes.append(f"locked control points: {tracer.traced:.0%} of the rays after the first")
        if self._fine:
            notes.append("float64: float32 would move light by a part of a pixel")
        if isinstance(self._filter, BoxFilter):
            notes.append("box filter: one pixel a ray, no ghost pixels")
        return tuple(notes)

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        rays = self._reference.rays
        if self._fresh and isinstance(rays, PointRays):
            rays.redraw()

    def reach(self, heights: Tensor) -> tuple[float, float]:
        """How far from the axis, along x and y, nearly all light on the screen plane falls."""
        with torch.no_grad():
            hits = self._reference.rays.trace(heights)
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
        return self._reference.flux(heights, self._screen, self._filter)

    def valid(self, heights: Tensor) -> bool:
        """Whether the way of tracing is surely right for a lens; see `FaceSamples.valid`."""
        rays = self._reference.rays
        return not isinstance(rays, FaceSamples) or rays.valid(heights)

    def _tracer(self) -> Tracer:
        """The kernel as soon as it is compiled; see `workbench.optics.kernels.ready`."""
        scene, source, rays = self._scene, self._scene.source, self._reference.rays
        if self._kernel is None and self._fused:
            if isinstance(source, CollimatedSource):
                if ready.is_ready("collimated", self._dtype):
                    self._kernel = FusedCollimatedRays(
                        scene, self._net, source.rays, self._mirrored, self._dtype, self._locked
                    )
            elif self._samples is not None and ready.is_ready("face", self._dtype):
                self._kernel = FusedFaceSamples(
                    scene, self._net, self._samples, self._mirrored, self._dtype
                )
            elif (
                isinstance(rays, PointRays)
                and isinstance(source.intersection, ExactMethod)
                and ready.is_ready("point", self._dtype)
            ):
                self._kernel = FusedPointRays(rays, scene, self._net, self._dtype)
        return self._kernel or self._reference


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
