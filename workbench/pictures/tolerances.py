"""The distribution of the error over perturbed lenses."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from workbench.pictures.numbers import write_numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_FONT = 8
_DPI = 150
_LINE, _NOMINAL, _MARK = "#2f86d1", "#d9822b", "#8a8f98"


def draw_errors(axes: "Axes", nominal: float, errors: Sequence[float]) -> None:
    """Draw which part of the lenses stays below an error.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Empty axes.
    nominal : float
        Relative L2 error of the lens that is not off.
    errors : sequence of float
        Those of the others; at least one.
    """
    ordered = 100 * np.sort(np.asarray(errors))
    parts = 100 * np.arange(1, ordered.size + 1) / ordered.size
    start = np.concatenate([ordered[:1], ordered])
    axes.step(start, np.concatenate([[0.0], parts]), where="post", color=_LINE, linewidth=1.5)
    axes.axvline(100 * nominal, color=_NOMINAL, linestyle="--", linewidth=1.2, label="as designed")
    for part in (50, 95):
        at = float(np.percentile(ordered, part))
        axes.axvline(at, color=_MARK, linestyle=":", linewidth=1.0, label=f"{part} %: {at:.2f} %")
    axes.set_ylim(0, 100)
    axes.set_xlabel("relative L2 error (%)", fontsize=_FONT)
    axes.set_ylabel("lenses up to there (%)", fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)
    write_numbers(axes, "x")
    axes.grid(visible=True, linewidth=0.6, alpha=0.35)
    axes.legend(loc="lower right", fontsize=_FONT)  # below the curve


def write_errors(path: Path | BinaryIO, nominal: float, errors: Sequence[float]) -> None:
    """Draw `draw_errors` as a PNG file.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6, 4), layout="constrained")
    draw_errors(figure.subplots(), nominal, errors)
    figure.savefig(path, dpi=_DPI, format="png")
