"""The ways to trace a path: the reference, and the first compiled special case that matches.

A new special case is a file in `workbench.optics.kernels` and an entry in ``_KERNELS``.
"""

from functools import cached_property
from typing import Protocol

from workbench.arrays import Mask
from workbench.optics.kernels.collimated import FusedCollimatedRays
from workbench.optics.kernels.face import FusedFaceSamples
from workbench.optics.kernels.mirror import FusedMirrorRays
from workbench.optics.kernels.origins import FusedOrigins
from workbench.optics.kernels.point import FusedPointRays
from workbench.optics.kernels.two_faces import FusedTwoFaces
from workbench.optics.light import BeamTracer, Tracer
from workbench.optics.path import Path
from workbench.optics.reference import Reference


class Kernel(Protocol):
    """A kind of compiled tracer.

    Attributes
    ----------
    name : str
        What it is called in `workbench.optics.kernels.ready`.
    """

    name: str

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        ...

    def __call__(self, path: Path, mirrored: tuple[bool, bool], locked: Mask | None) -> Tracer:
        """A tracer of the path; see `workbench.optics.plan.Plan`."""
        ...


class BeamKernel(Protocol):
    """A kind of compiled tracer that traces corners of cells, too."""

    name: str

    @staticmethod
    def matches(path: Path) -> bool:
        """See `Kernel`."""
        ...

    def __call__(self, path: Path, mirrored: tuple[bool, bool]) -> BeamTracer:
        """A tracer of the path; see `workbench.optics.beam_plan.BeamPlan`."""
        ...


_BEAM_KERNELS: tuple[BeamKernel, ...] = (
    FusedCollimatedRays,
    FusedMirrorRays,
    FusedFaceSamples,
    FusedOrigins,
    FusedTwoFaces,
)
_KERNELS: tuple[Kernel, ...] = (
    FusedCollimatedRays,
    FusedMirrorRays,
    FusedFaceSamples,
    FusedPointRays,
)


def beam_kernel_of(path: Path) -> BeamKernel | None:
    """The compiled special case that traces the corners of cells of a path, if there is one."""
    return next((kernel for kernel in _BEAM_KERNELS if kernel.matches(path)), None)


class Tracers:
    """The ways to trace one path; each is made at its first use.

    So a run that has its kernel never makes the reference.

    Parameters
    ----------
    path : Path
        The path.
    mirrored, locked
        See `workbench.optics.plan.Plan`.

    Attributes
    ----------
    kind : Kernel or None
        The compiled special case, if there is one for the path.
    """

    def __init__(self, path: Path, mirrored: tuple[bool, bool], locked: Mask | None) -> None:
        self.path, self._promised = path, (mirrored, locked)
        self.kind = next((kernel for kernel in _KERNELS if kernel.matches(path)), None)

    @cached_property
    def reference(self) -> Reference:
        """The reference in torch."""
        return Reference(self.path)

    @cached_property
    def kernel(self) -> Tracer:
        """The compiled special case."""
        if self.kind is None:
            raise TypeError("there is no kernel for this path")
        return self.kind(self.path, *self._promised)
