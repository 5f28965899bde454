"""The ways to trace a path: the reference, and the compiled train if it matches."""

from functools import cached_property

from workbench.optics.light import Tracer
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.train.compiled import CompiledTrain


class Tracers:
    """The ways to trace one path; each is made at its first use.

    So a run that has its kernel never makes the reference.

    `mirrored`: see `workbench.optics.plan.Plan`. `compiled`: name of the compiled train in
    `workbench.optics.ready`, if it matches the path.
    """

    def __init__(self, path: Path, mirrored: tuple[bool, bool]) -> None:
        self.path, self._promised = path, mirrored
        self.compiled = CompiledTrain.name if CompiledTrain.matches(path) else None

    @cached_property
    def reference(self) -> Reference:
        """The reference in torch."""
        return Reference(self.path)

    @cached_property
    def kernel(self) -> Tracer:
        """The compiled train."""
        return CompiledTrain(self.path, self._promised)
