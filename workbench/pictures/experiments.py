"""One page with all experiments of the paper."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure, SubFigure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from workbench.arrays import Array
from workbench.geometry.faces import ControlHeights
from workbench.geometry.surface import sample_faces
from workbench.optics.paths import ray_paths
from workbench.pictures.derivative import DerivativeImage
from workbench.pictures.images import LIGHT, full_scale, signed_error, target_irradiance
from workbench.pictures.maps import SIGNED, round_scale
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.analysis.benchmark.experiments import Derivative, ExampleDesign

_FONT = 8
_BLOCKS = 2  # beside each other
_BLOCK = (8.2, 2.35)  # inches
_CURVES, _MAPS = 3.4, 4.0
_SAMPLES = 201
_RAYS = 25
_LANDS, _LOST = "#c47a00", "#c81e1e"
_STYLES = {"paper": "-", "auto": "--"}


def page(rows: Sequence["ExampleDesign | Derivative"]) -> Figure:
    """Loss curves, derivative maps, and of each lens image, error, height field and rays."""
    maps: list[Any] = [row for row in rows if hasattr(row, "map")]
    designs: list[Any] = [row for row in rows if not hasattr(row, "map")]
    heights = [
        2 * _CURVES if designs else 0,
        _MAPS if maps else 0,
        -(-len(designs) // _BLOCKS) * _BLOCK[1],
    ]
    figure = Figure(figsize=(_BLOCKS * _BLOCK[0], sum(heights)), layout="constrained")
    shown = [height for height in heights if height]
    parts = iter(figure.subfigures(len(shown), 1, height_ratios=shown, squeeze=False).flatten())
    if designs:
        _curves(next(parts), designs)
    if maps:
        _maps(next(parts), maps)
    if designs:
        _blocks(next(parts), designs)
    return figure


def _curves(part: SubFigure, designs: Sequence["ExampleDesign"]) -> None:
    """Loss over iterations, and below it over time, a column for each group of experiments."""
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
        said = f"{each.name}\nsum / flux moved {each.balance:.1e}"
        axes.set_title(said, fontsize=_FONT + 1)


def _blocks(part: SubFigure, designs: Sequence["ExampleDesign"]) -> None:
    rows = -(-len(designs) // _BLOCKS)
    blocks: Any = part.subfigures(rows, _BLOCKS, squeeze=False)
    for block, each in zip(blocks.flatten(), designs, strict=False):
        _block(block, each)


def _block(block: SubFigure, design: "ExampleDesign") -> None:
    said = f"{design.name}, {design.method}"
    if design.error is not None and design.efficiency is not None:
        said += f": verified error {design.error:.1%}, {design.efficiency:.0%} on the screen"
    block.suptitle(said, fontsize=_FONT + 1, x=0.01, ha="left")
    lit, off, sag, rays = block.subplots(1, 4, width_ratios=[1, 1, 1, 1.5])
    if design.result is None:
        for axes in (lit, off, sag, rays):
            axes.set_axis_off()
        lit.text(0, 0.5, design.failure, fontsize=_FONT, wrap=True, transform=lit.transAxes)
        return
    scene, target = design.scene, design.target
    # At a total flux of 1, as the target: how little light comes this way is written above.
    light = target_irradiance(scene, design.result.state.irradiance)
    _image(lit, scene, light, LIGHT, (0, full_scale(scene, target)))
    error = signed_error(scene, target, design.result.state.irradiance)
    most = round_scale(float(np.quantile(np.abs(error), 0.995)))
    _image(off, scene, error, SIGNED, (-most, most))
    off.set_title(f"error, ± {most:g}", fontsize=_FONT)
    lit.set_title("irradiance", fontsize=_FONT)
    _height_field(sag, scene, design.result.state.heights)
    _traced(rays, scene, design.result.state.heights)


def _image(axes: Axes, scene: Scene, image: Array, colours: str, ends: tuple[float, float]) -> None:
    r_x, r_y = scene.receiver.half_extent
    axes.imshow(image, cmap=colours, vmin=ends[0], vmax=ends[1], extent=(-r_x, r_x, -r_y, r_y))
    axes.set_xticks([])
    axes.set_yticks([])


def _height_field(axes: Axes, scene: Scene, heights: ControlHeights) -> None:
    """How far the exit face is from its base, with contours: the deviations are subtle."""
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
    for lands, colour in ((True, _LANDS), (False, _LOST)):
        some = paths.points[paths.on_screen == lands][:, :, [2, 0]]
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
