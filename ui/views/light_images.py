"""Images on the receiver: irradiance, target and error.

A click or Enter pins a point; Shift and drag, or the line tool, draws a line. `RegionTool` takes
the mouse while regions are marked.
"""

from typing import Any

from matplotlib.axes import Axes
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QToolButton

from ui.document.frame import Frame, same_task
from ui.views.choices import ImageChoice
from ui.views.image_canvas import Touch
from ui.views.image_view import ImageView
from ui.views.region_tool import RegionTool
from ui.views.shared_view import Place, SharedView
from ui.widgets import theme
from ui.widgets.controls import named
from ui.words import capitalised, later, tr
from workbench.arrays import Array
from workbench.design.loss import relative_error
from workbench.extended.bound import percent
from workbench.files.session import Session
from workbench.measured.lamps import light_unit
from workbench.pictures.images import ErrorImage, IrradianceImage, suits_contours, target_irradiance
from workbench.pictures.regions import RegionMarks
from workbench.scene import Scene
from workbench.scene.image import side_in_words, viewed_from

_MARK = "#8a8f98"  # seen on light and dark
_DRAFT = {"color": "#4aa3df", "linewidth": 1.4, "linestyle": "--"}  # of a region
_NEAR = 6  # pixels from an edge that is taken hold of
_CROSS, _ARROW = Qt.CursorShape.CrossCursor, Qt.CursorShape.ArrowCursor
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class ScreenImageView(ImageView):
    """Image of the receiver, with the marks of cross-sections."""

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._marks: list[Any] = []
        self._regions: RegionMarks | None = None
        self._draws = False  # a line, with this drag
        self._icons: dict[QToolButton, str] = {}
        self._line_tool = self._add_tool(
            "cut-line",
            tr("Draw a line"),
            tr("Drag across an image to draw the line of a cross-section; or use Shift and drag"),
        )
        self._line_tool.toggled.connect(self._shared.draw_line)
        self._hand = RegionTool(self._shared)
        self._choice = ImageChoice(self._shared)
        self._bottom.insertWidget(0, self._choice)

    def _draw(self, session: Session, frame: Frame | None) -> None:
        super()._draw(*self._of_image(session, frame))

    def _number(self, session: Session) -> int:
        self._choice.show_scene(session.scene)
        return super()._number(session)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Pin a point by keys; while regions are marked, end one or leave."""
        if self._shared.now.marking and event.key() == Qt.Key.Key_Escape:
            self._hand.leave()
        elif self._shared.now.draft and event.key() in _ENTER:
            self._hand.close()
        elif event.key() in _ENTER and self._shown is not None:
            x, y = self._part().mean(axis=1).tolist()
            self._shared.pinned.emit((x, y))
        else:
            super().keyPressEvent(event)

    def _at_rest(self, session: Session) -> tuple[str, ...]:
        scene = session.scene
        return capitalised(tr(side_in_words(scene, viewed_from(scene)))), ""

    def _add_tool(self, icon: str, name: str, tip: str) -> QToolButton:
        tool = named(QToolButton(autoRaise=True), name, tip)
        tool.setCheckable(True)
        tool.setIcon(theme.icon(icon, self.palette()))
        self._icons[tool] = icon
        self._bottom.addWidget(tool)
        return tool

    def _recolour(self) -> None:
        super()._recolour()
        for tool, icon in self._icons.items():
            tool.setIcon(theme.icon(icon, self.palette()))

    def _looks_alike(self, one: Session, other: Session) -> bool:
        seen = [
            (scene.receiver, scene.unit, scene.regions, light_unit(scene))
            for scene in (one.scene, other.scene)
        ]
        return seen[0] == seen[1] and one.target is other.target  # whatever lens and light are

    def _begin(self, axes: Axes, session: Session) -> None:
        super()._begin(axes, session)
        look: dict[str, Any] = {"color": _MARK, "linewidth": 0.9, "visible": False}
        left, right, bottom, top = self._image.extent.bounds
        self._marks = [
            axes.plot([0, 0], [bottom, top], linestyle="--", **look)[0],
            axes.plot([left, right], [0, 0], linestyle="--", **look)[0],
            axes.plot([], [], marker="o", markersize=3, **look | {"linewidth": 1.4})[0],
            axes.plot([], [], marker="o", markersize=3, **look | _DRAFT)[0],
        ]
        self._regions = RegionMarks(axes, session.scene)

    def _shown_array(self, frame: Frame) -> Array:
        return frame.state.irradiance

    def _adapt(self) -> None:
        now, (upright, level, line, draft) = self._shared.now, self._marks
        self._line_tool.setChecked(now.drawing)
        self._canvas.setCursor(_CROSS if now.marking else _ARROW)
        for mark in (upright, level):
            mark.set_visible(now.pin is not None)
        line.set_visible(now.line is not None)
        draft.set_visible(bool(now.draft))
        if now.draft:
            draft.set_data(*zip(*now.draft, strict=True))
        if now.pin is not None:
            upright.set_xdata([now.pin[0]] * 2)
            level.set_ydata([now.pin[1]] * 2)
        if now.line is not None:
            line.set_data(*zip(*now.line, strict=True))
        super()._adapt()

    def _click(self, place: Place) -> None:
        if self._shared.now.marking:
            self._hand.click(place)
        else:
            self._shared.pinned.emit(place)

    def _press(self, touch: Touch) -> None:
        super()._press(touch)
        if self._shared.now.marking:
            near = _NEAR / self._canvas.scale
            self._hand.press(self._marked_scene(), touch.place, (near, near))
        self._draws = self._shared.now.drawing or touch.shift

    def _press_twice(self) -> None:
        if self._shared.now.marking:
            self._hand.close()
        else:
            super()._press_twice()

    def _drag(self, touch: Touch, start: Place) -> None:
        if self._shared.now.marking:
            if touch.inside:
                self._hand.drag(touch.place)
        elif not self._draws:
            super()._drag(touch, start)
        elif touch.inside:
            self._shared.show(line=(start, touch.place))

    def _drop(self) -> None:
        if self._shared.now.marking:
            self._hand.drop()
        elif self._draws and self._shared.now.line is not None:
            self._shared.drawn.emit(self._shared.now.line)

    def _marked_scene(self) -> Scene:
        assert self._session is not None  # since there is a picture
        return self._session.of_image(self._number(self._session)).scene


class LightImageView(ScreenImageView):
    """View of light with shared scale and colours, on a scale that follows the target."""

    _image: IrradianceImage
    _NAME = ""  # of the light, where it is not that of the receiver

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._logarithmic = self._add_tool(
            "logarithmic",
            tr("Logarithmic colours"),
            tr("Logarithmic colours over three decades, to see stray light"),
        )
        self._logarithmic.toggled.connect(self._shared.slot("logarithmic"))
        self._contours = self._add_tool(
            "contours", tr("Contours"), tr("Lines of equal light, with their values")
        )
        self._contours.clicked.connect(self._shared.slot("contours"))

    def _new_image(self, axes: Axes, session: Session) -> IrradianceImage:
        image = IrradianceImage(axes, session.scene, session.target, self._NAME)
        shown = self._shared.now.contours
        image.outlined = suits_contours(session.scene) if shown is None else shown
        image.set_logarithmic(self._shared.now.logarithmic)
        image.set_colours(self._shared.now.colours)
        return image

    def _adapt(self) -> None:
        self._logarithmic.setChecked(self._shared.now.logarithmic)
        self._contours.setChecked(self._image.outlined)
        super()._adapt()


class IrradianceView(LightImageView):
    """View of the irradiance as computed by the optimiser, which can be pinned."""

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._pin = self._add_tool(
            "pin",
            tr("Pin this image"),
            tr("Pin this image to compare others with it; again to remove it"),
        )
        self._pin.clicked.connect(lambda on: self._shared.pin_image(self._frame if on else None))

    def _adapt(self) -> None:
        self._pin.setChecked(self._shared.now.reference is not None)
        super()._adapt()

    def _change(self, frame: Frame) -> None:
        assert self._regions is not None  # since there is a picture
        self._regions.show_light(frame.state.irradiance)
        super()._change(frame)


class PinnedView(IrradianceView):
    """View of the pinned irradiance, whatever is designed meanwhile."""

    _NOTHING = later("Nothing is pinned. The pin below the image of light pins it.")
    _WAITING = _NOTHING

    def _differs(self, before: Frame | None, frame: Frame) -> bool:
        return False

    def show_outdated(self, outdated: bool) -> None:
        """Stay as it is: the image is of its own design."""

    def _draw(self, session: Session, frame: Frame | None) -> None:
        pinned = self._shared.now.reference
        super()._draw(session if pinned is None else pinned.session, pinned)

    def _options(self) -> tuple[object, ...]:
        return *super()._options(), self._shared.now.reference

    def _at_rest(self, session: Session) -> tuple[str, ...]:
        pinned = self._shared.now.reference
        if pinned is None:
            return ("",)
        error = percent(relative_error(pinned.state, pinned.session.target))
        text = tr("Pinned at iteration {count}, error {error}")
        return text.format(count=pinned.result.iterations, error=error), ""


_TIP = later(
    "The target, scaled to the flux that arrives: where the irradiance is right, both have the "
    "same colour. The light account shows where lost light goes."
)
_SAME = 1e-3  # relative change of the flux that is not visible


class TargetView(LightImageView):
    """The target as irradiance or intensity, with the flux that arrives; before a lens with all."""

    _NAME = "target"

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._flux = 0.0  # as drawn
        self.setToolTip(tr(_TIP))

    def _differs(self, before: Frame | None, frame: Frame) -> bool:
        flux = _flux(frame)
        same = before is not None and same_task(before.session, frame.session)
        if same and abs(flux - self._flux) <= _SAME * flux:
            return False
        self._flux = flux
        return True

    def _begin(self, axes: Axes, session: Session) -> None:
        super()._begin(axes, session)
        if self._frame is None:
            self._show_array(target_irradiance(session.scene, session.target, 1.0))

    def _why_empty(self, frame: Frame | None) -> str:
        return ""

    def _shown_array(self, frame: Frame) -> Array:
        return target_irradiance(frame.session.scene, frame.session.target, _flux(frame))


def _flux(frame: Frame) -> float:
    return frame.session.scene.receiver.total(frame.state.irradiance) or 1.0


class ErrorView(ScreenImageView):
    """View of irradiance minus target: red is too much light, blue too little."""

    def _new_image(self, axes: Axes, session: Session) -> ErrorImage:
        return ErrorImage(axes, session.scene, session.target)
