"""Curves of the error: over screen distance, over perturbed lenses, over the values of a field."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.axes import FONT, label_curves, set_round_ticks, set_tick_labels
from workbench.pictures.images import colours_for, full_scale
from workbench.scene import Scene
from workbench.scene.image import as_viewed

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

    from workbench.analysis.focus import Focus
    from workbench.analysis.making.robust import Compromise
    from workbench.design.session import Checked

_DPI = 150
_COLUMNS, _MOST = 6, 12  # images beside each other, and in all
_BLUE, _ORANGE, _GREY = "#2f86d1", "#d9822b", "#8a8f98"


def draw_focus(
    figure: "FigureBase", scene: Scene, target: Array, series: Sequence["Focus"]
) -> None:
    """Draw up to twelve images on one scale, and the error curve below."""
    chosen = np.unique(np.linspace(0, len(series) - 1, min(len(series), _MOST)).round().astype(int))
    rows = -(-chosen.size // _COLUMNS)
    columns = -(-chosen.size // rows)
    parts = figure.subfigures(2, 1, height_ratios=[rows, 1.5], squeeze=False)
    above, below = parts[:, 0]
    top = max(full_scale(scene, target, scene.receiver.total(one.irradiance)) for one in series)
    r_x, r_y = scene.receiver.half_extent
    panels = above.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels:
        axes.set_axis_off()
    colours = colours_for(scene)
    for axes, number in zip(panels, chosen, strict=False):
        image = series[number]
        axes.imshow(
            as_viewed(scene, image.irradiance),
            colours,
            vmin=0,
            vmax=top,
            extent=(-r_x, r_x, -r_y, r_y),
        )
        axes.set_title(f"z = {image.z:.6g} {scene.unit}", fontsize=FONT)
    _draw_curves(below.subplots(), scene, series)


def _draw_curves(axes: "Axes", scene: Scene, series: Sequence["Focus"]) -> None:
    z = [image.z for image in series]
    errors = [100 * image.relative_l2 for image in series]
    light = [100 * image.efficiency for image in series]
    axes.plot(z, errors, "o-", color=_BLUE, markersize=3, label="relative L2 error")
    axes.plot(z, light, "s--", color=_ORANGE, markersize=3, label="light on the screen")
    axes.axvline(scene.receiver.plane_z, color=_GREY, linestyle=":", linewidth=1, label="screen")
    axes.set_ylim(bottom=0)
    label_curves(axes, f"z of the screen ({scene.unit})", "%")
    set_tick_labels(axes, "x")
    set_tick_labels(axes, "y")
    axes.legend(loc="best", fontsize=FONT)


def write_focus(file: BinaryIO, scene: Scene, target: Array, series: Sequence["Focus"]) -> None:
    """Write `draw_focus` as PNG; raise OSError if that fails."""
    rows = -(-min(len(series), _MOST) // _COLUMNS)
    figure = Figure(figsize=(10, 1.9 * rows + 2.8), layout="constrained")
    draw_focus(figure, scene, target, series)
    figure.savefig(file, dpi=_DPI, format="png")


class FocusCurve:
    """Error against screen distance, on axes of the caller, with a mark at the shown one."""

    def __init__(self, axes: "Axes", scene: Scene, ends: tuple[float, float]) -> None:
        self._axes = axes
        axes.axvline(scene.receiver.plane_z, color=_GREY, linestyle=":", linewidth=1)
        (self.curve,) = axes.plot([], [], "o-", color=_BLUE, markersize=3, linewidth=1.2)
        self.mark = axes.axvline(scene.receiver.plane_z, color=_ORANGE, linewidth=1)
        axes.set_xlim(*ends)
        axes.set_ylim(0, 1)
        name = f"{Message('z of the screen')} ({scene.unit})"
        label_curves(axes, name, f"{Message('error')} (%)")
        set_round_ticks(axes)

    def update(self, errors: Sequence[tuple[float, float]], z: float) -> None:
        """Show errors as (z, relative L2 error) sorted by z, and the distance."""
        self.mark.set_xdata([z, z])
        self.curve.set_data([at for at, _ in errors], [100 * error for _, error in errors])
        self._axes.set_ylim(0, 110 * max((error for _, error in errors), default=1 / 110) or 1)


def draw_errors(axes: "Axes", nominal: float, errors: Sequence[float]) -> None:
    """Draw the distribution of relative L2 errors of perturbed lenses."""
    ordered = 100 * np.sort(np.asarray(errors))
    parts = 100 * np.arange(1, ordered.size + 1) / ordered.size
    start = np.concatenate([ordered[:1], ordered])
    axes.step(start, np.concatenate([[0.0], parts]), where="post", color=_BLUE, linewidth=1.5)
    axes.axvline(
        100 * nominal, color=_ORANGE, linestyle="--", linewidth=1.2, label=Message("as designed")
    )
    for part in (50, 95):
        at = float(np.percentile(ordered, part))
        axes.axvline(at, color=_GREY, linestyle=":", linewidth=1.0, label=f"{part} %: {at:.2f} %")
    axes.set_ylim(0, 100)
    label_curves(
        axes, f"{Message('relative L2 error')} (%)", f"{Message('lenses up to there')} (%)"
    )
    set_tick_labels(axes, "x")
    axes.legend(loc="lower right", fontsize=FONT)  # below the curve


def write_errors(path: Path | BinaryIO, nominal: float, errors: Sequence[float]) -> None:
    """Write `draw_errors` as PNG; raise OSError if that fails."""
    figure = Figure(figsize=(6, 4), layout="constrained")
    draw_errors(figure.subplots(), nominal, errors)
    figure.savefig(path, dpi=_DPI, format="png")


def draw_compromises(axes: "Axes", found: Sequence["Compromise"]) -> None:
    """Draw the mean error over what is uncertain against the error in the exact set-up."""
    exact, mean = (
        [100 * getattr(each.error, name) for each in found] for name in ("exact", "mean")
    )
    axes.plot(exact, mean, "o-", color=_BLUE, markersize=5, linewidth=1.5)
    for each, x, y in zip(found, exact, mean, strict=True):
        text = f"{100 * each.share:g} %"
        axes.annotate(text, (x, y), (6, 6), textcoords="offset points", fontsize=FONT)
    axes.margins(0.15)
    label_curves(
        axes,
        f"{Message('error in the exact set-up')} (%)",
        f"{Message('mean error over what is uncertain')} (%)",
    )
    set_tick_labels(axes, "x")
    set_tick_labels(axes, "y")
    axes.set_title("labels: part of the uncertainty that the design knew", fontsize=FONT)


def write_compromises(file: BinaryIO, found: Sequence["Compromise"]) -> None:
    """Write `draw_compromises` as PNG; raise OSError if that fails."""
    figure = Figure(figsize=(6, 4), layout="constrained")
    draw_compromises(figure.subplots(), found)
    figure.savefig(file, dpi=_DPI, format="png")


class Curve(NamedTuple):
    """Checks of the lenses of a sweep over the values of a field, with a common name."""

    name: str
    values: Sequence[str]
    errors: "Sequence[Checked]"


def draw_sweep(axes: "Axes", title: str, curves: Sequence[Curve]) -> None:
    """Draw the verified errors with 95 % intervals over the values of a field.

    Values that are not numbers are drawn at equal distances.
    """
    texts = list(dict.fromkeys(value for curve in curves for value in curve.values))
    positions = _positions(texts)
    for curve in curves:
        at = np.array([positions[value] for value in curve.values])
        error = np.array([image.relative_l2_corrected for image in curve.errors])
        low, high = np.array([image.relative_l2_corrected_interval for image in curve.errors]).T
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
    label_curves(axes, title, f"{Message('verified error')} (%)")
    if any(not _is_number(text) for text in texts):
        axes.set_xticks(list(positions.values()), texts)
    set_tick_labels(axes, "y")
    if any(curve.name for curve in curves):
        axes.legend(fontsize=FONT)


def _positions(texts: Sequence[str]) -> dict[str, float]:
    if all(map(_is_number, texts)):
        return {text: float(text) for text in texts}
    return {text: float(place) for place, text in enumerate(texts)}


def _is_number(text: str) -> bool:
    try:
        return bool(np.isfinite(float(text)))
    except ValueError:
        return False
