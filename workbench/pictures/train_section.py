"""Section through an optical train: outlines of all elements, a fan of rays, and the receiver."""

from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array
from workbench.design.session import Session, result_of
from workbench.geometry.face_grids import element_sides
from workbench.optics.paths import ray_paths
from workbench.pictures.camera import drawn_start_z
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

_SAMPLES = 201  # along each face
_RAYS = 21
_GLASS, _INK, _ARRIVING, _LOST = "#8fc1e8", "#475060", "#c47a00", "#c81e1e"
_FONT = 8
_BEYOND = 0.35  # of the train's length, that is shown behind it


def draw_train_section(figure: "FigureBase", session: Session) -> None:
    """Draw the train across y, or across x where elements stand aside or lean along x."""
    scene, axes = session.scene, figure.subplots()
    across = _plane(scene)
    heights = result_of(session).state.heights
    side, middle = np.linspace(-1, 1, _SAMPLES), np.zeros(1)
    u, v = (side, middle) if across == 0 else (middle, side)
    outlines = [
        [points.reshape(-1, 3)[:, [2, across]] for points in element_sides(element, u, v, heights)]
        for element in scene.elements
    ]
    for element, (front, back) in zip(scene.elements, outlines, strict=True):
        z, height = np.concatenate([front, back[::-1]]).T
        axes.fill(z, height, facecolor=_GLASS, edgecolor=_INK, alpha=0.6, linewidth=0.8)
        top = np.concatenate([front, back])
        place = top[top[:, 1].argmax()]
        axes.annotate(
            element.name,
            place,
            xytext=(0, 3),
            textcoords="offset points",
            fontsize=_FONT,
            ha="center",
        )
    _draw_rays(axes, session, across)
    corners = np.concatenate([points for sides in outlines for points in sides])
    start = drawn_start_z(scene)
    first, last = min(start, corners[:, 0].min()), corners[:, 0].max()
    ends = [receiver.outline(scene.elements[-1])[..., 2] for receiver in scene.receivers]
    behind = min(last + _BEYOND * (last - first), max(float(each.max()) for each in ends))
    gap = 0.05 * (behind - first)
    axes.set_xlim(first - gap, max(behind, last) + gap)
    low, high = corners[:, 1].min(), corners[:, 1].max()
    axes.set_ylim(low - 0.1 * (high - low), high + 0.2 * (high - low))
    axes.set_aspect("equal")
    axes.set_xlabel(f"z ({scene.unit})", fontsize=_FONT)
    axes.set_ylabel(f"{'xy'[across]} ({scene.unit})", fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)


def _plane(scene: Scene) -> int:
    """The axis, x (0) or y (1), that is drawn upwards."""
    aside = any(element.position[0] or element.tilt[1] for element in scene.elements)
    return 0 if aside else 1


def _draw_rays(axes: "Axes", session: Session, across: int) -> None:
    count = (_RAYS, 1) if across == 0 else (1, _RAYS)
    paths = ray_paths(session.scene, result_of(session).state.heights, count)
    for points, arrives in zip(paths.points, paths.on_screen, strict=True):
        z, height = _projected(points, across)
        axes.plot(z, height, color=_ARRIVING if arrives else _LOST, linewidth=0.5, alpha=0.8)


def _projected(points: Array, across: int) -> Array:
    return np.asarray(points[:, [2, across]].T)
