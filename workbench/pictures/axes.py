"""Matplotlib axes of pictures: maps, colour bars, tick labels, colours of the frame."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Self

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import Colormap, LinearSegmentedColormap, ListedColormap, to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import (
    FixedLocator,
    Formatter,
    LogLocator,
    MaxNLocator,
    ScalarFormatter,
)

from workbench.arrays import Array
from workbench.powers import power_of, with_power, without_power, written
from workbench.targets.colour import SRGB

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from workbench.scene import Scene


Direction = Literal["x", "y"]
_MOST_DECIMALS = 12
_SLACK = 1e-4  # rounding of tick labels, in parts of the axis
WITHIN, BEYOND = "#8fd9a8", "#b3261e"
"""Colours of areas within limits and beyond them, of very different brightness."""
SIGNED = "RdBu_r"
"""Colour map of signed values."""
AS_SEEN = "as seen"
"""Colour map of light in greys that a monitor shows as the light itself."""
UNSIGNED = ("inferno", "viridis", "cividis", AS_SEEN)
"""Colour maps of values from zero on, perceptually uniform, readable without red and green."""
FONT = 8
_DIGITS = 3  # of a coordinate
_ZERO = 1e-4  # of a rectangle, less than a pixel of it
_ROUNDING = 1e-9  # relative to the values
_SHOWN_PART = 0.995  # of all values; a few at an edge must not hide the rest
_ON_DARK = "signed on "  # prefix of a signed colour map's name, before the background
_BELOW, _ABOVE = "#6fb7ff", "#ff8f73"  # ends of that colour map, equally bright
_GREYS = 4096  # as many as a monitor tells apart in the dark

_seen = SRGB.stored(np.linspace(0, 1, _GREYS))
colormaps.register(ListedColormap(np.stack([_seen] * 3, -1).tolist(), name=AS_SEEN), force=True)


class TickLabels(Formatter):
    """Tick labels of a linear scale, as multiples of the scale's power of ten.

    A scale that ends at 0.00005 would have labels of seven digits. The axis label gives a power of
    ten instead, as in "height (10⁻⁶ mm)", and the ticks run from 0 to 50.
    """

    power = 0

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Format one number."""
        return self.format_ticks([x])[0]

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        """Format numbers with one count of decimals."""
        low, high = self.axis.get_view_interval()  # type: ignore[union-attr]
        ten = 10.0**self.power
        numbers, slack = np.asarray(values) / ten, _SLACK * abs(high - low) / ten
        fits = (n for n in range(_MOST_DECIMALS) if _rounding(numbers, n) <= slack)
        decimals = next(fits, _MOST_DECIMALS)
        rounded = numbers.round(decimals) + 0.0  # for zeros that would be written as -0
        return [self.fix_minus(f"{number:.{decimals}f}") for number in rounded]


def set_tick_labels(axes: "Axes", direction: Direction) -> None:
    """Set such tick labels on an axis, also for later limits; label the axis before."""
    axis = getattr(axes, f"{direction}axis")
    axis.set_major_formatter(TickLabels())
    axes.callbacks.connect(f"{direction}lim_changed", lambda _: _update_power(axis))
    _update_power(axis)


def set_bar_labels(bar: Any) -> None:
    """Set such tick labels on a vertical colour bar."""
    bar.formatter = TickLabels()
    bar.ax.callbacks.connect("ylim_changed", lambda _: _update_power(bar.ax.yaxis))
    _update_power(bar.ax.yaxis)


def _rounding(numbers: Array, decimals: int) -> float:
    return float(np.abs(numbers.round(decimals) - numbers).max(initial=0.0))


def _update_power(axis: Any) -> None:
    if isinstance(axis.get_major_formatter(), ScalarFormatter):  # a bar gets it with another norm
        axis.set_major_formatter(TickLabels())
    formatter, power = axis.get_major_formatter(), 0
    if isinstance(formatter, TickLabels):
        formatter.power = power = power_of(*axis.get_view_interval())
    axis.set_label_text(with_power(axis.get_label_text(), power))


