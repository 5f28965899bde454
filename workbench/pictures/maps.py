"""Values over a rectangle as an image with axes, and the scale of its colours."""

import math
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
from matplotlib.colors import Colormap
from matplotlib.ticker import MaxNLocator

from workbench.arrays import Array
from workbench.pictures.numbers import write_bar_numbers, write_numbers
from workbench.powers import power_of, with_power, written

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from workbench.scene import Scene

SIGNED = "RdBu_r"
"""Colours of values about zero."""
UNSIGNED = ("inferno", "viridis", "cividis", "gray")
"""Colours of values from zero on; perceptually uniform, and read without red and green."""

_FONT = 8
_DIGITS = 3  # of a coordinate
_NOTHING = 1e-4  # of a rectangle, less than a pixel of it
_ROUNDING = 1e-9  # of what values could be, or are
_ENOUGH = 0.995  # of all values; a few at an edge must not hide the rest


class Extent(NamedTuple):
    """The rectangle that a map covers.

    Attributes
    ----------
    bounds : tuple[float, float, float, float]
        Its left, right, bottom and top.
    unit : str
        Unit of these.
    axes : tuple[str, str]
        Names of what is counted to the right and upwards.
    """

    bounds: tuple[float, float, float, float]
    unit: str
    axes: tuple[str, str] = ("x", "y")

    @classmethod
    def around(cls, half_width: tuple[float, float], unit: str) -> Self:
        """A rectangle about the optical axis."""
        r_x, r_y = half_width
        return cls((-r_x, r_x, -r_y, r_y), unit)

    @classmethod
    def of_receiver(cls, scene: "Scene") -> Self:
        """What the receiver of a scene covers, in coordinates of its own."""
        receiver = scene.receiver
        return cls(receiver.bounds, receiver.measure.sign_in(scene.unit), receiver.axes)

    def label(self, axis: int) -> str:
        """Names an axis of a picture: 0 to the right, 1 upwards."""
        return f"{self.axes[axis]} ({self.unit})"

    def in_words(self, axis: int, value: float) -> str:
        """One coordinate of a place, as in "x = 0.4 cm"."""
        return f"{self.axes[axis]} = {written(self._settled(axis, value), self.unit, _DIGITS)}"

    def number(self, axis: int, value: float) -> str:
        """The same without name and unit."""
        return written(self._settled(axis, value), digits=_DIGITS)

    def _settled(self, axis: int, value: float) -> float:
        """The coordinate; 0 where it is next to nothing beside the rectangle, as in its middle."""
        low, high = self.bounds[2 * axis : 2 * axis + 2]
        return 0.0 if abs(value) < _NOTHING * (high - low) else value


def map_image(
    axes: "Axes", name: str, extent: Extent, count: tuple[int, int], colours: str | Colormap
) -> Any:
    """An image of zeros on axes that tell where its values are.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    name : str
        What its values are.
    extent : Extent
        The rectangle that it covers.
    count : tuple[int, int]
        Numbers of values along x and y.
    colours : str or Colormap
        Colours of its values.

    Returns
    -------
    matplotlib.image.AxesImage
        Of data of shape (n_y, n_x) with row 0 at +y.
    """
    image = axes.imshow(
        np.zeros(count[::-1]),
        cmap=colours,
        extent=extent.bounds,
        origin="upper",
        interpolation="nearest",
        label=name,
    )
    axes.set_xlabel(extent.label(0), fontsize=_FONT, labelpad=2)
    axes.set_ylabel(extent.label(1), fontsize=_FONT, labelpad=2)
    axes.tick_params(labelsize=_FONT)
    even_ticks(axes)
    return image


def constant_value(values: Array, size: float) -> float | None:
    """The one value of a map whose values differ by rounding alone; None for other maps.

    Parameters
    ----------
    values : ndarray
        What is to be shown; what is not a number, as beside a lens, is left out.
    size : float
        What such values could be: differences far below it are rounding, and so is a value itself.
    """
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if high - low > _ROUNDING * max(size, abs(low), abs(high)):
        return None
    middle = (low + high) / 2
    return 0.0 if abs(middle) <= _ROUNDING * size else middle


def show_constant(image: Any, value: float, unit: str) -> None:
    """Give an image one value everywhere, with a bar that names it and nothing else."""
    image.set_data(np.full(image.get_array().shape, value))
    image.set_clim(*sorted((0.0, 2 * value)) if value else (0.0, 1.0))
    bar = colour_bar(image.axes, image, f"{unit}, constant", "neither")
    power = power_of(value, value)
    bar.set_ticks([value], labels=[f"{value / 10.0**power:.6g}"])
    bar.set_label(with_power(f"{unit}, constant", power))


def colour_bar(axes: "Axes", image: Any, unit: str, extend: str) -> Any:
    """The scale of an image, named by the unit of its values."""
    # Beside the image itself, not beside the slot that the image may not fill.
    beside = axes.inset_axes((1.05, 0.0, 0.055, 1.0))
    bar = axes.figure.colorbar(image, cax=beside, extend=extend)
    bar.set_label(unit, fontsize=_FONT)
    bar.ax.tick_params(labelsize=_FONT)
    write_bar_numbers(bar)
    bar.outline.set_linewidth(0.6)
    return bar


def even_ticks(axes: "Axes") -> None:
    """Ticks of both axes, as many as there is room for; names of the axes come before."""
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 5, 10], min_n_ticks=2))
    write_numbers(axes, "x")
    write_numbers(axes, "y")


def round_scale(largest: float) -> float:
    """The next of ... 0.1, 0.2, 0.5, 1, 2, 5 ... that is not below ``largest``."""
    if not largest > 0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(largest))
    return next(step * decade for step in (1, 2, 5, 10, 20) if step * decade >= largest)


def settled_scale(values: Array, scale: float) -> float:
    """A round end of a scale from zero on, or about zero, that does not change all the time.

    It stays unless magnitudes leave it or fill less than a third of it.

    Parameters
    ----------
    values : ndarray
        What is to be shown.
    scale : float
        End of the scale so far.
    """
    largest = float(np.nanquantile(np.abs(values), _ENOUGH))
    return scale if 0 < scale / 3 <= largest <= scale else round_scale(largest)


def pixel_at(
    bounds: tuple[float, float, float, float], shape: tuple[int, ...], x: float, y: float
) -> tuple[int, int] | None:
    """Row and column of an image of this shape at a place; None beside it."""
    (left, right, bottom, top), (n_y, n_x) = bounds, shape
    column = math.floor((x - left) / (right - left) * n_x)
    row = math.floor((top - y) / (top - bottom) * n_y)
    return (row, column) if 0 <= row < n_y and 0 <= column < n_x else None
