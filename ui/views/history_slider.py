"""Slider over the history of a run."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSlider, QWidget

from ui.shown.frame import iterations_before
from ui.words import tr

if TYPE_CHECKING:
    from ui.shown.frame import Frame


class HistorySlider(QWidget):
    """Slider to earlier iterations; hidden until there are some."""

    frame_chosen = Signal(object)
    continued = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._frames: Sequence[Frame] = ()
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setAccessibleName(tr("Moment of the run"))
        self._slider.setToolTip(
            tr("Look back at the design and its light at any moment of the run")
        )
        self._slider.valueChanged.connect(self._look)
        self._slider.setMinimumWidth(4 * self._slider.sizeHint().height())  # with room to move
        self._text = QLabel()
        self._text.setMinimumWidth(
            self._text.fontMetrics().horizontalAdvance(
                tr("iteration {number}").format(number="00000")
            )
        )
        self._button = QPushButton(tr("Go on from here"))
        self._button.setToolTip(
            tr(
                "Take the design as it was at this moment, and continue from it; Undo "
                "brings the later one back"
            )
        )
        self._button.clicked.connect(lambda: self.continued.emit(self._frame))
        self._row = row = QHBoxLayout(self)
        row.setContentsMargins(8, 0, 8, 4)
        row.addWidget(self._slider, 1)
        row.addWidget(self._text)
        row.addWidget(self._button)
        self.hide()

    def show_frames(self, frames: "Sequence[Frame]") -> None:
        """Set the frames; the latest is the shown one."""
        self._frames = frames
        with QSignalBlocker(self._slider):
            self._slider.setMaximum(max(0, len(frames) - 1))
            self._slider.setValue(len(frames) - 1)
        self.setVisible(len(frames) > 1)
        self._tell()

    def allow(self, look: bool, go_on: bool) -> None:
        """Allow or forbid going back, and continuing from there."""
        self._slider.setEnabled(look)
        self._button.setEnabled(go_on)

    def minimumSizeHint(self) -> QSize:
        """Size without the text, which is also in the status bar."""
        whole = super().minimumSizeHint()
        return whole if self._text.isHidden() else whole - QSize(self._text_width, 0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show the text if there is space."""
        super().resizeEvent(event)
        least = self.minimumSizeHint().width()
        self._text.setVisible(self.width() >= least + self._text_width)

    @property
    def _text_width(self) -> int:
        text = max(self._text.minimumWidth(), self._text.minimumSizeHint().width())
        return text + self._row.spacing()

    @property
    def _frame(self) -> "Frame":
        return self._frames[self._slider.value()]

    def _look(self) -> None:
        self._tell()
        self.frame_chosen.emit(self._frame)

    def _tell(self) -> None:
        self._text.setText(
            tr("iteration {number}").format(number=iterations_before(self._frame))
            if self._frames
            else ""
        )