class Extent(NamedTuple):
    """Rectangle of a map: bounds (left, right, bottom, top), their unit, names of both axes."""

    bounds: tuple[float, float, float, float]
    unit: str
    axes: tuple[str, str] = ("x", "y")

    @classmethod
    def around(cls, half_width: tuple[float, float], unit: str) -> Self:
        """Rectangle about the optical axis."""
        r_x, r_y = half_width
        return cls((-r_x, r_x, -r_y, r_y), unit)

    @classmethod
    def of_receiver(cls, scene: "Scene") -> Self:
        """Rectangle of a scene's receiver, in the receiver's coordinates."""
        receiver = scene.receiver
        return cls(receiver.bounds, receiver.measure.sign_in(scene.unit), receiver.axes)

    def label(self, axis: int) -> str:
        """Label of an axis: 0 to the right, 1 upwards."""
        return f"{self.axes[axis]} ({self.unit})"

    def in_words(self, axis: int, value: float) -> str:
        """One coordinate of a point, as in "x = 0.4 cm"."""
        return f"{self.axes[axis]} = {written(self._settled(axis, value), self.unit, _DIGITS)}"

    def number(self, axis: int, value: float) -> str:
        """One coordinate without name and unit."""
        return written(self._settled(axis, value), digits=_DIGITS)

    def _settled(self, axis: int, value: float) -> float:
        low, high = self.bounds[2 * axis : 2 * axis + 2]
        return 0.0 if abs(value) < _ZERO * (high - low) else value


class Map:
    """A map on axes of the caller that is drawn once and then updated.

    ``image``: that of matplotlib; ``values`` (n_y, n_x): what is shown, in ``unit`` and over
    ``extent``.
    """

    image: Any
    extent: Extent
    unit: str = ""
    values: Array | None = None


def map_image(
    axes: "Axes", name: str, extent: Extent, count: tuple[int, int], colours: str | Colormap
) -> Any:
    """Draw an image of zeros with labelled axes and return it.

    `axes`: empty axes; `name`: quantity; `extent`: rectangle; `count`: numbers of values along x
    and y; `colours`: colour map. The data of the picture are (n_y, n_x) with row 0 at +y.
    """
    image = axes.imshow(
        np.zeros(count[::-1]),
        cmap=colours,
        extent=extent.bounds,
        origin="upper",
        interpolation="nearest",
        label=name,
    )
    axes.set_xlabel(extent.label(0), fontsize=FONT, labelpad=2)
    axes.set_ylabel(extent.label(1), fontsize=FONT, labelpad=2)
    axes.tick_params(labelsize=FONT)
    set_round_ticks(axes)
    return image


def constant_value(values: Array, size: float) -> float | None:
    """Return the value of a map that is constant up to rounding; None for other maps.

    NaN is ignored. ``size`` is the typical magnitude of such values: differences far below it are
    rounding.
    """
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if high - low > _ROUNDING * max(size, abs(low), abs(high)):
        return None
    middle = (low + high) / 2
    return 0.0 if abs(middle) <= _ROUNDING * size else middle


def show_constant(image: Any, value: float, unit: str) -> None:
    """Show one value everywhere, with a colour bar that names only this value."""
    image.set_data(np.full(image.get_array().shape, value))
    image.set_clim(*sorted((0.0, 2 * value)) if value else (0.0, 1.0))
    bar = colour_bar(image.axes, image, f"{unit}, constant", "neither")
    power = power_of(value, value)
    bar.set_ticks([value], labels=[f"{value / 10.0**power:.6g}"])
    bar.set_label(with_power(f"{unit}, constant", power))


