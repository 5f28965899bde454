"""The plan of a trace: which steps a scene needs, and all that stays constant while it runs."""

from collections.abc import Mapping
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.choice import Choice
from workbench.optics.light import Light, Tracer, sum_of_lines
from workbench.optics.path import Path
from workbench.optics.precision import precision_of
from workbench.optics.samples import Samples
from workbench.optics.tracers import Tracers
from workbench.said import Said
from workbench.scene import Filter, Scene


class Plan:
    """A trace that is ready to go: fused kernels where there are some, else the torch reference.

    Each line of the light is traced by itself, and the image is their sum; see `Scene.lines`.

    `scene`: what is traced; `net`: control net of the heights to come; the scene's own by default;
    `filter`: reconstruction filter; the scene's own by default; `dtype`: float type of the trace;
    by default the one that the scene needs, see `precision_of`; `fused`: False asks for the
    reference; `samples`: rays of collimated light along x and y; or corners of cells of any light,
    of which the first freeform face is sampled. By default the rays of the source; `mirrored`: the
    caller's promise that heights, lens and source are mirror images of themselves in x, in y. The
    kernel for collimated light then traces one half of the rays only. Raises `Refused` if the scene
    asks for a device that is not there.
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
        self._lines = []
        for line in scene.lines:
            path = Path.of(line.scene, net, dtype or needed, device_of(scene), samples)
            tracers = Tracers(path, mirrored)
            choice = Choice(path, tracers.compiled, fused, fine)
            self._lines.append(_TracedLine(line.part, tracers, choice))

    def trace(self, heights: Mapping[str, Tensor]) -> Light:
        """Image and light account of a lens.

        `heights` (n_u, n_v).
        """
        return sum_of_lines(
            (line.part, line.tracer.image(heights, self._filter)) for line in self._lines
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        line = self._lines[0]
        notes = line.choice.notes(line.tracer.notes) + notes_of_lines(len(self._lines))
        if not self._filter.smooth:
            notes.append(Said("box filter: one pixel a ray, no ghost pixels"))
        return tuple(notes + line.choice.defects())

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        if self._redrawn:
            for line in self._lines:
                line.tracers.path.redraw()

    def flux(self, heights: Mapping[str, Tensor]) -> Tensor:
        """The image alone, for `torch.func` transforms such as jvp: always by the reference."""
        images = [
            line.part * line.tracers.reference.flux(heights, self._filter) for line in self._lines
        ]
        return sum(images[1:], images[0])


class _TracedLine(NamedTuple):
    part: float
    tracers: Tracers
    choice: Choice

    @property
    def tracer(self) -> Tracer:
        return self.tracers.kernel if self.choice.compiled else self.tracers.reference


def notes_of_lines(count: int) -> list[str]:
    """What a log says of so many lines of light; nothing of one."""
    if count == 1:
        return []
    return [Said("{count} lines of light, each with its own refractive indices", count=count)]


def device_of(scene: Scene) -> torch.device:
    """The device on which a scene wants to be traced.

    Raises `Refused` if it is not there.
    """
    if scene.run.device == "cuda" and not torch.cuda.is_available():
        raise Refused(
            "run.device",
            Said("'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'"),
        )
    return torch.device(scene.run.device)


def tensors_of(heights: Mapping[str, Array], scene: Scene) -> dict[str, Tensor]:
    """Control heights of each freeform face, copied to where a scene wants to be traced.

    `heights` (n_u, n_v): by the names of the faces, scene units; `scene`: of the trace; see
    `device_of`.
    """
    device = device_of(scene)
    return {face: torch.tensor(each, device=device) for face, each in heights.items()}
