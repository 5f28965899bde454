"""Figures of benchmarks."""

import math
import textwrap
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
import numpy.typing as npt
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure, SubFigure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from workbench.arrays import Array
from workbench.geometry.faces import ControlHeights
from workbench.geometry.surface import sample_faces
from workbench.optics.paths import ray_paths
from workbench.pictures.axes import SIGNED, round_scale
from workbench.pictures.images import (
    DerivativeImage,
    colours_for,
    full_scale,
    signed_error,
    target_irradiance,
)
from workbench.scene import Scene
from workbench.scene.image import as_viewed
from workbench.targets.colour import SRGB

if TYPE_CHECKING:
    from workbench.analysis.benchmark.bounds import BoundedDesign
    from workbench.analysis.benchmark.experiments import Derivative, ExampleDesign
    from workbench.analysis.benchmark.frontier import Course
    from workbench.analysis.benchmark.leds import LedDesign
    from workbench.analysis.benchmark.pictures import PictureDesign
    from workbench.analysis.benchmark.second_tracer import SeenTwice

_FONT = 8
_LETTERS = 16  # of that font, that an inch holds
_DPI = 130
_COLUMNS = 3
COLOURS = {
    "paper on torch": "#cbb8e4",
    "paper": "#8e6bbf",
    "transport": "#e0912f",
    "auto, before": "#9aa0a8",
    "auto": "#2f86d1",
}
_TRACED = (("difference", "o"), ("noise", "|"))
_ERRORS = (("sharp", "s"), ("bound", "|"), ("spots", "1"), ("light", "o"), ("lens", "^"))
_LIT = (("efficiency", "o"), ("merit", "^"), ("deviation", "|"))
_BLOCKS = 2  # beside each other
_BLOCK = (8.2, 2.35)  # inches
_CURVES_HEIGHT, _MAPS = 3.4, 4.0
_SAMPLES = 201
_RAYS = 25
_ARRIVING, _LOST = "#c47a00", "#c81e1e"
_STYLES = {"paper": "-", "auto": "--"}
_STRIP = (6.3, 2.4)  # inches, of three images beside each other
_GAP = 24  # of a strip, in parts of an image
_DIFFERENCE = 0.1  # end of the scale, in parts of the target's brightest pixel


def draw(name: str, rows: Sequence[Any], file: BinaryIO) -> None:
    """Draw the figure of a named benchmark with at least one row, and write it as PNG."""
    _DRAWN[name](rows).savefig(file, format="png", dpi=_DPI)


def courses(rows: Sequence["Course"]) -> Figure:
    """Draw the error over time, one panel per scene."""
    scenes = list(dict.fromkeys(row.scene for row in rows))
    figure, panels = _panels(len(scenes), width=4.2, height=3.2)
    for axes, scene in zip(panels, scenes, strict=True):
        axes.set_title(scene, fontsize=_FONT + 2)
        for row in rows:
            if row.scene == scene and row.times:
                colour = COLOURS.get(row.method)
                # The best lens so far stays until there is a better one.
                axes.plot(
                    row.times,
                    row.errors,
                    "o-",
                    ms=3,
                    lw=1.4,
                    drawstyle="steps-post",
                    color=colour,
                    label=row.method,
                )
                if row.own_curve:
                    axes.plot(*zip(*row.own_curve, strict=True), ".", ms=2, alpha=0.5, color=colour)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter(FuncFormatter(_per_cent))
        axes.yaxis.set_minor_formatter(FuncFormatter(_per_cent_of_1_2_5))
        axes.set_xlabel("seconds", fontsize=_FONT)
        axes.set_ylabel("verified error", fontsize=_FONT)
        axes.tick_params(which="both", labelsize=_FONT)
        axes.grid(which="both", linewidth=0.5, alpha=0.3)
        if axes.lines:
            axes.legend(fontsize=_FONT, frameon=False)
    text = (
        "Relative L2 error of the best lens so far. Lines: traced anew by other means; dots: own "
        "error of the run, after each iteration."
    )
    width = round(_LETTERS * figure.get_figwidth())
    figure.supxlabel(textwrap.fill(text, width), fontsize=_FONT)
    return figure