def colour_bar(axes: "Axes", image: Any, unit: str, extend: str) -> Any:
    """Draw and return the colour bar of an image, labelled by the unit of its values."""
    # Beside the image itself, not beside the slot that the image may not fill.
    beside = axes.inset_axes((1.05, 0.0, 0.055, 1.0))
    bar = axes.figure.colorbar(image, cax=beside, extend=extend)
    bar.set_label(unit, fontsize=FONT)
    bar.ax.tick_params(labelsize=FONT)
    set_bar_labels(bar)
    bar.outline.set_linewidth(0.6)
    return bar


def label_curves(axes: Axes, x: str, y: str) -> None:
    """Label both axes of curves and draw a grid."""
    axes.set_xlabel(x, fontsize=FONT, labelpad=2)
    axes.set_ylabel(y, fontsize=FONT, labelpad=2)
    axes.tick_params(which="both", labelsize=FONT)
    axes.grid(visible=True, which="major", linewidth=0.6, alpha=0.35)


def label_place(axes: "Axes", place: Sequence[float], text: str, across: str, down: str) -> Text:
    """Write a small text over an image; ``across`` and ``down``: which side of it the place is."""
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.6, "pad": 1.5}
    return axes.text(
        place[0], place[1], text, fontsize="x-small", clip_on=True, ha=across, va=down, bbox=box
    )


def set_round_ticks(axes: "Axes") -> None:
    """Set round ticks on both axes, as many as fit; label the axes before."""
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 5, 10], min_n_ticks=2))
    set_tick_labels(axes, "x")
    set_tick_labels(axes, "y")


def ticks_along(axis: Axis, most: int) -> list[tuple[float, str]]:
    """Return place and number of up to ``most`` round ticks of an axis, for other painters.

    A place is 0 at the start and 1 at the end of the axis, on whatever scale.
    """
    ends, locator = np.asarray(axis.get_view_interval()), axis.get_major_locator()
    logarithmic = axis.get_scale() == "log"
    if not isinstance(locator, FixedLocator):
        locator = LogLocator() if logarithmic else MaxNLocator(max(most, 1), steps=[1, 2, 5, 10])
    values = np.asarray(locator.tick_values(*ends))
    values = values[(values >= ends.min()) & (values <= ends.max())]
    numbers = (
        [written(value) for value in values.tolist()]
        if logarithmic
        else axis.get_major_formatter().format_ticks(values.tolist())
    )
    scale = axis.get_transform().transform
    start, end = scale(ends)
    places = (scale(values) - start) / (end - start)
    return list(zip(places.tolist(), numbers, strict=True))


def round_scale(largest: float) -> float:
    """Return the next of ... 0.1, 0.2, 0.5, 1, 2, 5 ... that is not below ``largest``."""
    if not largest > 0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(largest))
    return next(step * decade for step in (1, 2, 5, 10, 20) if step * decade >= largest)


def stable_scale(values: Array, scale: float) -> float:
    """Return a round upper end of a scale for magnitudes of values.

    The present ``scale`` stays unless magnitudes exceed it or fill less than a third of it.
    """
    largest = float(np.nanquantile(np.abs(values), _SHOWN_PART))
    return scale if 0 < scale / 3 <= largest <= scale else round_scale(largest)


def pixel_at(
    bounds: tuple[float, float, float, float], shape: tuple[int, ...], x: float, y: float
) -> tuple[int, int] | None:
    """Row and column of the pixel at a point of an image; None outside."""
    (left, right, bottom, top), (n_y, n_x) = bounds, shape
    column = math.floor((x - left) / (right - left) * n_x)
    row = math.floor((top - y) / (top - bottom) * n_y)
    return (row, column) if 0 <= row < n_y and 0 <= column < n_x else None


def paint(figure: Figure, ink: str, paper: str) -> None:
    """Recolour everything but the data; on a dark ground, signed colour maps are dark at zero."""
    figure.set_facecolor(paper)
    for axes in figure.findobj(Axes):
        _paint_axes(axes, ink, paper)


