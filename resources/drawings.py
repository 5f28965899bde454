"""Target images that are drawn by hand-written code: a photograph-like one, a letter, a road."""

import numpy as np
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from workbench.arrays import Array
from workbench.scene import Screen
from workbench.targets.raster import paint

_LIGHT = np.array([-0.55, 0.65, 0.53])  # towards the lamp: upper left, in front
# Balls on a table: centre x, height above the table and depth; radius; grey; gloss.
_BALLS = (
    ((-0.38, 0.42, 0.10), 0.42, 0.85, 0.25),
    ((0.45, 0.30, 0.35), 0.30, 0.30, 0.90),
    ((0.10, 0.16, 0.75), 0.16, 0.60, 0.50),
)
_TABLE_Y, _HORIZON_Y = -0.60, 0.05  # of the balls' feet in the middle, and where the wall begins

_ROAD = 0.75, 0.35  # half of its length and width that are lit, in heights of the lamp


def photograph(size: int) -> Array:
    """Draw three balls on a table: smooth shades, texture, shadows, every grey from black to white.

    Parameters
    ----------
    size : int
        Pixels a side.

    Returns
    -------
    ndarray, shape (size, size)
        Values in [0, 1] that reach both ends.
    """
    centres = (np.arange(size) + 0.5) / size * 2 - 1
    x, y = np.meshgrid(centres, -centres)
    grain = _texture(size)
    wall = (0.50 - 0.22 * x + 0.18 * y) * (1 + 0.10 * grain)
    depth = (_HORIZON_Y - y) / (_HORIZON_Y - _TABLE_Y)  # 0 at the wall
    boards = 0.06 * np.sin(9 * np.pi * x / (1 + 0.8 * depth.clip(0)))
    table = (0.34 + 0.20 * depth - 0.12 * x + boards) * (1 + 0.20 * np.roll(grain, size // 3, 1))
    image = np.where(y > _HORIZON_Y, wall, table)
    for (centre, lift, near), radius, *_ in _BALLS:
        # The shadow falls to the right and a little backwards, and fades.
        across, along = x - centre - 0.75 * lift, y - _foot(near) - 0.12 * lift
        shade = np.exp(-(((across / (1.1 * radius)) ** 2 + (along / (0.30 * radius)) ** 2) ** 2))
        image = image * (1 - 0.75 * shade * (y < _HORIZON_Y))
    for (centre, lift, near), radius, grey, gloss in sorted(_BALLS, key=lambda ball: ball[0][2]):
        right, up = (x - centre) / radius, (y - _foot(near) - lift) / radius
        outside = right**2 + up**2
        toward = np.sqrt((1 - outside).clip(0))
        cosine = right * _LIGHT[0] + up * _LIGHT[1] + toward * _LIGHT[2]
        bounced = 0.10 * (1 - up) * (1 - toward**2)
        mirrored = (2 * cosine * toward - _LIGHT[2]).clip(0) ** 24
        lit = grey * (0.05 + 0.85 * cosine.clip(0) + bounced) * (1 + 0.06 * grain)
        cover = (0.5 + (1 - np.sqrt(outside)) * radius * size / 2).clip(0, 1)  # soft by a pixel
        image = image + cover * (lit + gloss * mirrored - image)
    image = image * (1 - 0.30 * (x**2 + y**2) / 2)
    # A few pixels may be clipped at either end, as in a photograph that is well exposed.
    dark, bright = np.quantile(image, [0.002, 0.998])
    return np.asarray(((image - dark) / (bright - dark)).clip(0, 1))


def letter(size: int) -> Array:
    """Draw a bold R, white on black: it shows at a glance which way an image lies.

    Parameters
    ----------
    size : int
        Pixels a side.

    Returns
    -------
    ndarray, shape (size, size)
        Fraction of each pixel inside the letter.
    """
    outline = TextPath(
        (0, 0), "R", size=1000, prop=FontProperties(family="DejaVu Sans", weight="bold")
    )
    # The last point of each is the first.
    polygons = [np.asarray(polygon)[:-1] for polygon in outline.to_polygons()]
    extents = outline.get_extents()
    low, high = np.asarray(extents.min), np.asarray(extents.max)
    scale = 1.5 / (high - low).max()
    body, hole = sorted(
        ((polygon - (low + high) / 2) * scale for polygon in polygons), key=np.ptp, reverse=True
    )
    screen = Screen(
        kind="plane", position=(0.0, 0.0, 1.0), half_width=(1.0, 1.0), pixels=(size, size)
    )
    return paint([(body, 1.0), (hole, -1.0)], screen)


def _foot(near: float) -> float:
    """Where on the picture a ball stands; the nearer to the viewer, the lower."""
    return _TABLE_Y + 0.30 - 0.55 * near


def _texture(size: int) -> Array:
    """Noise with detail of every size, mean 0, standard deviation 1; wraps around."""
    noise = np.random.default_rng(5).standard_normal((size, size))
    along = np.fft.fftfreq(size) * size
    waves = np.hypot(along[:, None], along[None, :])
    waves[0, 0] = np.inf
    texture = np.fft.ifft2(np.fft.fft2(noise) / waves**1.2).real
    return np.asarray(texture / texture.std())


def street(size: int) -> Array:
    """Intensity that lights a road evenly from a lamp that looks straight down on it.

    The picture covers 80° along the road and across. Illuminance is intensity times the cube of
    the cosine of the angle from the vertical, so intensity rises with that angle.

    Returns
    -------
    ndarray, shape (size, size)
        From 0 beside the road to 1 at its ends.
    """
    angles = np.radians(40.0) * ((np.arange(size) + 0.5) / size * 2 - 1)
    h, v = angles, -angles[:, None]
    onto_road = (np.abs(np.tan(h)) <= _ROAD[0]) & (np.abs(np.tan(v) / np.cos(h)) <= _ROAD[1])
    light = np.where(onto_road, (np.cos(v) * np.cos(h)) ** -3, 0.0)
    return np.asarray(light / light.max())
