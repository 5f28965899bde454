"""Light of a source of some size as the light of its middle, blurred.

Where each part of a lens makes about the same blur of a source, all of its light is that of its
middle, convolved with this blur. One trace does what many origins do, and without their noise: a
lens for such a source makes spots and lines that are much narrower than its blur, and origins draw
each of them as so many dots. A letter in the sun, which blurs it over 5.9 pixels, on 384 x 384
control points (relative L2; busy cores):

| image of the same lens | error |
|---|---|
| 64 origins x 256 x 256 cells | 7.2 % |
| 256 origins x 256 x 256 cells | 6.1 % |
| 256 origins x 512 x 512 cells | 5.7 % |
| its middle, 768 x 768 cells, blurred from thirds of a pixel | 5.8 % |
| the same with 1536 x 1536 cells, from quarters | 5.7 % |
"""

from collections.abc import Mapping

import numpy as np
import torch
from scipy.fft import next_fast_len
from torch import Tensor

from workbench.extended.blur import Blur
from workbench.optics.account import Account
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.light import Light
from workbench.optics.samples import Corners
from workbench.said import Said
from workbench.scene import Scene


class BlurredPlan:
    """Images of the middle of a source, blurred; as `workbench.optics.beam_plan.BeamPlan`.

    Parameters
    ----------
    scene : Scene
        What is traced.
    cells : tuple[int, int]
        Cells along x and y between the rays.
    blur : Blur
        What any part of the lens makes of the source.
    mirrored : tuple[bool, bool]
        As for `BeamPlan`.
    """

    def __init__(
        self,
        scene: Scene,
        cells: tuple[int, int],
        blur: Blur,
        mirrored: tuple[bool, bool] = (False, False),
    ) -> None:
        receiver, self._parts = scene.receiver, blur.parts
        n_x, n_y = (self._parts * n for n in receiver.pixels)
        fine = scene.with_receiver(receiver.model_copy(update={"pixels": (n_x, n_y)}))
        fine = fine.model_copy(update={"source": scene.source.sharp})
        self._pixels, self._blur = receiver.pixels, blur
        self._plan = BeamPlan(fine, Corners(*cells), mirrored=mirrored)
        self._waves: dict[tuple[int, int], Tensor] = {}

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for this scene and what is left out, in words, for a run's log."""
        x, y = self._blur.widths
        blurred = Said("its light is blurred over {x:.3g} × {y:.3g} pixels", x=x, y=y)
        return *self._plan.notes, blurred

    def trace(self, heights: Mapping[str, Tensor], margin: tuple[int, int] = (0, 0)) -> Light:
        """Image and light account of a lens; see `BeamPlan.trace`."""
        (n_x, n_y), (m_x, m_y), parts = self._pixels, margin, self._parts
        sharp, account = self._plan.trace(heights, (parts * m_x, parts * m_y))
        wide = n_y + 2 * m_y, n_x + 2 * m_x
        # One image for each place in a pixel: [parts, parts, *wide].
        places = sharp.view(wide[0], parts, wide[1], parts).permute(1, 3, 0, 2)
        b_x, b_y = self._blur.margin
        grid = next_fast_len(wide[0] + 2 * b_y), next_fast_len(wide[1] + 2 * b_x)
        waves = torch.fft.rfft2(places, s=grid) * self._kernels(grid, sharp)
        image = torch.fft.irfft2(waves.sum((0, 1)), s=grid)[
            b_y : b_y + wide[0], b_x : b_x + wide[1]
        ]
        image = image.clamp_min(0)  # but for rounding it is not negative
        seen = image.detach()[m_y : m_y + n_y, m_x : m_x + n_x].sum(dtype=torch.float64).item()
        on_screen = min(seen, account.arrived)
        lost = {**account.lost, "off_screen": account.arrived - on_screen}
        return Light(image, Account(on_screen, lost))

    def _kernels(self, grid: tuple[int, int], like: Tensor) -> Tensor:
        """Frequencies of the blur about each place in a pixel, [parts, parts, ...]."""
        if grid not in self._waves:
            parts = self._parts
            kernels = self._blur.at((np.arange(parts) + 0.5) / parts - 0.5)
            found = torch.as_tensor(kernels.reshape(parts, parts, *kernels.shape[1:])).to(like)
            self._waves[grid] = torch.fft.rfft2(found, s=grid)
        return self._waves[grid]