def _paint_axes(axes: Axes, ink: str, paper: str) -> None:
    axes.set_facecolor(paper)
    for axis in (axes.xaxis, axes.yaxis):
        axis.label.set_color(ink)
        axis.offsetText.set_color(ink)
        axis.set_tick_params(which="both", color=ink, labelcolor=ink)
    for text in (axes.title, *axes.texts):
        text.set_color(ink)
        box = text.get_bbox_patch()
        if box is not None:
            box.set_facecolor(paper)
    for image in axes.images:
        before = image.get_cmap()
        if before.name == SIGNED or before.name.startswith(_ON_DARK):
            colours = _signed_on(paper)
            if colours.name != before.name:
                red, green, blue, alpha = before.get_bad().tolist()
                image.set_cmap(colours.with_extremes(bad=(red, green, blue, alpha)))
    for spine in axes.spines.values():
        spine.set_edgecolor(ink)
    legend = axes.get_legend()
    if legend is not None and legend.get_frame_on():  # one without a frame has curves' colours
        legend.get_frame().set(facecolor=paper, edgecolor=paper)
        for text in legend.get_texts():
            text.set_color(ink)


def _signed_on(paper: str) -> Colormap:
    if sum(to_rgb(paper)) > 1.5:
        return colormaps[SIGNED]
    return LinearSegmentedColormap.from_list(_ON_DARK + paper, [_BELOW, paper, _ABOVE])


# Signs that not every reader of a table takes for what they are.
_PLAIN = str.maketrans({"²": "^2", "°": "deg", "×": "x", "−": "-", "(": "[", ")": "]"})


class Column(NamedTuple):
    """Column of a table: name with unit, values (m,), NaN where there is none."""

    name: str
    values: Array


def shown_data(figure: "Figure") -> list[Column]:
    """Return the visible data of a figure's first axes as columns of equal length.

    Artists are named by their labels; an artist without a label is left out. Curves with the same x
    share one column of x.
    """
    axes = figure.axes[0]
    if axes.images:
        return _image(axes, axes.images[0])
    curves = [line for line in axes.lines if not str(line.get_label()).startswith("_")]
    columns: list[Column] = []
    places: Array | None = None
    for curve in curves:
        x, y = (np.asarray(part, dtype=np.float64) for part in curve.get_data())
        if not x.size:
            continue
        if places is None or not np.array_equal(places, x):
            places = x
            columns.append(Column(_plain(axes.get_xlabel()), x))
        columns.append(Column(_plain(f"{curve.get_label()}: {axes.get_ylabel()}"), y))
    longest = max((column.values.size for column in columns), default=0)
    return [Column(name, _filled(values, longest)) for name, values in columns]


def _image(axes: "Axes", image: Any) -> list[Column]:
    values = np.ma.filled(image.get_array(), 0.0)
    left, right, bottom, top = image.get_extent()
    n_y, n_x = values.shape
    x = left + (np.arange(n_x) + 0.5) * ((right - left) / n_x)
    y = top - (np.arange(n_y) + 0.5) * ((top - bottom) / n_y)
    (low_x, high_x), (low_y, high_y) = sorted(axes.get_xlim()), axes.get_ylim()
    across, down = (x >= low_x) & (x <= high_x), (y >= low_y) & (y <= high_y)
    x, y, values = x[across], y[down], values[np.ix_(down, across)]
    unit = "".join(without_power(bar.get_ylabel()) for bar in axes.child_axes)
    named = unit if unit.startswith(image.get_label()) else f"{image.get_label()} ({unit})"
    named = named.removesuffix(" ()")
    return [
        Column(_plain(name), np.array(column, dtype=np.float64).ravel())
        for name, column in zip(
            (axes.get_xlabel(), axes.get_ylabel(), named),
            np.broadcast_arrays(x, y[:, None], values),
            strict=True,
        )
    ]


def _filled(values: Array, length: int) -> Array:
    return np.pad(values, (0, length - values.size), constant_values=np.nan)


def _plain(name: str) -> str:
    return without_power(name).translate(_PLAIN)
