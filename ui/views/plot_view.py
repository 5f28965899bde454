"""A view with one matplotlib canvas."""

from abc import abstractmethod
from typing import TYPE_CHECKING, Any, BinaryIO

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QGridLayout, QWidget

from ui.shown.frame import same_task
from ui.views.canvas import PlotCanvas
from ui.views.view import View
from ui.widgets.plot_words import translate, translate_axes
from ui.widgets.wrapped_label import WrappedLabel
from ui.words import later, tr
from workbench.pictures.axes import Column, shown_data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class PlotView(View):
    """Holds a canvas with a plot of one design."""

    touched = Signal()

    _HAS_BAR = True
    _WAITING = later("The first picture of this design comes in a moment.")
    _NO_ROOM = later("There is too little room here for a picture.")
    _NOTHING = later("There is no picture of this design: its light cannot be traced.")

    def __init__(self) -> None:
        super().__init__()
        self._canvas = PlotCanvas(self, bar=self._HAS_BAR)
        self._canvas.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._canvas.installEventFilter(self)
        self.setFocusProxy(self._canvas)
        self._box.addWidget(self._canvas, 1)
        self._hint = WrappedLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self._hint.setMargin(self.fontMetrics().height())
        self._hint.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._untraced = False
        self._over = QGridLayout(self._canvas)
        self._over.setContentsMargins(2, 2, 2, 2)
        self._over.addWidget(self._hint, 0, 0)
        self._shown: Session | None = None
        self._anew = True
        self._roomy = True

    @property
    def empty(self) -> bool:
        """Whether nothing is shown yet."""
        axes = self._canvas.figure.axes
        return not axes or not axes[0].get_visible()

    def offer(self, actions: "Sequence[QAction]") -> None:
        """Add actions to the menu of the plot."""
        self._canvas.addActions(actions)

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the picture as "png" or "svg"."""
        self._canvas.write(file, format)

    def data(self) -> list[Column]:
        """Data of the plot."""
        return shown_data(self._canvas.figure)

    def figures(self) -> dict[str, Any] | None:
        """Figures of the plot, for JSON; None if there are only its data."""
        return None

    def show_frame(self, frame: "Frame") -> None:
        """Show a frame of a run or a preview."""
        self._untraced = False
        super().show_frame(frame)

    def show_nothing(self, session: "Session") -> None:
        """Show a design without a frame."""
        self._untraced = True
        super().show_nothing(session)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Emit when the canvas gets the focus, and follow its size."""
        if event.type() == QEvent.Type.FocusIn:
            self.touched.emit()
        if event.type() == QEvent.Type.Resize and self._canvas.roomy is not self._roomy:
            self._roomy = self._canvas.roomy
            self._ask()
        return super().eventFilter(watched, event)

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        anew = frame is None or self._anew
        if anew or self._shown is None or not self._looks_alike(self._shown, session):
            self._canvas.animate(self._begin(self._canvas.begin(), session))
            translate(self._canvas.figure)
            self._anew = False
        self._shown = session
        everything = self._explain(self._why_empty(frame) or self._why_small()) | self._adapt()
        if frame is not None:
            everything |= self._change(frame)
        if everything:
            translate_axes(self._canvas.figure)
        self._canvas.show_changes(everything)

    def _begin_anew(self) -> None:
        self._anew = True
        self._ask()

    def _add_in_corner(self, widget: QWidget) -> None:
        self._over.addWidget(
            widget, 0, 0, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom
        )

    def _explain(self, why_empty: str) -> bool:
        (axes,) = self._canvas.figure.axes
        shown = not why_empty
        self._hint.setText(why_empty)
        changed = axes.get_visible() is not shown
        axes.set_visible(shown)
        return changed

    def _recolour(self) -> None:
        self._canvas.recolour()

    def _why_empty(self, frame: "Frame | None") -> str:
        if frame is not None:
            return ""
        return tr(self._NOTHING if self._untraced else self._WAITING)

    def _why_small(self) -> str:
        return "" if self._roomy else tr(self._NO_ROOM)

    def _looks_alike(self, one: "Session", other: "Session") -> bool:
        return same_task(one, other)

    @abstractmethod
    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]": ...

    def _adapt(self) -> bool:
        return False

    @abstractmethod
    def _change(self, frame: "Frame") -> bool: ...
