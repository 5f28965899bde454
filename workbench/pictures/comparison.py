"""Comparison of two runs: irradiance on one scale, its difference, and the losses."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
from matplotlib.figure import Figure

from workbench.arrays import Array
from workbench.design.session import KeptRun, Session
from workbench.measured.lamps import LightUnit, light_unit
from workbench.messages import Message
from workbench.pictures.axes import (
    FONT,
    SIGNED,
    UNSIGNED,
    Extent,
    colour_bar,
    pixel_at,
    stable_scale,
)
from workbench.pictures.contours import Contours
from workbench.pictures.images import colours_for, full_scale, is_lighting, receiver_map
from workbench.pictures.loss import LossCourse, draw_courses
from workbench.powers import written
from workbench.scene import Scene, Unit
from workbench.scene.image import as_viewed
from workbench.targets.raster import averaged

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TITLE_LETTERS = 34


@dataclass(frozen=True, eq=False)
class RunImage:
    """One image of a run: target and irradiance (n_y, n_x) in a display unit."""

    name: str
    scene: Scene
    target: Array
    irradiance: Array
    unit: LightUnit
    top: float

    @classmethod
    def of(cls, run: KeptRun, unit: Unit) -> Self:
        """Return the image of a run with one image, lengths in a unit."""
        session = Session(run.scene, run.target, run.result).in_unit(unit)
        assert session.result is not None
        scene, target, light = session.scene, session.target, session.result.state.irradiance
        light_in = light_unit(scene)
        top = light_in.density * full_scale(scene, target, scene.receiver.total(light))
        return cls(run.name, scene, target, light_in.density * light, light_in, top)

    def at(self, x: float, y: float) -> float | None:
        """Value at a point of the receiver; None outside."""
        pixel = pixel_at(self.scene.receiver.bounds, self.irradiance.shape, x, y)
        return None if pixel is None else float(self.irradiance[pixel])

    def in_words(self, x: float, y: float) -> str:
        """Value and unit at a point of the receiver; empty outside."""
        light = self.at(x, y)
        return "" if light is None else written(light, self.unit.words)


class Comparison:
    """Draws two runs on a figure of the caller, in the length unit of the first.

    Images of the same unit share one scale. The difference is second minus first, shape of the
    first, and None where the receivers cover different areas.
    """

    def __init__(self, figure: Figure, runs: tuple[KeptRun, KeptRun], number: int = 0) -> None:
        unit = runs[0].scene.unit
        one, other = (RunImage.of(run.of_image(number), unit) for run in runs)
        self.lights = one, other
        self.titles = _short(one.name), _short(other.name)
        self.difference = difference(one, other)
        figure.clear()
        figure.set_layout_engine("constrained")
        (first, second), (third, fourth) = figure.subplots(2, 2)
        alike = one.unit.words == other.unit.words
        top = max(one.top, other.top)
        self._places = dict(zip((first, second), self.lights, strict=True))
        for (axes, light), title in zip(self._places.items(), self.titles, strict=True):
            lines, scale = is_lighting(light.scene, light.target), top if alike else light.top
            colours = UNSIGNED[0] if lines else colours_for(light.scene)
            image = receiver_map(axes, light.name, light.scene, colours)
            image.set_data(as_viewed(light.scene, light.irradiance))
            image.set_clim(0, scale)
            colour_bar(axes, image, light.unit.words, extend="max")
            if lines:
                Contours(axes, Extent.of_receiver(light.scene)).show(light.irradiance, scale)
            _title(axes, title)
        self._draw_difference(third)
        _title(fourth, Message("Loss"))
        draw_courses(
            fourth,
            [
                LossCourse(title, run.result.losses)
                for title, run in zip(self.titles, runs, strict=True)
            ],
        )

    def in_words(self, axes: "Axes | None", x: float, y: float) -> str:
        """Text for a point of one of the images; empty outside."""
        one, other = self.lights
        light = one if axes is not None and axes is self._third else self._places.get(axes)
        if light is None or light.at(x, y) is None:
            return ""
        extent = Extent.of_receiver(light.scene)
        if self.difference is None:
            value = light.in_words(x, y)
        else:
            first = one.in_words(x, y).removesuffix(f" {one.unit.words}")
            value = f"{first} → {other.in_words(x, y)}"
        place = {"x": extent.in_words(0, x), "y": extent.in_words(1, y)}
        return Message("{value} at {x}, {y}", value=value, **place)

    def _draw_difference(self, axes: "Axes") -> None:
        one, _ = self.lights
        self._third = axes
        _title(axes, Message("Second minus first"))
        if self.difference is None:
            axes.set_axis_off()
            why = Message("The receivers differ: no difference image.")
            at, middle = axes.transAxes, "center"
            axes.text(0.5, 0.5, why, fontsize=FONT, ha=middle, va=middle, transform=at)
            return
        image = receiver_map(axes, "difference", one.scene, SIGNED)
        image.set_data(as_viewed(one.scene, self.difference))
        scale = stable_scale(self.difference, 0.0)
        image.set_clim(-scale, scale)
        colour_bar(axes, image, one.unit.words, extend="both")


def difference(one: RunImage, other: RunImage) -> Array | None:
    """Return second minus first, shape of the first; None if the receivers differ."""
    receiver, second = one.scene.receiver, other.scene.receiver
    same_place = np.allclose(receiver.bounds, second.bounds, rtol=1e-9)
    if not same_place or one.unit.words != other.unit.words:
        return None
    return averaged(other.irradiance, one.irradiance.shape) - one.irradiance


def _short(name: str) -> str:
    return name if len(name) <= _TITLE_LETTERS else f"{name[: _TITLE_LETTERS - 1]}…"


def _title(axes: "Axes", text: str) -> None:
    axes.set_title(text, fontsize=FONT + 1)
