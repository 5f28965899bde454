"""The ways to trace a path: the reference, and the compiled tracer that matches."""

from functools import cached_property
from typing import Protocol

from workbench.optics.kernels.point import FusedPointRays
from workbench.optics.light import Tracer
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.train.compiled import CompiledTrain


class Kernel(Protocol):
    """A kind of compiled tracer.

    Attributes
    ----------
    name : str
        What it is called in `workbench.optics.ready`.
    """

    name: str

    @staticmethod
    def matches(path: Path) -> bool:
        """Whether it traces what the reference makes of a path."""
        ...

    def __call__(self, path: Path, mirrored: tuple[bool, bool]) -> Tracer:
        """A tracer of the path; see `workbench.optics.plan.Plan`."""
        ...


_KERNELS: tuple[Kernel, ...] = (CompiledTrain, FusedPointRays)


class Tracers:
    """The ways to trace one path; each is made at its first use.

    So a run that has its kernel never makes the reference.

    Parameters
    ----------
    path : Path
        The path.
    mirrored
        See `workbench.optics.plan.Plan`.

    Attributes
    ----------
    kind : Kernel or None
        The compiled tracer, if there is one for the path.
    """

    def __init__(self, path: Path, mirrored: tuple[bool, bool]) -> None:
        self.path, self._promised = path, mirrored
        self.kind = next((kernel for kernel in _KERNELS if kernel.matches(path)), None)

    @cached_property
    def reference(self) -> Reference:
        """The reference in torch."""
        return Reference(self.path)

    @cached_property
    def kernel(self) -> Tracer:
        """The compiled tracer."""
        if self.kind is None:
            raise TypeError("there is no kernel for this path")
        return self.kind(self.path, self._promised)
