"""Which tracer serves a path: a compiled one, if there is one and it is ready."""

from typing import NamedTuple

import torch

from workbench.compiled import unkept
from workbench.optics import ready
from workbench.optics.path import Path
from workbench.said import Said


class Choice(NamedTuple):
    """What a plan knows of its path."""

    path: Path  # the way of the light
    kernel: str | None  # name of the compiled tracer in `workbench.optics.ready`
    fused: bool  # False asks for the reference
    fine: bool  # whether the scene needs float64

    @property
    def compiled(self) -> bool:
        """Whether the kernel does the work; see `workbench.optics.ready`."""
        on_cpu = torch.device(self.path.device).type == "cpu"
        wanted = self.fused and on_cpu and self.kernel is not None
        return wanted and self.kernel is not None and ready.obtain(self.kernel, self.path.dtype)

    def notes(self, of_tracer: list[str]) -> list[str]:
        """What was chosen and why, in words, for a run's log.

        `of_tracer`: what is special about the tracer.
        """
        precision = str(self.path.dtype).removeprefix("torch.")
        if self.compiled:
            threads = torch.get_num_threads()
            if threads > 1:
                chosen = Said(
                    "fused kernels, {threads} threads, {precision}",
                    threads=threads,
                    precision=precision,
                )
            else:
                chosen = Said("fused kernels, 1 thread, {precision}", precision=precision)
        else:
            device = torch.device(self.path.device).type
            chosen = Said(
                "reference in torch on {device}, {precision}", device=device, precision=precision
            )
        notes = [chosen, *of_tracer]
        if self.kernel is None:
            faces = ", ".join(step.surface.kind for step in self.path.steps)
            notes.append(
                Said("no kernel for this path ({faces}): by the reference alone", faces=faces)
            )
        if self.fine:
            notes.append(Said("float64: float32 has too few digits for this scene"))
        return notes

    def defects(self) -> list[str]:
        """What makes traces or starts slower than they should be."""
        notes: list[str] = []
        error = None
        if self.fused and self.kernel is not None:
            error = ready.failure(self.kernel, self.path.dtype)
        if error is not None:
            notes.append(
                Said(
                    "the kernel could not be compiled ({error}), so this run is many times slower",
                    error=f"{type(error).__name__}: {error}",
                )
            )
        if reason := unkept():
            notes.append(
                Said(
                    "compiled kernels could not be kept ({reason}), so each start compiles them "
                    "again",
                    reason=reason,
                )
            )
        return notes
