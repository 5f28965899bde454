"""Video of a run: its image of light after more and more iterations, as GIF, WebP or APNG."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import numpy.typing as npt
from matplotlib.font_manager import findfont
from PIL import Image, ImageDraw, ImageFont

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.pictures.images import (
    colours_for,
    full_scale,
    signed_error,
    target_irradiance,
    to_colours,
)
from workbench.scene import Scene
from workbench.scene.image import as_viewed

ENDINGS = {".gif": "GIF", ".webp": "WEBP", ".apng": "PNG"}
"""Formats of a video by the endings of file names."""
_PIXELS = 480  # along the longer side
_MOST = 128  # images; of more, every second one is left out
_CAPTION, _FONT, _MARGIN = 26, 15, 6  # pixels
_INK, _GROUND = "#e8eaed", "#16191f"
_WHOLE, _LEAST, _LARGEST, _LAST = 6000, 40, 500, 2000  # milliseconds: all, each, and the last


def check_video(path: Path) -> None:
    """Raise Refused if the ending of a path is none of a video."""
    if path.suffix.lower() not in ENDINGS:
        known = ", ".join(ENDINGS)
        raise Refused(
            str(path), Message("has no known ending; use one of {endings}", endings=known)
        )


class Video:
    """Images of the lenses of a run, each with a caption of its iteration and error.

    ``caption`` returns the text for an iteration and a relative L2 error. ``colours`` is one of
    `workbench.pictures.axes.UNSIGNED`, by default that for the scene.
    """

    def __init__(
        self,
        scene: Scene,
        target: npt.NDArray[Any],
        caption: Callable[[int, float], str],
        colours: str = "",
    ) -> None:
        self._scene, self._target = scene, target
        self._caption, self._colours = caption, colours or colours_for(scene)
        across, up = scene.receiver.half_extent
        scale = _PIXELS / max(across, up)
        self._size = max(round(scale * across), 1), max(round(scale * up), 1)
        self._font = ImageFont.truetype(findfont("DejaVu Sans"), _FONT)
        self._images: list[tuple[int, Image.Image]] = []
        self._gap = 1  # iterations between images, at least

    def add(self, irradiance: Array, iteration: int) -> None:
        """Add the image (n_y, n_x) of a lens after an iteration; one of the same replaces it."""
        images = self._images
        if len(images) > 1 and images[-1][0] - images[-2][0] < self._gap:
            images.pop()
        if images and images[-1][0] == iteration:
            images.pop()
        images.append((iteration, self._drawn(irradiance, iteration)))
        if len(images) > _MOST:
            self._gap *= 2
            images[:] = [*images[:-1:2], images[-1]]

    def write(self, file: BinaryIO, ending: str) -> None:
        """Write the images one after the other, in a format of `ENDINGS`; the last one stays."""
        first, *others = (image for _, image in self._images)
        each = min(max(_WHOLE // len(self._images), _LEAST), _LARGEST)
        times = [*(len(others) * [each]), _LAST]
        save = partial(first.save, file, ENDINGS[ending], save_all=True, append_images=others)
        save(duration=times if others else _LAST, loop=0)

    def _drawn(self, irradiance: Array, iteration: int) -> Image.Image:
        scene, target = self._scene, self._target
        top = full_scale(scene, target, scene.receiver.total(irradiance))
        pixels = to_colours(as_viewed(scene, irradiance), top, self._colours)
        image = Image.fromarray(pixels).resize(self._size, Image.Resampling.BOX)
        off = np.linalg.norm(signed_error(scene, target, irradiance))
        error = float(off / np.linalg.norm(target_irradiance(scene, target)))
        width, height = self._size
        whole = Image.new("RGB", (width, height + _CAPTION), _GROUND)
        whole.paste(image)
        draw = ImageDraw.Draw(whole)
        at = _MARGIN, height + _CAPTION // 2
        draw.text(at, self._caption(iteration, error), _INK, self._font, anchor="lm")
        return whole
