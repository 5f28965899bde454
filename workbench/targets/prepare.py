"""From the target in the scene to light on the pixels of the receiver."""

from io import BytesIO
from pathlib import Path

import numpy as np
import numpy.typing as npt
from scipy.sparse import csr_array

from workbench.errors import Refused
from workbench.scene import AnyReceiver, ImageTarget, Scene
from workbench.targets.coverage import coverage
from workbench.targets.image import decode_image, read_image
from workbench.targets.shapes import draw

Array = npt.NDArray[np.float64]

# Pixels of a drawn SVG for each of the screen, along its longer side; and in all, at most.
_FINENESS, _FINEST = 4, 4096


def load_target(scene: Scene, folder: Path, kept: bytes | None = None) -> Array:
    """Draw the target image on the pixels of the screen.

    The picture is fitted into the screen less the padding with its aspect kept, averaged over
    the screen's pixels by area, and blurred; light that the blur carries off the screen is lost.
    Inversion turns bright to dark within the picture, what is transparent included, and leaves
    the border around it black.
    Only ratios count: the brightest value of the picture is taken as 1.

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
    ndarray, shape (n_y, n_x)
        Finite, >= 0 and not all zero; row 0 at +y, column 0 at −x.

    Raises
    ------
    Refused
        If the image file cannot be used or nothing is left that is bright.
    """
    target, receiver = scene.target, scene.receiver
    inside = 1 - 2 * target.padding
    half_x, half_y = (inside * half_width for half_width in receiver.half_extent)
    if isinstance(target, ImageTarget):
        path, side = folder / target.image, min(_FINENESS * max(receiver.pixels), _FINEST)
        read = read_image(path, side) if kept is None else decode_image(path, BytesIO(kept), side)
        picture = _bright_pixels(path, read, target.invert)
        rows, columns = picture.shape
        scale = min(half_x / columns, half_y / rows)
        light = _resample(picture, (scale * columns, scale * rows), receiver)
    else:
        light = draw(target, receiver, inside)
        if target.invert:
            frame = [(-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y)]
            light = np.maximum(coverage(frame, receiver) - light, 0.0)
    if not light.any():
        raise Refused("target", "is too small to light any pixel of the screen; enlarge the shape")
    return _blurred(light, target.blur) if target.blur else light


def _blurred(light: Array, sigma: float) -> Array:
    from scipy.ndimage import gaussian_filter  # late: it takes long to import

    return np.asarray(gaussian_filter(light, sigma, mode="constant"))


def _bright_pixels(path: Path, picture: Array, invert: bool) -> Array:
    """Pixels of an image file scaled to a maximum of 1, inverted on request."""
    if not picture.any():
        raise Refused("target.image", f"'{path}' is black all over; some light is needed")
    picture /= picture.max()
    if invert:
        np.subtract(1.0, picture, out=picture)
        if not picture.any():
            raise Refused(
                "target.invert", f"true leaves '{path}', which is uniform, black all over"
            )
    return picture


def _resample(picture: Array, half_width: tuple[float, float], receiver: AnyReceiver) -> Array:
    """Average a picture that spans ±half_width on the receiver over its pixels."""
    (half_u, half_v), (u, v) = half_width, receiver.middle
    left, top = receiver.to_pixels(u - half_u, v + half_v)
    right, bottom = receiver.to_pixels(u + half_u, v - half_v)
    rows, columns = picture.shape
    down = _overlap(np.linspace(top, bottom, rows + 1), receiver.pixels[1])  # [n_y, rows]
    across = _overlap(np.linspace(left, right, columns + 1), receiver.pixels[0])  # [n_x, columns]
    light: Array = down @ picture @ across.T
    return light


def _overlap(edges: Array, count: int) -> csr_array:
    """Which fraction of the unit cells 0..count-1 each of the cells between ``edges`` covers."""
    cuts = np.union1d(edges, np.arange(count + 1))
    cuts = cuts[(cuts >= max(edges[0], 0)) & (cuts <= min(edges[-1], count))]
    start = cuts[:-1]
    pixels = start.astype(int)
    cells = np.searchsorted(edges, start, side="right") - 1
    return csr_array((np.diff(cuts), (pixels, cells)), shape=(count, len(edges) - 1))
