"""Images on the receiver: irradiance, target and error.

A click pins a place; dragging with Shift, or with the tool in its bar, draws a line. By keys:
Enter pins the middle of what is seen. While regions are marked, `RegionTool` has the mouse.
"""

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QToolButton

from ui.shown.frame import same_task
from ui.views.image_link import ImageChoice, ImageLink, Place
from ui.views.image_view import ImageContent, ImageView
from ui.views.region_tool import RegionMarks, RegionTool
from ui.widgets import theme
from ui.words import begun, later, tr
from workbench.arrays import Array
from workbench.measured.lamps import light_unit
from workbench.pictures.axes import Extent
from workbench.pictures.images import ErrorImage, IrradianceImage, target_irradiance
from workbench.scene.viewing import inverted, pixel_side, side_in_words

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session
    from workbench.scene import Scene

_MARK = "#8a8f98"  # seen on light and dark
_DRAFT = {"color": "#4aa3df", "linewidth": 1.4, "linestyle": "--"}  # of a region
_NEAR = 6  # pixels from an edge that is taken hold of
_CROSS, _ARROW = Qt.CursorShape.CrossCursor, Qt.CursorShape.ArrowCursor
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class OnScreen:
    """Content of an image on the receiver."""

    def extent(self, session: "Session") -> Extent:
        """The whole receiver."""
        return Extent.of_receiver(session.scene)

    def unit(self, session: "Session") -> str:
        """Lux or candela, or relative flux per area or solid angle."""
        return light_unit(session.scene).short


class ScreenImageView(ImageView):
    """Image of the receiver, with the marks of cross-sections."""

    def __init__(self, content: ImageContent, link: ImageLink | None = None) -> None:
        super().__init__(content, link)
        self._marks: list[Any] = []
        self._regions: RegionMarks | None = None
        self._draws = False  # a line, with this drag
        self._icons: dict[QToolButton, str] = {}
        self._line_tool = self._add_tool(
            "cut-line",
            tr("Draw a line"),
            tr(
                "Drag across an image to draw the line of a cross-section; Shift and "
                "drag does so too"
            ),
        )
        self._line_tool.toggled.connect(self._link.set_drawing)
        self._hand = RegionTool(self._link)
        self._choice = ImageChoice(self._link)
        self._bottom.insertWidget(0, self._choice)

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        number = self._number(session)
        super()._draw(session.of_image(number), frame and frame.of_image(number))

    def _number(self, session: "Session") -> int:
        self._choice.show_scene(session.scene)
        return self._link.number_in(session.scene)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Pin a point by keys; while regions are marked, end one or leave."""
        if self._link.marking and event.key() == Qt.Key.Key_Escape:
            self._hand.leave()
        elif self._link.draft and event.key() in _ENTER:
            self._hand.close()
        elif event.key() in _ENTER and self._shown is not None:
            left, right, bottom, top = self._part()
            self._link.pinned.emit(((left + right) / 2, (bottom + top) / 2))
        else:
            super().keyPressEvent(event)

    def _at_rest(self, session: "Session") -> tuple[str, ...]:
        scene = session.scene
        side = begun(tr(side_in_words(scene, pixel_side(scene))))
        if not inverted(scene):
            return side, ""
        return tr("{side}: mirror-inverted").format(side=side), side, ""

    def _add_tool(self, icon: str, name: str, tip: str) -> QToolButton:
        tool = QToolButton()
        tool.setCheckable(True)
        tool.setAutoRaise(True)
        tool.setToolTip(tip)
        tool.setAccessibleName(name)
        tool.setIcon(theme.icon(icon, self.palette()))
        self._icons[tool] = icon
        self._bottom.addWidget(tool)
        return tool

    def _recolour(self) -> None:
        super()._recolour()
        for tool, icon in self._icons.items():
            tool.setIcon(theme.icon(icon, self.palette()))

    def _looks_alike(self, one: "Session", other: "Session") -> bool:
        seen = [
            (scene.receiver, scene.unit, scene.regions, light_unit(scene))
            for scene in (one.scene, other.scene)
        ]
        return seen[0] == seen[1] and one.target is other.target  # whatever lens and light are

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        artists = super()._begin(axes, session)
        look: dict[str, Any] = {"color": _MARK, "linewidth": 0.9, "visible": False}
        self._marks = [
            axes.axvline(0, linestyle="--", **look),
            axes.axhline(0, linestyle="--", **look),
            axes.plot([], [], marker="o", markersize=3, **look | {"linewidth": 1.4})[0],
            axes.plot([], [], marker="o", markersize=3, **look | _DRAFT)[0],
        ]
        self._regions = RegionMarks(axes, session.scene)
        return [*artists, *self._marks, *self._regions.artists]

    def _adapt(self) -> bool:
        everything = super()._adapt()
        link, (upright, level, line, draft) = self._link, self._marks
        self._line_tool.setChecked(link.drawing)
        self._canvas.setCursor(_CROSS if link.marking else _ARROW)
        for mark in (upright, level):
            mark.set_visible(link.pin is not None)
        line.set_visible(link.line is not None)
        draft.set_visible(bool(link.draft))
        if link.draft:
            draft.set_data(*zip(*link.draft, strict=True))
        if link.pin is not None:
            upright.set_xdata([link.pin[0]] * 2)
            level.set_ydata([link.pin[1]] * 2)
        if link.line is not None:
            line.set_data(*zip(*link.line, strict=True))
        return everything

    def _click(self, place: Place) -> None:
        if self._link.marking:
            self._hand.click(place)
        else:
            self._link.pinned.emit(place)

    def _press(self, event: Any) -> None:
        if self._link.marking and event.dblclick:
            self._hand.close()
            return
        super()._press(event)
        if self._grip is not None and self._link.marking:
            self._hand.press(self._marked_scene(), self._grip[1], self._margin())
        shift = event.guiEvent.modifiers() & Qt.KeyboardModifier.ShiftModifier
        self._draws = self._grip is not None and (self._link.drawing or bool(shift))

    def _drag(self, event: Any, start: Place) -> None:
        if self._link.marking:
            if event.inaxes is self._axes:
                self._hand.drag((event.xdata, event.ydata))
        elif not self._draws:
            super()._drag(event, start)
        elif event.inaxes is self._axes:
            self._link.show_line((start, (event.xdata, event.ydata)))

    def _drop(self) -> None:
        if self._link.marking:
            self._hand.drop()
        elif self._draws and self._link.line is not None:
            self._link.drawn.emit(self._link.line)

    def _marked_scene(self) -> "Scene":
        assert self._session is not None  # since there is a picture
        return self._session.of_image(self._number(self._session)).scene

    def _margin(self) -> Place:
        assert self._axes is not None
        box = self._axes.get_window_extent()
        left, right, bottom, top = self._part()
        near = _NEAR * self._canvas.device_pixel_ratio
        return near * (right - left) / box.width, near * (top - bottom) / box.height


class LightContent(OnScreen):
    """Irradiance or intensity, on a scale that follows the target."""

    image: IrradianceImage

    def __init__(self, values: "Callable[[Frame], Array]", name: str = "") -> None:
        self._name, self._light = name, values
        self._look = (False, "")  # logarithmic, colours

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Begin an empty image with the current scale and colours."""
        self.image = IrradianceImage(axes, session.scene, session.target, self._name)
        self._look = (False, "")
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the flux of a frame."""
        return self.image.update(self._light(frame))

    def values(self, frame: "Frame") -> Array:
        """Values of the image, in the scene's unit."""
        return self.image.values

    def set_look(self, logarithmic: bool, colours: str) -> bool:
        """Set scale and colours; return whether they changed."""
        if (logarithmic, colours) == self._look:
            return False
        self._look = (logarithmic, colours)
        self.image.set_logarithmic(logarithmic)
        self.image.set_colours(colours)
        return True


