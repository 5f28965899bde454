"""Numbers behind a figure, as columns of a table."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.powers import without_power

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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
    (low_x, high_x), (low_y, high_y) = axes.get_xlim(), axes.get_ylim()
    across, down = (x >= low_x) & (x <= high_x), (y >= low_y) & (y <= high_y)
    x, y, values = x[across], y[down], values[np.ix_(down, across)]
    unit = without_power(axes.child_axes[0].get_ylabel())
    named = unit if unit.startswith(image.get_label()) else f"{image.get_label()} ({unit})"
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
