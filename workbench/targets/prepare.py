"""Target of a scene as light on the pixels of its receiver."""

from io import BytesIO
from pathlib import Path
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene import ImageTarget, Scene
from workbench.scene.image import as_viewed
from workbench.targets.colour import TONES, Tone
from workbench.targets.image import decode_picture, read_picture
from workbench.targets.picture import Picture
from workbench.targets.raster import coverage, put
from workbench.targets.shapes import draw

# Pixels of a drawn SVG per pixel of the receiver along its longer side; most pixels of a side.
_FINENESS, _FINEST = 4, 4096
_QUARTERS = {"none": 0, "left": 1, "around": 2, "right": 3}  # of a turn to the left


class DrawnLight(NamedTuple):
    """Target (n_y, n_x) on the receiver's pixels, with remarks on the image file.

    The light is finite, >= 0 and not all zero; row 0 at +y, column 0 at −x.
    """

    light: Array
    remarks: tuple[Message, ...] = ()


def load_target(scene: Scene, folder: Path, kept: bytes | None = None) -> Array:
    """Return the target image on the receiver's pixels; `draw_target` without remarks."""
    return draw_target(scene, folder, kept).light


def draw_target(scene: Scene, folder: Path, kept: bytes | None = None) -> DrawnLight:
    """Return the target image on the receiver's pixels.

    The picture is cropped, inverted, given its levels, turned, fitted into the receiver less the
    padding, or made to fill it, with its aspect kept, averaged over pixels by area, and blurred;
    light that the blur carries off the receiver is lost. Inversion and levels act within the
    picture, transparent areas included, and leave the border black. Only ratios matter: the
    brightest value of the picture is 1. All this is in the viewer's orientation; `as_viewed` then
    lays the image onto the receiver.

    `scene`: its target and receiver are used; `folder`: base of a relative image path; `kept`:
    content of the image file, used instead of the file. Returns the target, and remarks about its
    image file. Raises `Refused` if the image file is unusable or the target is black.
    """
    target, receiver = scene.target, scene.receiver
    inside = 1 - 2 * target.padding
    half_x, half_y = (inside * half_width for half_width in receiver.half_extent)
    side = min(_FINENESS * max(receiver.pixels), _FINEST)
    remarks: tuple[Message, ...] = ()
    if isinstance(target, ImageTarget):
        picture = _picture(target, folder / target.image, side, kept)
        light = put(picture.light, receiver, (half_x, half_y), target.fit)
        remarks = picture.remarks
    else:
        light = draw(target, receiver, inside)
        if target.invert:
            frame = [(-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y)]
            light = np.maximum(coverage(frame, receiver) - light, 0.0)
    if not light.any():
        small = Message("is too small to light any pixel of the screen; enlarge the shape")
        raise Refused("target", small)
    blurred = _blurred(light, target.blur) if target.blur else light
    return DrawnLight(as_viewed(scene, blurred), remarks)


def picture_aspect(target: ImageTarget, kept: bytes | None = None) -> float:
    """Return width over height of the cropped and turned picture; raise Refused if unusable.

    ``kept`` is the content of the file, used instead of the file.
    """
    rows, columns = cropped(stored_picture(target, kept).light, target.crop).shape
    aspect = float(columns / rows)
    return 1 / aspect if _QUARTERS[target.turn] % 2 else aspect


def stored_picture(target: ImageTarget, kept: bytes | None = None) -> Picture:
    """Return the picture of a file, before the crop; raise Refused if it is unusable.

    ``kept`` is the content of the file, used instead of the file.
    """
    return _read(target, Path(target.image), _FINEST // _FINENESS, kept)


def cropped(picture: Array, crop: tuple[float, float, float, float]) -> Array:
    """Return a view of a picture (rows, columns) without what a crop cuts away."""
    rows, columns = picture.shape
    left, top = (round(cut * n) for cut, n in zip(crop[:2], (columns, rows), strict=True))
    right, bottom = (round(cut * n) for cut, n in zip(crop[2:], (columns, rows), strict=True))
    left, top = min(left, columns - 1), min(top, rows - 1)
    return picture[top : max(rows - bottom, top + 1), left : max(columns - right, left + 1)]


def pixel_values(light: Array, target: ImageTarget, tone: Tone) -> Array:
    """Return the pixel values of light in [0, 1], inverted if the target asks for it."""
    values = tone.stored(light)
    return 1.0 - values if target.invert else values


def levelled(values: Array, target: ImageTarget, tone: Tone) -> Array:
    """Return the light in [0, 1] of pixel values after the levels of a target."""
    span = target.white - target.black
    return tone.light(np.clip((values - target.black) / span, 0.0, 1.0) ** (1 / target.gamma))


def _blurred(light: Array, sigma: float) -> Array:
    from scipy.ndimage import gaussian_filter  # slow import

    return np.asarray(gaussian_filter(light, sigma, mode="constant"))


def _read(target: ImageTarget, path: Path, side: int, kept: bytes | None) -> Picture:
    tone = TONES[target.tone]
    if kept is None:
        return read_picture(path, side, tone)
    return decode_picture(path, BytesIO(kept), side, tone)


def _picture(target: ImageTarget, path: Path, side: int, kept: bytes | None) -> Picture:
    picture = _read(target, path, side, kept)
    light = _bright_pixels(path, cropped(picture.light, target.crop), target, picture.tone)
    return picture._replace(light=np.rot90(light, _QUARTERS[target.turn]))


def _bright_pixels(path: Path, picture: Array, target: ImageTarget, tone: Tone) -> Array:
    if not picture.any():
        black = Message("'{path}' is black all over; some light is needed", path=path)
        raise Refused("target.image", black)
    picture = picture / picture.max()
    if not (target.invert or target.has_levels):
        return picture
    values = pixel_values(picture, target, tone)
    if not values.any():
        raise Refused(
            "target.invert",
            Message("true leaves '{path}', which is uniform, black all over", path=path),
        )
    light = levelled(values, target, tone)
    if not light.any():
        raise Refused(
            "target.black",
            Message("leaves '{path}' black all over; less leaves some light", path=path),
        )
    return light
