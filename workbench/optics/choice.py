"""Which tracer serves a path: the compiled special case, if there is one and it is ready."""

from typing import NamedTuple

import torch

from workbench.compiled import unkept
from workbench.optics.kernels import ready
from workbench.optics.path import Path


class Choice(NamedTuple):
    """What a plan knows of its path.

    Attributes
    ----------
    path : Path
        The way of the light.
    kernel : str, optional
        Name of the compiled special case in `workbench.optics.kernels.ready`.
    fused : bool
        False asks for the reference.
    fine : bool
        Whether the scene needs float64.
    """

    path: Path
    kernel: str | None
    fused: bool
    fine: bool

    @property
    def compiled(self) -> bool:
        """Whether the kernel does the work; see `workbench.optics.kernels.ready`."""
        on_cpu = torch.device(self.path.device).type == "cpu"
        wanted = self.fused and on_cpu and self.kernel is not None
        return wanted and self.kernel is not None and ready.obtain(self.kernel, self.path.dtype)

    def notes(self, of_tracer: list[str]) -> list[str]:
        """What was chosen and why, in words, for a run's log.

        Parameters
        ----------
        of_tracer : list of str
            What is special about the tracer.
        """
        precision = str(self.path.dtype).removeprefix("torch.")
        if self.compiled:
            threads = torch.get_num_threads()
            notes = [f"fused kernels, {threads} thread{'s' * (threads > 1)}, {precision}"]
        else:
            device = torch.device(self.path.device).type
            notes = [f"reference in torch on {device}, {precision}"]
        notes += of_tracer
        if self.kernel is None:
            faces = ", ".join(step.surface.kind for step in self.path.steps)
            notes.append(f"no kernel for this path ({faces}): by the reference alone")
        if self.fine:
            notes.append("float64: float32 would move light by a part of a pixel")
        return notes

    def defects(self) -> list[str]:
        """What makes traces or starts slower than they should be."""
        notes, error = [], None
        if self.fused and self.kernel is not None:
            error = ready.failure(self.kernel, self.path.dtype)
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
