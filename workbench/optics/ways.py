"""The ways of light through a lens: each has a torch reference, and most a compiled kernel.

Nothing is built before it is asked for: a run that has its kernel never makes the reference.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import torch

from workbench.geometry.surface import ControlNet
from workbench.optics.collimated import CollimatedRays
from workbench.optics.face_samples import FaceSamples
from workbench.optics.kernels.collimated import FusedCollimatedRays
from workbench.optics.kernels.face import FusedFaceSamples
from workbench.optics.kernels.locked import Mask
from workbench.optics.kernels.point import FusedPointRays
from workbench.optics.light import Tracer
from workbench.optics.point import PointRays
from workbench.optics.reference import Reference
from workbench.scene import CollimatedSource, MeshMethod, Scene


def _same() -> None:
    """The rays stay as they are."""


@dataclass(frozen=True)
class Way:
    """How the light of a scene is traced.

    Attributes
    ----------
    notes : list of str
        What is special about it, in words.
    reference, kernel : callable
        The torch reference, and its compiled twin; each is made at the first call.
    kernel_name : str or None
        The twin's name in `workbench.optics.kernels.ready`; None if the reference has none.
    redraw : callable
        Take other rays, where they are drawn at random.
    """

    notes: list[str]
    reference: Callable[[], Reference]
    kernel: Callable[[], Tracer]
    kernel_name: str | None
    redraw: Callable[[], None] = _same


@dataclass(frozen=True)
class Options:
    """What a way is made for; see `workbench.optics.plan.Plan`."""

    net: ControlNet
    dtype: torch.dtype
    device: torch.device
    samples: tuple[int, int] | None
    mirrored: tuple[bool, bool]
    locked: Mask | None


def way_of(scene: Scene, options: Options) -> Way:
    """The way for a scene's source."""
    net, dtype, device = options.net, options.dtype, options.device
    if isinstance(scene.source, CollimatedSource):
        count = options.samples or scene.source.rays
        return Way(
            ["collimated light: entrance refraction and intersection left out"],
            cache(lambda: Reference(CollimatedRays(scene, net, count, dtype, device))),
            cache(
                lambda: FusedCollimatedRays(
                    scene, net, count, options.mirrored, dtype, options.locked
                )
            ),
            "collimated",
        )
    samples = options.samples
    if samples is not None:
        return Way(
            ["samples on the exit face: no ray has to search for it"],
            cache(lambda: Reference(FaceSamples(scene, net, samples, dtype, device))),
            cache(lambda: FusedFaceSamples(scene, net, samples, options.mirrored, dtype)),
            "face",
        )
    rays = PointRays(scene, net, dtype=dtype, device=device)
    mesh = isinstance(scene.source.intersection, MeshMethod)
    return Way(
        ["intersection with the triangle mesh: by the reference alone"] if mesh else [],
        cache(lambda: Reference(rays)),
        cache(lambda: FusedPointRays(rays, scene, net, dtype)),
        None if mesh else "point",
        rays.redraw if scene.source.fresh else _same,
    )
