"""From the target in the scene to light on the pixels of the receiver."""

from io import BytesIO
from pathlib import Path
from typing import NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.said import Said
from workbench.scene import ImageTarget, Scene
from workbench.scene.viewing import as_viewed
from workbench.targets.coverage import coverage
from workbench.targets.image import decode_picture, read_picture
from workbench.targets.picture import Picture
from workbench.targets.raster import put
from workbench.targets.shapes import draw
from workbench.targets.tone import TONES, Tone

# Pixels of a drawn SVG for each of the screen, along its longer side; and in all, at most.
_FINENESS, _FINEST = 4, 4096
_QUARTERS = {"none": 0, "left": 1, "around": 2, "right": 3}  # of a turn to the left


class DrawnLight(NamedTuple):
    """A target on the pixels of the screen.

    Attributes
    ----------
    light : ndarray, shape (n_y, n_x)
        Finite, >= 0 and not all zero; row 0 at +y, column 0 at −x.
    remarks : tuple of Said
        What a person should know of the picture: that it is reduced, or says itself how bright
        its values are.
    """

    light: Array
    remarks: tuple[Said, ...] = ()


def load_target(scene: Scene, folder: Path, kept: bytes | None = None) -> Array:
    """Draw the target image on the pixels of the screen; `draw_target` without its remarks."""
    return draw_target(scene, folder, kept).light


def draw_target(scene: Scene, folder: Path, kept: bytes | None = None) -> DrawnLight:
    """Draw the target image on the pixels of the screen.

    The picture is cut and turned as the target says, fitted into the screen less the padding, or
    made to fill that, with its aspect kept, averaged over the screen's pixels by area, and blurred;
    light that the blur carries off the screen is lost. Inversion turns bright to dark within the
    picture, what is transparent included, and leaves the border around it black. Only ratios count:
    the brightest value of the picture is taken as 1. All of that is as the viewer shall see it; in
    the end it is laid onto the screen as `as_viewed` says.

    Parameters
    ----------
    scene : Scene
        Its target and screen are used.
    folder : Path
        Where a relative image path starts.
    kept : bytes, optional
        Content of the image file, which is not read then.

    Returns
    -------
    DrawnLight
        The target, and remarks about its image file.

    Raises
    ------
    Refused
        If the image file cannot be used or nothing is left that is bright.
    """
    target, receiver = scene.target, scene.receiver
    inside = 1 - 2 * target.padding
    half_x, half_y = (inside * half_width for half_width in receiver.half_extent)
    side = min(_FINENESS * max(receiver.pixels), _FINEST)
    remarks: tuple[Said, ...] = ()
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
        small = Said("is too small to light any pixel of the screen; enlarge the shape")
        raise Refused("target", small)
    blurred = _blurred(light, target.blur) if target.blur else light
    return DrawnLight(as_viewed(scene, blurred), remarks)


def picture_aspect(target: ImageTarget, kept: bytes | None = None) -> float:
    """Width over height of a picture as it lies on the screen: what is left of it, turned.

    Parameters
    ----------
    target : ImageTarget
        With the absolute name of its file.
    kept : bytes, optional
        Content of the file, which is not read then.

    Raises
    ------
    Refused
        If the file cannot be used.
    """
    rows, columns = _picture(target, Path(target.image), _FINEST // _FINENESS, kept).light.shape
    return float(columns / rows)


def _blurred(light: Array, sigma: float) -> Array:
    from scipy.ndimage import gaussian_filter  # late: it takes long to import

    return np.asarray(gaussian_filter(light, sigma, mode="constant"))


def _picture(target: ImageTarget, path: Path, side: int, kept: bytes | None) -> Picture:
    """An image file as it lies on the screen; its brightest value is 1."""
    tone = TONES[target.tone]
    if kept is None:
        picture = read_picture(path, side, tone)
    else:
        picture = decode_picture(path, BytesIO(kept), side, tone)
    cropped = _cropped(picture.light, target.crop)
    light = _bright_pixels(path, cropped, target.invert, picture.tone)
    return picture._replace(light=np.rot90(light, _QUARTERS[target.turn]))


def _cropped(picture: Array, crop: tuple[float, float, float, float]) -> Array:
    """What is left of a picture, in whole pixels and at least one, of what is not cut away."""
    rows, columns = picture.shape
    left, top = (round(cut * n) for cut, n in zip(crop[:2], (columns, rows), strict=True))
    right, bottom = (round(cut * n) for cut, n in zip(crop[2:], (columns, rows), strict=True))
    left, top = min(left, columns - 1), min(top, rows - 1)
    return picture[top : max(rows - bottom, top + 1), left : max(columns - right, left + 1)]


def _bright_pixels(path: Path, picture: Array, invert: bool, tone: Tone) -> Array:
    """Pixels of an image file scaled to a maximum of 1, inverted as they are stored on request."""
    if not picture.any():
        black = Said("'{path}' is black all over; some light is needed", path=path)
        raise Refused("target.image", black)
    picture = picture / picture.max()
    if invert:
        picture = tone.light(1.0 - tone.stored(picture))
        if not picture.any():
            raise Refused(
                "target.invert",
                Said("true leaves '{path}', which is uniform, black all over", path=path),
            )
    return picture
