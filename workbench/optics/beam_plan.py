"""Beams of light of a scene, ready to be traced through lens after lens."""

import math
from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.optics.images.beams import beam_image, box_image
from workbench.optics.images.rim import rim_light, split_light
from workbench.optics.images.source_beams import Spots, between_origins, light_apart, spots_of
from workbench.optics.interfaces import Refraction
from workbench.optics.light import BeamTracer, Light, sum_of_lines
from workbench.optics.plan import TracedLine, notes_of_lines, traced_lines
from workbench.optics.samples import Corners
from workbench.scene import Scene

_NEARLY_ALL = 0.999
# Less light than this in cells that are totally reflected in part is left out, for speed.
_SPLIT = 1e-4


class BeamPlan:
    """Images of beams, by fused kernels where there are some, else by the torch reference.

    Each line of the light is traced by itself, and the image is their sum; see `Scene.lines`.

    `scene`: what is traced; `cells`: cells along x and y between the rays of each origin of the
    light, and how many origins there are of a source that leaves that open; `net`: control net of
    the heights to come; the scene's own by default; `dtype`: float type of the trace; by default
    the one that the scene needs, see `precision_of`; `fused`: False asks for the reference;
    `mirrored`: the caller's promise that heights, lens and source are mirror images of themselves
    in x, in y. Kernels then trace one half of the rays only, if the number of cells is even.
    `boxes`: whether cells are drawn as boxes. Raises `Refused` if the
    scene asks for a device that is not there.
    """

    def __init__(
        self,
        scene: Scene,
        cells: tuple[int, int] | Corners,
        net: ControlNet | None = None,
        dtype: torch.dtype | None = None,
        fused: bool = True,
        mirrored: tuple[bool, bool] = (False, False),
    ) -> None:
        corners = Corners(*cells)
        self._lines = traced_lines(scene, net, dtype, fused, corners, mirrored)
        # Its notes hold nearly for all spectral lines.
        self._strongest = max(self._lines, key=lambda line: line.part)
        self._called, self._back = scene.receiver.called, scene.optic.onwards < 0
        self._pixels, self._half_extent = scene.receiver.pixels, scene.receiver.half_extent
        self._of_source = corners.of_source
        # Of the origins that stand for a source of some size; not of points that are there.
        many = scene.source.continuous and corners.origins > 1
        self.boxes = many and corners.of_source is None
        path = self._strongest.tracers.path
        self._missed, self._of_light = path.steps[0].missed, path.emitter.origins.note
        self._beside = path.steps[-1].missed
        turns = (step.interface for step in reversed(path.steps))
        totals = (turn.total for turn in turns if isinstance(turn, Refraction))
        self._totals = list(filter(None, totals))
        self._fused = fused

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        choice, tracer = self._strongest.choice, self._strongest.tracer
        notes = choice.notes(tracer.notes) + notes_of_lines(len(self._lines))
        rays = math.prod(len(split) for split in tracer.splits)
        notes.append(
            Message("beams of light between {rays} rays: no noise, and no filter", rays=f"{rays:,}")
        )
        if self._of_source:
            notes.append(
                Message("beams run between points of the source, through each sample of the lens")
            )
        if self._back:
            notes.append(
                Message(
                    "shading by the {receiver} and by the mirror itself is ignored",
                    receiver=self._called,
                )
            )
        return (*filter(None, (*notes, self._of_light)), *choice.defects())

    def light_extent(self, heights: Mapping[str, Tensor]) -> tuple[float, float]:
        """How far from the receiver's middle, along u and v, nearly all light of a line falls."""
        far_x, far_y = zip(*(self._extent(line, heights) for line in self._lines), strict=True)
        return max(far_x), max(far_y)

    def _extent(self, line: TracedLine, heights: Mapping[str, Tensor]) -> tuple[float, float]:
        with torch.no_grad():
            column, row, flux = line.tracer.nodes(heights).hits
        lands = (flux > 0) & column.isfinite() & row.isfinite()
        if not lands.any():
            return 0.0, 0.0
        far = (
            (hits[lands].double().cpu().numpy() / pixels - 0.5) * 2 * half_extent
            for hits, pixels, half_extent in zip(
                (column, row), self._pixels, self._half_extent, strict=True
            )
        )
        far_x, far_y = (float(np.quantile(np.abs(from_middle), _NEARLY_ALL)) for from_middle in far)
        return far_x, far_y

    def places(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Tensor]:
        """Columns and rows, in pixels, where the rays of the strongest line land."""
        with torch.no_grad():
            column, row, _ = self._strongest.tracer.nodes(heights).hits
        return column, row

    def light_apart(self, heights: Mapping[str, Tensor]) -> float:
        """Which part of the light passes samples that are far apart for beams between origins.

        Raises `TypeError` if beams do not run between origins.
        """
        if self._of_source is None:
            raise TypeError("these beams run between samples of the lens")
        with torch.no_grad():
            tracer = self._strongest.tracer
            return light_apart(tracer.nodes(heights), self._of_source, tracer.mirrored)

    def spots(self, heights: Mapping[str, Tensor]) -> Spots:
        """What samples make of the source, of which 2 x 2 cells were asked for; see `spots_of`."""
        with torch.no_grad():
            return spots_of(self._strongest.tracer.nodes(heights))

    def trace(self, heights: Mapping[str, Tensor], margin: tuple[int, int] = (0, 0)) -> Light:
        """Image and light account of a lens.

        `heights` (n_u, n_v): control heights of each freeform face by name, scene units; `margin`:
        pixels (m_x, m_y) that the image has beyond the screen on each side. Returns with an image
        of shape (n_y + 2 m_y, n_x + 2 m_x).
        """
        return sum_of_lines(
            (line.part, self._of_line(line.tracer, heights, margin)) for line in self._lines
        )

    def _of_line(
        self, tracer: BeamTracer, heights: Mapping[str, Tensor], margin: tuple[int, int]
    ) -> Light:
        found, splits = tracer.nodes(heights), tracer.splits
        if self._of_source is not None:
            found, splits = between_origins(found, self._of_source, tracer.mirrored)
        hits, account, rim_distance = found
        (n_x, n_y), (m_x, m_y) = self._pixels, margin
        wide, lost = (n_x + 2 * m_x, n_y + 2 * m_y), dict(account.lost)
        with torch.no_grad():  # in place: a copy takes a tenth of the time of the trace
            hits[0] += m_x
            hits[1] += m_y
        drawn = box_image if self.boxes else beam_image
        image, landed = drawn(hits, wide, splits, self._fused)
        cut = 0.0
        if rim_distance is not None:
            rim = rim_light(hits, rim_distance, wide, splits, self._fused, not self.boxes)
            image, landed, cut = image + rim.flux, landed + rim.landed, rim.counted - rim.landed
        # Of all rays that are refracted, what is neither drawn nor cut is in split cells.
        copies = 2 ** sum(tracer.mirrored)
        if account.on_screen - copies * (landed + cut) > _SPLIT:
            more, lands = split_light(hits, rim_distance, wide, splits, triangles=not self.boxes)
            image, landed = image + more, landed + lands
        for axis in (0, 1):
            if tracer.mirrored[axis]:
                image, landed, cut = image + image.flip(1 - axis), 2 * landed, 2 * cut
        on_screen = image.detach()[m_y : m_y + n_y, m_x : m_x + n_x].sum(dtype=torch.float64).item()
        lost["off_screen"] += landed - on_screen
        lost[self._beside] += cut
        # The rest is in split cells: some corners are lost on the way, most by total reflection.
        split = max(self._totals, key=account.lost.__getitem__, default=self._beside)
        lost[split] += account.on_screen - landed - cut
        # Light that no ray stands for passes the lens by.
        lost[self._missed] += 1 - account.on_screen - sum(account.lost.values())
        return Light(image, Account(on_screen, lost))