class LightImageView(ScreenImageView):
    """View of light with shared scale and colours."""

    _content: LightContent

    def __init__(self, content: LightContent, link: ImageLink | None = None) -> None:
        super().__init__(content, link)
        self._logarithmic = self._add_tool(
            "logarithmic",
            tr("Logarithmic colours"),
            tr("Logarithmic colours, over three decades: stray light is seen"),
        )
        self._logarithmic.toggled.connect(self._link.set_logarithmic)

    def _adapt(self) -> bool:
        everything, link = super()._adapt(), self._link
        self._logarithmic.setChecked(link.logarithmic)
        return self._content.set_look(link.logarithmic, link.colours) or everything


class IrradianceView(LightImageView):
    """View of the irradiance as computed by the optimiser."""

    def __init__(self, link: ImageLink | None = None) -> None:
        content = LightContent(lambda frame: frame.state.irradiance)
        super().__init__(content, link)

    def _change(self, frame: "Frame") -> bool:
        assert self._regions is not None  # since there is a picture
        self._regions.show_light(frame.state.irradiance)
        return super()._change(frame)


_TIP = later(
    "The target with as much light as arrives: where the irradiance is "
    "right, both have the same colour, however much light is lost on the "
    "way. The light account tells where that goes."
)


_SAME = 1e-3  # parts by which no eye can tell light from light


class TargetView(LightImageView):
    """The target as irradiance or intensity, with the flux that arrives."""

    def __init__(self, link: ImageLink | None = None) -> None:
        super().__init__(LightContent(_target, "target"), link)
        self._light = 0.0  # all of it, as drawn
        self.setToolTip(tr(_TIP))

    def show_frame(self, frame: "Frame") -> None:
        """Store another target or flux."""
        before, self._frame = self._frame, frame
        self._untraced = False
        light = _light(frame)
        same = before is not None and same_task(before.session, frame.session)
        if not same or abs(light - self._light) > _SAME * light:
            self._light = light
            self._ask()


def _light(frame: "Frame") -> float:
    return frame.session.scene.receiver.total(frame.state.irradiance) or 1.0


def _target(frame: "Frame") -> Array:
    session = frame.session
    return target_irradiance(session.scene, session.target, _light(frame))


class ErrorContent(OnScreen):
    """Irradiance minus target as shown: red is too much light, blue too little."""

    image: ErrorImage

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Begin an empty image."""
        self.image = ErrorImage(axes, session.scene, session.target)
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the error of a frame."""
        return self.image.update(frame.state.irradiance)

    def values(self, frame: "Frame") -> Array:
        """Values of the image, signed."""
        return self.image.values


class ErrorView(ScreenImageView):
    """View of the signed error."""

    def __init__(self, link: ImageLink | None = None) -> None:
        super().__init__(ErrorContent(), link)
