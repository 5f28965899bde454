"""The plan of a trace: its float type, its tracer, and all that stays constant during a run.

Float32 moves hits by `shift_of` pixels. In a thousand traces of extreme scenes the image in float32
was off by less than 6e-4 of its light for shifts below 1e-2 pixels, and by 2 above 1e-1; the
gradient by less than 6e-2 and by 9. For a lens of the thickness t at the distance d from its
source, the account of a rough lens was off by 0.1 ε t / d and more, where ε is float32's rounding.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.compiled import unkept
from workbench.errors import Refused
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.messages import Message
from workbench.optics import ready
from workbench.optics.light import Light, sum_of_lines
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Samples
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Element, Filter, Scene

# In pixels: the image is good to 1e-3 of its light up to here, the gradient to a few per cent.
_TOLERABLE = 0.01
# Of ε t / d: the light of samples is good to 1e-4 up to here.
_NEAR = 1e-3
# Where the lens does not say how far its heights go: that part of its half-width, as in most lenses
# that bend their light over the whole screen.
_RISE = 0.3


def precision_of(scene: Scene, net: ControlNet | None = None) -> torch.dtype:
    """The float type in which a scene is traced: float32 unless that moves light too far.

    `scene`: what is traced; `net`: control net of the heights to come; the scene's own by default.
    """
    scene = scene.alone
    fine = shift_of(scene, net) > _TOLERABLE or nearly_touches(scene)
    return torch.float64 if fine else torch.float32


def nearly_touches(scene: Scene) -> bool:
    """Whether a source is so near before the element that float32 does not know its light there."""
    optic = scene.optic
    _, high = _extent(optic)
    distance = optic.front_z - scene.source.nearest_z
    return torch.finfo(torch.float32).eps * (high - optic.front_z) > _NEAR * distance


def shift_of(scene: Scene, net: ControlNet | None = None) -> float:
    """About how far float32 moves hits, in pixels.

    Heights are rounded to a part ε of the largest, so slopes to that over the distance of control
    points; light is bent by n − 1 times the slope. Directions of rays from points are rounded, too,
    and so is the way to a screen, which moves light along one that leans.
    """
    optic, receiver = scene.optic, scene.receiver
    net = net or ControlNet.of(optic)
    low, high = _extent(optic)
    level, steepest = optic.base.height, 0.0
    nets = [each for face, each in freeform_nets(optic).items() if face != optic.designed_face]
    if not scene.source.along_axis or nets:
        steepest = optic.steepest
    if not scene.source.along_axis and not nets:
        level = min(level, optic.front_z)  # rays that search for the face count from there
    largest = max(abs(low - level), abs(high - level))
    density = max(
        count / r
        for each in (net, *nets)
        for count, r in zip(each.shape, each.half_width, strict=True)
    )
    deflection = optic.deflection * largest * density
    # From the lowest point of the lens, the farthest from the receiver.
    pixels = max(
        (far * (deflection + steepest) + along) * m / (2 * r)
        for far, along, m, r in zip(
            receiver.per_radian(low),
            receiver.lean(low),
            receiver.pixels,
            receiver.half_extent,
            strict=True,
        )
    )
    return torch.finfo(torch.float32).eps * pixels


def _extent(optic: Element) -> tuple[float, float]:
    """The lowest and the highest z of its face, or about that."""
    rise = _RISE * max(optic.half_width)
    low, high = optic.base.extent(optic.half_width)
    below, above = optic.height_range or (-rise, rise)
    return low + below, high + above


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
                chosen = Message(
                    "fused kernels, {threads} threads, {precision}",
                    threads=threads,
                    precision=precision,
                )
            else:
                chosen = Message("fused kernels, 1 thread, {precision}", precision=precision)
        else:
            device = torch.device(self.path.device).type
            chosen = Message(
                "reference in torch on {device}, {precision}", device=device, precision=precision
            )
        notes = [chosen, *of_tracer]
        if self.kernel is None:
            faces = ", ".join(step.surface.kind for step in self.path.steps)
            notes.append(
                Message("no kernel for this path ({faces}): by the reference alone", faces=faces)
            )
        if self.fine:
            notes.append(Message("float64: float32 has too few digits for this scene"))
        return notes

    def defects(self) -> list[str]:
        """What makes traces or starts slower than they should be."""
        notes: list[str] = []
        error = None
        if self.fused and self.kernel is not None:
            error = ready.failure(self.kernel, self.path.dtype)
        if error is not None:
            notes.append(
                Message(
                    "the kernel could not be compiled ({error}), so this run is many times slower",
                    error=f"{type(error).__name__}: {error}",
                )
            )
        if reason := unkept():
            notes.append(
                Message(
                    "compiled kernels could not be kept ({reason}), so each start compiles them "
                    "again",
                    reason=reason,
                )
            )
        return notes


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
    def kernel(self) -> CompiledTrain:
        """The compiled train."""
        return CompiledTrain(self.path, self._promised)


class TracedLine(NamedTuple):
    """One line of the light: its part of the flux, and what traces it."""

    part: float
    tracers: Tracers
    choice: Choice

    @property
    def tracer(self) -> CompiledTrain | Reference:
        """What traces the line now; see `Choice.compiled`."""
        return self.tracers.kernel if self.choice.compiled else self.tracers.reference


def traced_lines(
    scene: Scene,
    net: ControlNet | None,
    dtype: torch.dtype | None,
    fused: bool,
    samples: Samples | None,
    mirrored: tuple[bool, bool],
) -> list[TracedLine]:
    """The lines of a scene's light; for the parameters see `Plan`."""
    net = net or ControlNet.of(scene.optic)
    needed = precision_of(scene, net)
    # Fine by the scene's need, not by that of the caller.
    fine = dtype is None and needed == torch.float64
    lines = []
    for line in scene.lines:
        path = Path.of(line.scene, net, dtype or needed, device_of(scene), samples)
        tracers = Tracers(path, mirrored)
        lines.append(TracedLine(line.part, tracers, Choice(path, tracers.compiled, fused, fine)))
    return lines


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
        self._redrawn = scene.source.redrawn
        self._lines = traced_lines(scene, net, dtype, fused, samples, mirrored)

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
            notes.append(Message("box filter: one pixel a ray, no ghost pixels"))
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


def notes_of_lines(count: int) -> list[str]:
    """What a log says of so many lines of light; nothing of one."""
    if count == 1:
        return []
    return [Message("{count} lines of light, each with its own refractive indices", count=count)]


def device_of(scene: Scene) -> torch.device:
    """The device on which a scene wants to be traced.

    Raises `Refused` if it is not there.
    """
    if scene.run.device == "cuda" and not torch.cuda.is_available():
        raise Refused(
            "run.device",
            Message("'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'"),
        )
    return torch.device(scene.run.device)


def arrays_of(heights: Mapping[str, Tensor]) -> ControlHeights:
    """Control heights (n_u, n_v) of each freeform face out of their device and float type."""
    return FaceArrays({k: each.detach().double().cpu().numpy() for k, each in heights.items()})


def tensors_of(heights: Mapping[str, Array], scene: Scene) -> dict[str, Tensor]:
    """Control heights of each freeform face, copied to where a scene wants to be traced.

    `heights` (n_u, n_v): by the names of the faces, scene units; `scene`: of the trace; see
    `device_of`.
    """
    device = device_of(scene)
    return {face: torch.tensor(each, device=device) for face, each in heights.items()}
