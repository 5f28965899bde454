"""Images of a lens at several receivers, each against a target of its own."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import torch
from torch import Tensor

from workbench.design.lens_state import FurtherLight
from workbench.design.loss import share
from workbench.design.step import Step
from workbench.design.wide_image import WideImage
from workbench.scene import WantedImage


class SeveralImages:
    """Compares lenses with several targets at once, as `WideImage` does with one.

    The square of its error is the mean of the squares of theirs, each relative to its own target,
    by the weights of the images.

    `images`: one for each of the scene's images; `wanted`: the same images, as the task asks for
    them. `effort`: of all of them together; see `WideImage`; `blurred`: whether any is the light of
    a source whose size blurs it; `blur_widths`: the least of those of all images; see `WideImage`.
    """

    def __init__(self, images: Sequence[WideImage], wanted: Sequence[WantedImage]) -> None:
        self._images = images
        total = sum(image.weight for image in wanted)
        self._weights = [image.weight / total for image in wanted]
        # By these the paper's loss becomes an error relative to the target.
        self._units = [
            float(np.linalg.norm(share(image.target))) / image.target.size**0.5 for image in wanted
        ]
        self.effort = sum(image.effort for image in images)
        self.blurred = any(image.blurred for image in images)
        x, y = (min(widths) for widths in zip(*(i.blur_widths for i in images), strict=True))
        self.blur_widths = x, y

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """Errors of all images in a row, and the step to report; see `WideImage.compare`."""
        found = [image.compare(heights) for image in self._images]
        parts = (
            math.sqrt(weight) * error.flatten()
            for weight, (error, _) in zip(self._weights, found, strict=True)
        )
        return torch.cat(list(parts)), self._joined([step for _, step in found])

    def step(self, heights: Mapping[str, Tensor]) -> Step:
        """The step to report of a lens; see `WideImage.step`."""
        return self._joined([image.step(heights) for image in self._images])

    def _joined(self, steps: Sequence[Step]) -> Step:
        """One step for those of all images, with the notes of the first."""
        first, *others = (step.state for step in steps)
        squares = (
            weight * (step.state.loss / unit) ** 2
            for weight, unit, step in zip(self._weights, self._units, steps, strict=True)
        )
        further = tuple(FurtherLight(s.irradiance, s.loss, s.account) for s in others)
        loss = self._units[0] * math.sqrt(sum(squares))
        # Without light at one of its places, a lens is no good.
        dark = any(step.merit is not None for step in steps)
        return Step(
            replace(first, loss=loss, further=further), steps[0].notes, math.inf if dark else None
        )


AnyImage = WideImage | SeveralImages
"""What lenses are compared by."""
