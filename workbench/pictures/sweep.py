"""Errors of the lenses of a sweep over the values of a field."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.pictures.numbers import write_numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from workbench.design.session import Checked

_FONT = 8


class Curve(NamedTuple):
    """Lenses along the values of a field.

    Attributes
    ----------
    name : str
        What they have in common; empty for nothing.
    values : sequence of str
        The field's, as they are typed.
    errors : sequence of Checked
        What the check of each lens found.
    """

    name: str
    values: Sequence[str]
    errors: "Sequence[Checked]"


def draw_sweep(axes: "Axes", title: str, curves: Sequence[Curve]) -> None:
    """Draw the verified error, with what 95 % of checks would find, over the values.

    Values that are no numbers stand side by side.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    title : str
        What the field is called.
    curves : sequence of Curve
        At least one, of at least one lens each.
    """
    texts = list(dict.fromkeys(value for curve in curves for value in curve.values))
    places = _places(texts)
    for curve in curves:
        at = np.array([places[value] for value in curve.values])
        error = np.array([found.relative_l2_corrected for found in curve.errors])
        low, high = np.array([found.relative_l2_corrected_interval for found in curve.errors]).T
        order = np.argsort(at)
        beside: Array = np.stack([error - low, high - error]).clip(min=0)
        axes.errorbar(
            at[order],
            100 * error[order],
            yerr=100 * beside[:, order],
            marker="o",
            markersize=4,
            linewidth=1.5,
            elinewidth=1.0,
            capsize=2,
            label=curve.name,
        )
    axes.set_ylim(bottom=0)
    axes.set_xlabel(title, fontsize=_FONT)
    axes.set_ylabel("verified error (%)", fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)
    if any(not _is_number(text) for text in texts):
        axes.set_xticks(list(places.values()), texts)
    write_numbers(axes, "y")
    axes.grid(visible=True, linewidth=0.6, alpha=0.35)
    if any(curve.name for curve in curves):
        axes.legend(fontsize=_FONT)


def _places(texts: Sequence[str]) -> dict[str, float]:
    """Where values stand along the axis."""
    if all(map(_is_number, texts)):
        return {text: float(text) for text in texts}
    return {text: float(place) for place, text in enumerate(texts)}


def _is_number(text: str) -> bool:
    try:
        return bool(np.isfinite(float(text)))
    except ValueError:
        return False