def bounds(rows: Sequence["BoundedDesign"]) -> Figure:
    """Draw errors of lenses beside their lower bounds, on one logarithmic scale."""
    return _marks(rows, _ERRORS, "relative L2 error")


def leds(rows: Sequence["LedDesign"]) -> Figure:
    """Draw the efficiency and the uniformity on a rectangle, on one logarithmic scale."""
    return _marks(rows, _LIT, "part of the light; relative deviation of the irradiance")


def tracers(rows: Sequence["SeenTwice"]) -> Figure:
    """Draw the difference of two tracers and its statistical noise."""
    return _marks(rows, _TRACED, "relative L2 difference")


def _marks(rows: Sequence[Any], kinds: Sequence[tuple[str, str]], label: str) -> Figure:
    figure = Figure(figsize=(7, 1.2 + 0.35 * len(rows)), layout="constrained")
    axes = figure.subplots()
    places = range(len(rows))
    for kind, mark in kinds:
        axes.plot([getattr(row, kind) for row in rows], places, mark, label=kind)
    axes.set_xscale("log")
    axes.set_yticks(places, [row.scene for row in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlabel(label, fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)
    axes.grid(linewidth=0.5, alpha=0.4)
    axes.legend(fontsize=_FONT)
    return figure


def _panels(count: int, width: float, height: float) -> tuple[Figure, list[Axes]]:
    columns = min(count, _COLUMNS)
    rows = math.ceil(count / columns)
    figure = Figure(figsize=(width * columns, height * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).flatten().tolist()
    for axes in panels[count:]:
        axes.remove()
    return figure, panels[:count]


def _per_cent(value: float, _: object) -> str:
    return f"{100 * value:.3g} %"


def _per_cent_of_1_2_5(value: float, _: object) -> str:
    leading = round(value / 10.0 ** math.floor(math.log10(value)))
    return _per_cent(value, None) if leading in (2, 5) else ""


def gallery(rows: Sequence["PictureDesign"]) -> Figure:
    """Draw target, verified image and difference of each picture, as a monitor shows light."""
    figure, panels = _panels(len(rows), *_STRIP)
    for axes, row in zip(panels, rows, strict=True):
        axes.set_axis_off()
        axes.imshow(_strip(row))
        cost = row.failure
        if row.check and row.run:
            cost = f"{row.error:.2%}, {row.seconds:.1f} s"
        axes.set_title(f"{row.scene}: {cost}", fontsize=_FONT + 3, loc="left")
    text = (
        "Target, image of the lens by the independent check, and image minus target at equal flux "
        f"(red: too much light, blue: too little; full colour at ± {_DIFFERENCE:.0%} of the "
        "brightest pixel of the target), with the relative L2 error of the image and the time of "
        "the whole design. Greys as on a monitor (sRGB)."
    )
    width = round(_LETTERS * figure.get_figwidth())
    figure.supxlabel(textwrap.fill(text, width), fontsize=_FONT)
    return figure


def _strip(row: "PictureDesign") -> npt.NDArray[np.uint8]:
    """Colours of target, image and difference beside each other, with white between them."""
    target = row.target / row.target.max()
    shown = [_greys(target)]
    if row.check is not None:
        image = row.check.irradiance * (target.sum() / row.check.irradiance.sum())
        off = (image - target) / (2 * _DIFFERENCE) + 0.5
        shown += [_greys(image), colormaps[SIGNED](off, bytes=True)[..., :3]]
    n_y, n_x = target.shape
    white = np.full((n_y, n_x // _GAP + 1, 3), 255, np.uint8)
    parts = [part for each in shown for part in (each, white)][:-1]
    return np.hstack(parts)


def _greys(light: Array) -> npt.NDArray[np.uint8]:
    grey = np.rint(255 * SRGB.stored(light.clip(0, 1))).astype(np.uint8)
    return np.repeat(grey[..., None], 3, axis=2)


def page(rows: Sequence["ExampleDesign | Derivative"]) -> Figure:
    """Draw loss curves, derivative maps, and image, error, heights and rays of each lens."""
    maps: list[Any] = [row for row in rows if hasattr(row, "map")]
    designs: list[Any] = [row for row in rows if not hasattr(row, "map")]
    heights = [
        2 * _CURVES_HEIGHT if designs else 0,
        _MAPS if maps else 0,
        -(-len(designs) // _BLOCKS) * _BLOCK[1],
    ]
    figure = Figure(figsize=(_BLOCKS * _BLOCK[0], sum(heights)), layout="constrained")
    shown = [height for height in heights if height]
    parts = iter(figure.subfigures(len(shown), 1, height_ratios=shown, squeeze=False).flatten())
    if designs:
        _loss_curves(next(parts), designs)
    if maps:
        _maps(next(parts), maps)
    if designs:
        _blocks(next(parts), designs)
    return figure


def _loss_curves(part: SubFigure, designs: Sequence["ExampleDesign"]) -> None:
    groups = list(dict.fromkeys(each.group for each in designs))
    panels: Any = part.subplots(2, len(groups), squeeze=False)
    for (over_iterations, over_time), group in zip(panels.T, groups, strict=True):
        members = [each for each in designs if each.group == group]
        names = list(dict.fromkeys(each.name for each in members))
        for each in members:
            if each.result is None or not each.result.iterations:
                continue
            losses = each.result.losses
            look: dict[str, Any] = {
                "ls": _STYLES.get(each.method, ":"),
                "lw": 1.2,
                "color": colormaps["tab10"](names.index(each.name) % 10),
                "label": f"{each.name}, {each.method}",
            }
            over_iterations.plot(np.arange(1, losses.size + 1), losses, **look)
            over_time.plot(each.times[-losses.size :], losses, **look)
        over_iterations.set_title(group, fontsize=_FONT + 2)
        for axes, name in ((over_iterations, "iteration"), (over_time, "seconds")):
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axes.yaxis.set_major_formatter(FuncFormatter(lambda loss, _: f"{loss:.0e}"))
            axes.yaxis.set_minor_formatter(NullFormatter())
            axes.set_xlabel(name, fontsize=_FONT)
            axes.set_ylabel("loss, as the optimiser sees it", fontsize=_FONT)
            axes.grid(which="both", linewidth=0.4, alpha=0.3)
            axes.tick_params(labelsize=_FONT)
        over_time.legend(fontsize=_FONT - 1, frameon=False, loc="lower left", ncols=2)


def _maps(part: SubFigure, maps: Sequence["Derivative"]) -> None:
    panels: Any = part.subplots(1, len(maps), squeeze=False)
    for axes, each in zip(panels.flatten(), maps, strict=True):
        DerivativeImage(axes, each.scene).update(each.map)
        text = f"{each.name}\nsum / flux moved {each.balance:.1e}"
        axes.set_title(text, fontsize=_FONT + 1)


def _blocks(part: SubFigure, designs: Sequence["ExampleDesign"]) -> None:
    rows = -(-len(designs) // _BLOCKS)
    blocks: Any = part.subfigures(rows, _BLOCKS, squeeze=False)
    for block, each in zip(blocks.flatten(), designs, strict=False):
        _block(block, each)


def _block(block: SubFigure, design: "ExampleDesign") -> None:
    text = f"{design.name}, {design.method}"
    if design.error is not None and design.efficiency is not None:
        text += f": verified error {design.error:.1%}, {design.efficiency:.0%} on the screen"
    block.suptitle(text, fontsize=_FONT + 1, x=0.01, ha="left")
    lit, off, sag, rays = block.subplots(1, 4, width_ratios=[1, 1, 1, 1.5])
    if design.result is None:
        for axes in (lit, off, sag, rays):
            axes.set_axis_off()
        lit.text(0, 0.5, design.failure, fontsize=_FONT, wrap=True, transform=lit.transAxes)
        return
    scene, target = design.scene, design.target
    # At a total flux of 1, as the target: how little light comes this way is written above.
    light = target_irradiance(scene, design.result.state.irradiance)
    _image(lit, scene, light, colours_for(scene), (0, full_scale(scene, target)))
    error = signed_error(scene, target, design.result.state.irradiance)
    most = round_scale(float(np.quantile(np.abs(error), 0.995)))
    _image(off, scene, error, SIGNED, (-most, most))
    off.set_title(f"error, ± {most:g}", fontsize=_FONT)
    lit.set_title("irradiance", fontsize=_FONT)
    _height_field(sag, scene, design.result.state.heights)
    _traced(rays, scene, design.result.state.heights)


def _image(axes: Axes, scene: Scene, image: Array, colours: str, ends: tuple[float, float]) -> None:
    r_x, r_y = scene.receiver.half_extent
    seen = as_viewed(scene, image)
    axes.imshow(seen, cmap=colours, vmin=ends[0], vmax=ends[1], extent=(-r_x, r_x, -r_y, r_y))
    axes.set_xticks([])
    axes.set_yticks([])


def _height_field(axes: Axes, scene: Scene, heights: ControlHeights) -> None:
    optic = scene.optic
    x, y, z = np.moveaxis(
        sample_faces(optic, heights, (_SAMPLES, _SAMPLES))[optic.designed_face], -1, 0
    )
    rise = z - optic.base.height_at(x, y)
    axes.contourf(x, y, rise, levels=24, cmap="viridis")
    axes.contour(x, y, rise, levels=24, colors="k", linewidths=0.25)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_title(
        f"height − base\n{rise.min():.2g} … {rise.max():.2g} {scene.unit}", fontsize=_FONT
    )


def _traced(axes: Axes, scene: Scene, heights: ControlHeights) -> None:
    paths = ray_paths(scene, heights, (_RAYS, _RAYS))
    for arrives, colour in ((True, _ARRIVING), (False, _LOST)):
        some = paths.points[paths.on_screen == arrives][:, :, [2, 0]]
        axes.add_collection(LineCollection(list(some), colors=colour, linewidths=0.3, alpha=0.25))
    optic, screen_z, half_width = scene.optic, scene.receiver.plane_z, scene.receiver.half_extent[0]
    half_height = 1.15 * max(optic.half_width[0], half_width)
    axes.plot([screen_z, screen_z], [-half_width, half_width], "k", lw=1.5)
    faces = sample_faces(optic, heights, (_SAMPLES, 3))
    x, _, z = np.moveaxis(faces.pop(optic.designed_face)[:, 1], -1, 0)
    front = next((each[::-1, 1, 2] for each in faces.values()), np.full(len(z), optic.front_z))
    axes.plot([*z, *front, z[0]], [*x, *x[::-1], x[0]], color="#2f6f9f", lw=1.0)
    axes.set_ylim(-half_height, half_height)
    axes.set_xlim(paths.points[:, 0, 2].min(), screen_z + 0.02 * (screen_z - optic.front_z))
    axes.set_title(f"{_RAYS} × {_RAYS} rays, seen from the side", fontsize=_FONT)
    axes.tick_params(labelsize=_FONT - 1)


_DRAWN: dict[str, Callable[[Sequence[Any]], Figure]] = {
    "quick": courses,
    "frontier": courses,
    "pictures": gallery,
    "bound": bounds,
    "led": leds,
    "mitsuba": tracers,
    "trains": tracers,
    "paper": page,
}
